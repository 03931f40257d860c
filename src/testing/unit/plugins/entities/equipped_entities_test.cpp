// Wheels, propellers and proximity sensors as components of any robot.

#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/testing/unit/plugins/entities/component_checks.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace equipped_entities_test {

using namespace argos;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

struct SEquippedBody : SBareBody {
  CProximitySensorEquippedEntity Sensors{&Robot, "proximity_0"};
};

}  // namespace

TEST_CASE("wheels: values are stored in place", "[entities]") {
  CWheeledEntity wheels(nullptr, "wheels_0", 3);
  CHECK(wheels.GetTypeDescription() == "wheels");
  const Real* const velocities = wheels.GetWheelVelocities();
  wheels.SetWheel(1, CVector3(0.1, 0.2, 0.0), 0.05);
  const Real speeds[3] = {0.1, -0.2, 0.3};
  wheels.SetVelocities(speeds);
  CHECK(wheels.GetNumWheels() == 3);
  CHECK(wheels.GetWheelPosition(1) == CVector3(0.1, 0.2, 0.0));
  CHECK(wheels.GetWheelPositions()[1] == CVector3(0.1, 0.2, 0.0));
  CHECK(wheels.GetWheelRadius(1) == 0.05);
  CHECK(wheels.GetWheelRadia()[1] == 0.05);
  CHECK(wheels.GetWheelVelocity(2) == 0.3);
  CHECK(wheels.GetWheelVelocities() == velocities);
  CHECK(velocities[1] == -0.2);
  wheels.Reset();
  CHECK(velocities[1] == 0.0);
  CHECK(wheels.GetWheelRadius(1) == 0.05);
}

TEST_CASE("wheels: the speed of each wheel changes the digest", "[entities]") {
  CWheeledEntity wheels(nullptr, "wheels_0", 2);
  const UInt64 still = DigestOf(wheels);
  Real speeds[2] = {0.0, 1e-300};
  wheels.SetVelocities(speeds);
  CHECK(DigestOf(wheels) != still);
}

TEST_CASE("wheels: invalid values are refused", "[entities][errors]") {
  CWheeledEntity wheels(nullptr, "wheels_0", 2);
  CHECK_THROWS_WITH(wheels.SetWheel(2, CVector3(), 0.1),
                    Contains("no wheel 2") && Contains("0 to 1"));
  CHECK_THROWS_WITH(wheels.SetWheel(0, CVector3(), 0.0), Contains("radius") && Contains("> 0"));
  CHECK_THROWS_AS(wheels.GetWheelVelocity(2), CARGoSException);
  CHECK_THROWS_AS(wheels.GetWheelPosition(2), CARGoSException);
  CHECK_THROWS_AS(wheels.GetWheelRadius(2), CARGoSException);
  const Real good[2] = {1.0, 2.0};
  wheels.SetVelocities(good);
  const Real bad[2] = {3.0, std::numeric_limits<Real>::quiet_NaN()};
  CHECK_THROWS_WITH(wheels.SetVelocities(bad), Contains("wheel 1") && Contains("finite"));
  CHECK(wheels.GetWheelVelocity(0) == 1.0);
  CHECK_THROWS_AS(CWheeledEntity(nullptr, 0), CARGoSException);
}

TEST_CASE("quadrotor: stores its targets and control method", "[entities]") {
  CQuadRotorEntity quadrotor(nullptr, "quadrotor_0");
  CHECK(quadrotor.GetTypeDescription() == "quadrotor");
  CHECK(quadrotor.GetControlMethod() == CQuadRotorEntity::NO_CONTROL);
  quadrotor.SetPositionControlData({CVector3(1, 2, 3), CRadians(0.5)});
  quadrotor.SetSpeedControlData({CVector3(-1, -2, -3), CRadians(-7.0)});
  CHECK(quadrotor.GetPositionControlData().Position == CVector3(1, 2, 3));
  CHECK(quadrotor.GetPositionControlData().Yaw == CRadians(0.5));
  CHECK(quadrotor.GetSpeedControlData().Velocity == CVector3(-1, -2, -3));
  CHECK(quadrotor.GetSpeedControlData().RotSpeed == CRadians(-7.0));
  quadrotor.Reset();
  CHECK(quadrotor.GetPositionControlData().Position == CVector3());
  CHECK(quadrotor.GetPositionControlData().Yaw == CRadians());
  CHECK(quadrotor.GetSpeedControlData().Velocity == CVector3());
  CHECK(quadrotor.GetSpeedControlData().RotSpeed == CRadians());
}

TEST_CASE("quadrotor: a reset restores the control method of the start", "[entities]") {
  CQuadRotorEntity quadrotor(nullptr, "quadrotor_0");
  quadrotor.SetControlMethod(CQuadRotorEntity::POSITION_CONTROL);
  quadrotor.MarkStart();
  quadrotor.SetControlMethod(CQuadRotorEntity::SPEED_CONTROL);
  quadrotor.ReturnToStart();
  CHECK(quadrotor.GetControlMethod() == CQuadRotorEntity::POSITION_CONTROL);
}

