#include <argos3/core/utility/text/classic_locale.h>

#include <clocale>

namespace argos {

namespace {

/** Null if there is no memory for it. */
locale_t GetClassicLocale() {
  static const locale_t classic = newlocale(LC_ALL_MASK, "C", locale_t{});
  return classic;
}

}  // namespace

// null as an argument of uselocale() changes nothing
CClassicLocale::CClassicLocale() : m_previous(uselocale(GetClassicLocale())) {}

CClassicLocale::~CClassicLocale() {
  uselocale(static_cast<locale_t>(m_previous));
}

}  // namespace argos
