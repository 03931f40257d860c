#ifndef ARGOS3_TESTING_SUPPORT_COMMA_LOCALE_H
#define ARGOS3_TESTING_SUPPORT_COMMA_LOCALE_H

#include <filesystem>
#include <locale>
#include <string>

namespace argos {

/**
 * For its lifetime the process has a decimal comma and points between thousands, as a program that
 * embeds the simulator may have set: as the global C++ locale and, where it can be made, as the C
 * locale.
 */
class CCommaLocale {
 public:
  CCommaLocale();
  ~CCommaLocale();
  CCommaLocale(const CCommaLocale&) = delete;
  CCommaLocale& operator=(const CCommaLocale&) = delete;

  /** False if this machine has neither the C locale de_DE nor what makes it. */
  bool HasCLocale() const { return m_hasCLocale; }

 private:
  bool MakeCLocale();

  std::locale m_previous;
  std::string m_previousC;
  std::filesystem::path m_folder;
  bool m_hasCLocale = false;
};

}  // namespace argos

#endif
