#ifndef ARGOS3_CORE_UTILITY_TEXT_CLASSIC_LOCALE_H
#define ARGOS3_CORE_UTILITY_TEXT_CLASSIC_LOCALE_H

#include <argos3/core/utility/non_copyable.h>

#include <locale>
#include <sstream>
#include <string>

/**
 * @file Text that does not depend on the locale that an embedding program has set: decimal points,
 * no separators of thousands.
 */
namespace argos {

/** For its lifetime, the C functions that the calling thread calls (printf, strtod) use "C". */
class CClassicLocale : private CNonCopyable {
 public:
  CClassicLocale();
  ~CClassicLocale();

 private:
  void* m_previous;  // a locale_t
};

/** A std::ostringstream that ignores the global C++ locale. */
class CTextOutput : public std::ostringstream {
 public:
  CTextOutput() { imbue(std::locale::classic()); }
};

/** A std::istringstream that ignores the global C++ locale. */
class CTextInput : public std::istringstream {
 public:
  explicit CTextInput(const std::string& text) : std::istringstream(text) {
    imbue(std::locale::classic());
  }
};

}  // namespace argos

#endif
