#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_ERROR_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_CONFIGURATION_ERROR_H

#include <argos3/core/utility/errors/argos_exception.h>

#include <locale>
#include <sstream>
#include <string>

namespace argos {

/** An error in an experiment file, or in the use of its elements. */
class CConfigurationError : public CARGoSException {
 public:
  explicit CConfigurationError(const std::string& text) : CARGoSException(text), m_details(text) {}

  std::string m_details; /**< the text; users' code knows it by this name */
};

}  // namespace argos

/** As THROW_ARGOSEXCEPTION. */
#define THROW_CONFIGURATION_ERROR(message)                    \
  {                                                           \
    std::ostringstream configurationErrorText_;               \
    configurationErrorText_.imbue(std::locale::classic());    \
    configurationErrorText_ << message;                       \
    throw CConfigurationError(configurationErrorText_.str()); \
  }

#endif