TEST_CASE("quadrotor: targets and method change the digest", "[entities]") {
  CQuadRotorEntity quadrotor(nullptr, "quadrotor_0");
  std::vector<UInt64> digests = {DigestOf(quadrotor)};
  quadrotor.SetControlMethod(CQuadRotorEntity::SPEED_CONTROL);
  digests.push_back(DigestOf(quadrotor));
  quadrotor.SetPositionControlData({CVector3(0, 0, 1e-300), CRadians()});
  digests.push_back(DigestOf(quadrotor));
  quadrotor.SetPositionControlData({CVector3(), CRadians(1e-300)});
  digests.push_back(DigestOf(quadrotor));
  quadrotor.SetSpeedControlData({CVector3(), CRadians(1e-300)});
  digests.push_back(DigestOf(quadrotor));
  std::sort(digests.begin(), digests.end());
  CHECK(std::unique(digests.begin(), digests.end()) == digests.end());
}

TEST_CASE("quadrotor: targets that are NaN, infinite or too large are refused", "[entities]") {
  CQuadRotorEntity quadrotor(nullptr, "quadrotor_0");
  quadrotor.SetPositionControlData({CVector3(1, 2, 3), CRadians(0.5)});
  const Real bad = GENERATE(std::numeric_limits<Real>::quiet_NaN(),
                            -std::numeric_limits<Real>::infinity(), 1.1e9);
  CHECK_THROWS_WITH(quadrotor.SetPositionControlData({CVector3(0, bad, 0), CRadians()}),
                    Contains("\"quadrotor_0\": a target position (m) and yaw must be finite"));
  CHECK_THROWS_WITH(quadrotor.SetPositionControlData({CVector3(), CRadians(bad)}),
                    Contains("must be finite"));
  CHECK_THROWS_WITH(quadrotor.SetSpeedControlData({CVector3(0, 0, bad), CRadians()}),
                    Contains("a target velocity (m/s) and yaw rate"));
  CHECK_THROWS_WITH(quadrotor.SetSpeedControlData({CVector3(), CRadians(bad)}),
                    Contains("must be finite"));
  CHECK(quadrotor.GetPositionControlData().Position == CVector3(1, 2, 3));
  CHECK(quadrotor.GetSpeedControlData().Velocity == CVector3());
}

TEST_CASE("proximity component: rings and fans have the documented geometry", "[entities]") {
  SEquippedBody robot;
  SAnchor& origin = robot.Body.GetOriginAnchor();
  robot.Sensors.AddSensorRing(CVector3(0.1, 0.2, 0.3), 0.05, ToRadians(CDegrees(30.0)), 0.4, 4,
                              origin);
  robot.Sensors.AddSensorFan(CVector3(), 1.0, CRadians::ZERO, CRadians::PI_OVER_TWO, 2.0, 3,
                             origin);
  REQUIRE(robot.Sensors.GetNumSensors() == 7);
  for (int i = 0; i < 4; ++i) {
    const Real angle = (30.0 + 90.0 * i) * M_PI / 180.0;
    const CVector3 outward(std::cos(angle), std::sin(angle), 0.0);
    const auto& sensor = robot.Sensors.GetSensor(i);
    CHECK_THAT(Distance(sensor.Offset, CVector3(0.1, 0.2, 0.3) + outward * 0.05),
               WithinAbs(0.0, 1e-16));
    CHECK_THAT(Distance(sensor.Direction, outward * 0.4), WithinAbs(0.0, 1e-15));
    CHECK(&sensor.Anchor == &origin);
  }
  // at 0, 30 and 60 degrees
  CHECK_THAT(robot.Sensors.GetSensor(6).Direction.GetX(), WithinAbs(1.0, 1e-15));
}

TEST_CASE("proximity component: the bounding circle of a layout contains all rays", "[entities]") {
  CProximitySensorEquippedEntity::SLayout layout;
  layout.AddSensor(CVector3(0.1, 0.0, 0.2), CVector3(1.0, 0.0, 0.0), 0.5);
  CHECK(layout.Planar);
  layout.AddSensor(CVector3(-0.3, 0.2, 0.1), CVector3(-3.0, 4.0, 0.0), 0.5);
  CHECK(layout.Planar);
  for (const auto& ray : layout.Rays) {
    const CVector3 end = ray.Offset + ray.Direction;
    for (const CVector3& point : {ray.Offset, end}) {
      const Real distance =
          std::hypot(point.GetX() - layout.CenterX, point.GetY() - layout.CenterY);
      CHECK(distance <= layout.Reach * (1.0 + 1e-15));
    }
    CHECK_THAT(ray.Direction.Length(), WithinAbs(0.5, 1e-15));
  }
  layout.AddSensor(CVector3(), CVector3(1.0, 0.0, 0.1), 0.5);
  CHECK_FALSE(layout.Planar);
}

TEST_CASE("proximity component: enabling it enables its anchors", "[entities]") {
  SEquippedBody robot;
  SAnchor& arm = robot.Body.AddAnchor("arm", CVector3(0.1, 0.0, 0.0));
  robot.Sensors.AddSensor(CVector3(), CVector3::X, 1.0, arm);
  CHECK_FALSE(robot.Sensors.IsEnabled());
  CHECK(arm.InUseCount == 0);
  robot.Sensors.Enable();
  robot.Sensors.Enable();
  CHECK(arm.InUseCount == 1);
  robot.Sensors.Disable();
  CHECK(arm.InUseCount == 0);
}

TEST_CASE("proximity component: invalid values are refused", "[entities][errors]") {
  SEquippedBody robot;
  CheckRefusesEmptyRays(robot.Sensors, robot.Body.GetOriginAnchor());
  CHECK_THROWS_WITH(robot.Sensors.GetSensor(0), Contains("no sensor 0"));
}

}  // namespace equipped_entities_test
