#include <argos3/core/utility/text/classic_locale.h>

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/comma_locale.h>

#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>

namespace classic_locale_test {

using namespace argos;
using Catch::Contains;

namespace {

void Throw() {
  THROW_ARGOSEXCEPTION("found " << 1234567.5);
}

}  // namespace

TEST_CASE("locale: the test's locale has a decimal comma", "[core][locale]") {
  const CCommaLocale comma;
  std::ostringstream stream;
  stream << 1234.5;
  CHECK(stream.str() == "1.234,5");
  if (!comma.HasCLocale()) {
    WARN("this machine has no C locale with a decimal comma; only the C++ locale is tested");
    return;
  }
  char text[16];
  std::snprintf(text, sizeof text, "%.1f", 0.5);
  CHECK(std::string(text) == "0,5");
  {
    const CClassicLocale classic;
    std::snprintf(text, sizeof text, "%.1f", 0.5);
    CHECK(std::string(text) == "0.5");
    CHECK(std::strtod("0.5", nullptr) == 0.5);
  }
  CHECK(std::strtod("0,5", nullptr) == 0.5);
}

TEST_CASE("locale: numbers are read and written with a point, whatever the locale",
          "[core][locale]") {
  const CCommaLocale comma;
  CHECK(ToString(1234567) == "1234567");
  CHECK(ToString(1234.5) == "1234.5");
  CHECK(FromString<Real>("1234.5") == 1234.5);
  CHECK(FromString<UInt32>("1234567") == 1234567);
  Real numbers[3] = {};
  ParseValues<Real>("1.5,2.5,1234.5", 3, numbers, ',');
  CHECK(numbers[2] == 1234.5);
  CHECK(FromString<CVector3>("1.5,2.5,1234.5") == CVector3(1.5, 2.5, 1234.5));
  CHECK(ToString(CVector3(1.5, 2.5, 1234.5)) == "1.5,2.5,1234.5");
  CHECK(FromString<CRange<Real>>("0.5:1234.5").GetMax() == 1234.5);
  CHECK(ToString(CRange<Real>(0.5, 1234.5)) == "0.5:1234.5");
  CHECK(FromString<CQuaternion>("90,0,0") == CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  CHECK(FromString<CColor>("255,128,0,255") == CColor(255, 128, 0));
  CHECK_THROWS_WITH(Throw(), Contains("found 1.23457e+06"));
  LOG << "log " << 1234.5 << ' ' << 1234567 << std::endl;
  CHECK_THAT(TakeLog(), Contains("log 1234.5 1234567"));
}

TEST_CASE("locale: attributes are read and written with a point, whatever the locale",
          "[core][locale]") {
  const CCommaLocale comma;
  CConfigurationDocument document;
  document.Parse("<a number='1234.5' list='1.5,2.5,3.5' count='1234567'/>", "test");
  TConfigurationNode& node = document.GetRoot();
  Real number = 0.0;
  GetNodeAttribute(node, "number", number);
  CHECK(number == 1234.5);
  CVector3 list;
  GetNodeAttribute(node, "list", list);
  CHECK(list == CVector3(1.5, 2.5, 3.5));
  UInt32 count = 0;
  GetNodeAttribute(node, "count", count);
  CHECK(count == 1234567);
  SetNodeAttribute(node, "number", 5678.25);
  SetNodeAttribute(node, "count", 7654321);
  CHECK(node.GetAttribute("number") == "5678.25");
  CHECK(node.GetAttribute("count") == "7654321");
}

}  // namespace classic_locale_test
