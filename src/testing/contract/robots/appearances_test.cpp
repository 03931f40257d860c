// What is drawn of robots and objects.

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/testing/support/device_list.h>
#include <argos3/testing/support/golden_text.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/robot_world.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace argos::appearances_test {

namespace {

// with 5 digits: libraries may differ in the last ones of a cosine
std::string Rounded(std::initializer_list<Real> numbers) {
  std::string text;
  for (const Real number : numbers) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), " %.5g", std::abs(number) < 1e-12 ? 0.0 : number);
    text += digits.data();
  }
  return text;
}

std::string Describe(const SVisualPart& part) {
  constexpr std::array<const char*, 6> kKinds = {"box",    "cylinder", "cone",
                                                 "sphere", "ring",     "LED"};
  const CVector3& at = part.Position;
  const CQuaternion& turn = part.Orientation;
  const CVector3& size = part.Size;
  std::ostringstream text;
  text << kKinds.at(static_cast<size_t>(part.Kind)) << " at"
       << Rounded({at.GetX(), at.GetY(), at.GetZ()}) << " turned"
       << Rounded({turn.GetW(), turn.GetX(), turn.GetY(), turn.GetZ()}) << " size"
       << Rounded({size.GetX(), size.GetY(), size.GetZ()}) << " colour "
       << static_cast<int>(part.Color.GetRed()) << ' ' << static_cast<int>(part.Color.GetGreen())
       << ' ' << static_cast<int>(part.Color.GetBlue()) << ' '
       << static_cast<int>(part.Color.GetAlpha()) << ' ' << ToText(part.Material) << ' '
       << part.Anchor << ' ' << part.LED;
  return text.str();
}

std::string DescribeAll() {
  SRobotExperiment experiment;
  experiment.Media = MediaForDevices();
  experiment.Arena =
      Robot("foot-bot", "foot-bot", "position='0,0,0'") +
      Robot("e-puck", "e-puck", "position='1,0,0'") +
      Robot("eye-bot", "eye-bot", "position='0,1,0'") +
      RobotForDevices("pipuck", "pipuck", "0,2,0", "c") +
      "<box id='box' size='0.1,0.2,0.3' movable='true' mass='1'><body position='1,1,0'/></box>"
      "<box id='wall' size='0.1,0.2,0.3' movable='false'><body position='1,2,0'/></box>"
      "<cylinder id='cylinder' radius='0.1' height='0.3' movable='true' mass='1'>"
      "<body position='2,1,0'/></cylinder>"
      "<light id='light' position='0,0,1' orientation='0,0,0' color='yellow' intensity='1' "
      "medium='leds'/>"
      "<prototype id='prototype' movable='true'><body position='2,2,0'/><links ref='a'>"
      "<link id='a' geometry='box' size='0.1,0.2,0.3' mass='1' position='0,0,0'/>"
      "<link id='b' geometry='cylinder' radius='0.1' height='0.3' mass='1'/>"
      "<link id='c' geometry='sphere' radius='0.1' mass='1'/></links>"
      "<joints><joint id='ab' type='fixed'><parent link='a' position='0,0,0.3'/>"
      "<child link='b' orientation='0,90,0'/></joint>"
      "<joint id='bc' type='fixed'><parent link='b' position='0,0,0.3'/><child link='c'/></joint>"
      "</joints></prototype>";
  CRobotWorld world(experiment);
  std::string text;
  for (const char* id : {"foot-bot", "e-puck", "eye-bot", "pipuck", "box", "wall", "cylinder",
                         "light", "prototype"}) {
    const SAppearance* const appearance = world.GetSpace().GetEntity(id).GetAppearance();
    REQUIRE(appearance != nullptr);
    for (const SVisualPart& part : appearance->Parts) {
      text += std::string(id) + ": " + Describe(part) + '\n';
    }
  }
  return text;
}

}  // namespace

// After an intended change, ARGOS_RENEW_GOLDEN=1 contract_sensor_tests replaces the text; look at a
// picture of the robot before it is committed.
TEST_CASE("appearances: the parts of robots and objects are those in appearances.txt",
          "[contract][robots]") {
  CheckGoldenText(InSourceTree("src/testing/contract/robots/appearances.txt"), DescribeAll());
}

}  // namespace argos::appearances_test
