#include <argos3/core/simulator/visualization/appearance.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

namespace appearance_test {

using namespace argos;

TEST_CASE("appearance: names of materials are those of XML", "[core][visualization]") {
  for (std::size_t i = 0; i < static_cast<std::size_t>(EMaterial::Count); ++i) {
    const auto material = static_cast<EMaterial>(i);
    CHECK(MaterialFromText(ToText(material)) == material);
  }
  CHECK(ToText(EMaterial::Glass) == "glass");
  CHECK(SVisualPart().Material == EMaterial::Plastic);
  CHECK_THROWS_WITH(MaterialFromText("metall"),
                    Catch::Matchers::Contains("did you mean \"metal\""));
}

}  // namespace appearance_test
