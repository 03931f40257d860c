#include <argos3/core/utility/configuration/argos_exception.h>

namespace argos {

CARGoSException::CARGoSException(const std::string& what, std::exception* nested)
    : m_text("[FATAL] " + what) {
  if (nested != nullptr) {
    m_text += '\n';
    m_text += nested->what();
  }
}

// defined here so that the class has one type identity, in the core library
CARGoSException::~CARGoSException() noexcept = default;

}  // namespace argos
