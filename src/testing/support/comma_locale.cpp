#include <argos3/testing/support/comma_locale.h>

#include <unistd.h>

#include <clocale>
#include <cstdlib>

namespace argos {

namespace {

constexpr const char* kGerman = "de_DE.UTF-8";

class CCommaFacet : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

}  // namespace

CCommaLocale::CCommaLocale()
    : m_previous(std::locale::global(std::locale(std::locale::classic(), new CCommaFacet))),
      m_previousC(std::setlocale(LC_ALL, nullptr)),
      m_folder(std::filesystem::temp_directory_path() /
               ("argos_locale_" + std::to_string(getpid()))) {
  m_hasCLocale = std::setlocale(LC_ALL, kGerman) != nullptr || MakeCLocale();
}

CCommaLocale::~CCommaLocale() {
  std::setlocale(LC_ALL, m_previousC.c_str());
  std::locale::global(m_previous);
  std::error_code ignored;
  std::filesystem::remove_all(m_folder, ignored);
}

bool CCommaLocale::MakeCLocale() {
  std::filesystem::create_directories(m_folder);
  const std::string command =
      "localedef -i de_DE -f UTF-8 '" + (m_folder / kGerman).string() + "' >/dev/null 2>&1";
  // NOLINTNEXTLINE(cert-env33-c): the text is ours
  if (std::system(command.c_str()) != 0) {
    return false;
  }
  setenv("LOCPATH", m_folder.c_str(), 1);
  const bool made = std::setlocale(LC_ALL, kGerman) != nullptr;
  unsetenv("LOCPATH");
  return made;
}

}  // namespace argos
