// Light and ground sensors as components of any robot, and components that are made on demand.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/testing/support/robot_world.h>
#include <argos3/testing/unit/plugins/entities/component_checks.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace sensor_components_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

struct SEquippedBody : SBareBody {
  CLightSensorEquippedEntity Lights{&Robot, "light_0"};
  CGroundSensorEquippedEntity Ground{&Robot, "ground_0"};
};

}  // namespace

TEST_CASE("light sensor component: rings have the documented geometry", "[entities]") {
  SEquippedBody robot;
  SAnchor& origin = robot.Body.GetOriginAnchor();
  robot.Lights.AddSensorRing(CVector3(0.1, 0.2, 0.3), 0.05, ToRadians(CDegrees(30.0)), 0.4, 4,
                             origin);
  robot.Lights.AddSensor(CVector3(0.0, 0.0, 1.0), CVector3(0.0, 0.0, 5.0), 2.0, origin);
  REQUIRE(robot.Lights.GetNumSensors() == 5);
  CHECK(robot.Lights.GetTypeDescription() == "light_sensors");
  for (int i = 0; i < 4; ++i) {
    const Real angle = (30.0 + 90.0 * i) * M_PI / 180.0;
    const CVector3 outward(std::cos(angle), std::sin(angle), 0.0);
    const CLightSensorEquippedEntity::SSensor& sensor = robot.Lights.GetSensor(i);
    CHECK_THAT(Distance(sensor.Position, CVector3(0.1, 0.2, 0.3) + outward * 0.05),
               WithinAbs(0.0, 1e-15));
    CHECK_THAT(Distance(sensor.Direction, outward * 0.4), WithinAbs(0.0, 1e-15));
    CHECK(&sensor.Anchor == &origin);
  }
  CHECK(robot.Lights.GetSensor(4).Direction == CVector3(0.0, 0.0, 2.0));
}

TEST_CASE("ground sensor component: rings have the documented geometry", "[entities]") {
  SEquippedBody robot;
  SAnchor& origin = robot.Body.GetOriginAnchor();
  robot.Ground.AddSensor(CVector2(0.1, 0.2), CGroundSensorEquippedEntity::TYPE_BLACK_WHITE, origin);
  robot.Ground.AddSensorRing(CVector2(0.1, 0.2), 0.05, ToRadians(CDegrees(30.0)),
                             CGroundSensorEquippedEntity::TYPE_GRAYSCALE, 4, origin);
  REQUIRE(robot.Ground.GetNumSensors() == 5);
  CHECK(robot.Ground.GetTypeDescription() == "ground_sensors");
  CHECK(robot.Ground.GetSensors().size() == 5);
  CHECK(robot.Ground.GetSensor(0).Type == CGroundSensorEquippedEntity::TYPE_BLACK_WHITE);
  for (int i = 0; i < 4; ++i) {
    const Real angle = (30.0 + 90.0 * i) * M_PI / 180.0;
    const CGroundSensorEquippedEntity::SSensor& sensor = robot.Ground.GetSensor(1 + i);
    CHECK_THAT(sensor.Offset.GetX(), WithinAbs(0.1 + 0.05 * std::cos(angle), 1e-15));
    CHECK_THAT(sensor.Offset.GetY(), WithinAbs(0.2 + 0.05 * std::sin(angle), 1e-15));
    CHECK(sensor.Type == CGroundSensorEquippedEntity::TYPE_GRAYSCALE);
  }
}

TEST_CASE("sensor components: robots of a type share a layout until one of them changes it",
          "[entities]") {
  SEquippedBody a;
  SEquippedBody b;
  auto layout = std::make_shared<SGroundSensorLayout>();
  layout->AddSensor(CVector2(1.0, 2.0), SGroundSensorPlace::TYPE_GRAYSCALE);
  a.Ground.SetLayout(layout, {&a.Body.GetOriginAnchor()});
  b.Ground.SetLayout(layout, {&b.Body.GetOriginAnchor()});
  CHECK(&a.Ground.GetLayout() == layout.get());
  // reading a sensor does not change the layout
  CHECK(a.Ground.GetSensor(0).Offset == CVector2(1.0, 2.0));
  CHECK(&a.Ground.GetLayout() == layout.get());
  a.Ground.GetSensor(0).Type = CGroundSensorEquippedEntity::TYPE_BLACK_WHITE;
  CHECK(a.Ground.GetLayout().Places[0].Type == CGroundSensorEquippedEntity::TYPE_BLACK_WHITE);
  CHECK(&b.Ground.GetLayout() == layout.get());
  CHECK(layout->Places[0].Type == CGroundSensorEquippedEntity::TYPE_GRAYSCALE);
}

TEST_CASE("sensor components: enabling one enables its anchors", "[entities]") {
  SEquippedBody robot;
  SAnchor& arm = robot.Body.AddAnchor("arm", CVector3(0.1, 0.0, 0.0));
  robot.Lights.AddSensor(CVector3(), CVector3::X, 1.0, arm);
  robot.Ground.AddSensor(CVector2(), CGroundSensorEquippedEntity::TYPE_GRAYSCALE, arm);
  CHECK_FALSE(robot.Lights.IsEnabled());
  CHECK_FALSE(robot.Ground.IsEnabled());
  robot.Lights.Enable();
  robot.Ground.Enable();
  robot.Ground.Enable();
  CHECK(arm.InUseCount == 2);
  robot.Lights.Disable();
  robot.Ground.Disable();
  CHECK(arm.InUseCount == 0);
}

TEST_CASE("sensor components: invalid values are refused", "[entities][errors]") {
  SEquippedBody robot;
  CheckRefusesEmptyRays(robot.Lights, robot.Body.GetOriginAnchor());
  CHECK_THROWS_WITH(robot.Lights.GetSensor(0),
                    Contains("light_sensors") && Contains("no sensor 0"));
  CHECK_THROWS_WITH(robot.Ground.GetSensor(2),
                    Contains("ground_sensors") && Contains("no sensor 2"));
}

TEST_CASE("components: a look-up by type creates what robots make on demand, of that type only",
          "[entities]") {
  SRobotExperiment experiment;
  experiment.Arena = Robot("foot-bot", "a", "position='0,0,0'") +
                     Robot("foot-bot", "b", "position='1,0,0'") +
                     Robot("e-puck", "c", "position='2,0,0'");
  CRobotWorld world(experiment);
  const auto has = [&world](const std::string& id, const std::string& type) {
    const auto& components = world.Get<CComposableEntity>(id).GetExistingComponents();
    return std::any_of(components.begin(), components.end(), [&](const CEntity* component) {
      return component->GetTypeDescription() == type;
    });
  };
  CSpace& space = world.GetSpace();
  world.Get<CComposableEntity>("a").GetComponent("rab");
  CHECK_FALSE(has("b", "rab"));
  // a type of robots is no component of others
  CHECK(space.GetEntitiesByType("foot-bot").size() == 2);
  CHECK_FALSE(has("b", "rab"));
  CHECK(space.GetEntitiesByType("rab").size() == 3);
  CHECK(has("b", "rab"));
  CHECK_FALSE(has("b", "battery"));
  CHECK(space.GetEntitiesByType("battery").size() == 3);
  CHECK_FALSE(has("b", "light_sensors"));
}

}  // namespace sensor_components_test
