// Compares what the light sensors of robots read with rays that are tested one by one.

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/lights.h>
#include <argos3/testing/contract/sensors/scene.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace light_occluders_test {

using namespace argos;

namespace {

// far from the tangent of a sensor: either side of it may be right there
constexpr Real kGrazing = 1e-9;

CVector3 DrawPoint(CRandomStream& random, Real reach, Real maxZ) {
  return CVector3(random.Uniform(-reach, reach), random.Uniform(-reach, reach),
                  random.Uniform(0.0, maxZ));
}

std::string ObjectText(CRandomStream& random, int number, Real reach) {
  CVector3 place = DrawPoint(random, reach, 0.3);
  if (number % 3 == 0) {
    place.SetZ(0.0);
  }
  const CVector3 size(random.Uniform(0.02, 0.3), random.Uniform(0.02, 0.3),
                      random.Uniform(0.02, 0.4));
  const std::string id = "o" + std::to_string(number);
  const std::string pose = "<body position='" + ToText(place) + "' orientation='" +
                           ToText(random.Uniform(0.0, 360.0)) + "," +
                           (number % 5 == 0 ? "30" : "0") + ",0'/>";
  if (number % 2 == 0) {
    return "<cylinder id='" + id + "' radius='" + ToText(size.GetX()) + "' height='" +
           ToText(size.GetZ()) + "' movable='" + (number % 4 == 0 ? "true' mass='1" : "false") +
           "'>" + pose + "</cylinder>";
  }
  return "<box id='" + id + "' size='" + ToText(size) + "' movable='" +
         (number % 4 == 1 ? "true' mass='1" : "false") + "'>" + pose + "</box>";
}

// robots, solids of several kinds and heights, and lights level with the sensors, low and high
std::string MakeArena(CRandomStream& random, Real reach) {
  std::string xml;
  for (int i = 0; i < 12; ++i) {
    CVector3 place = DrawPoint(random, reach, 0.2);
    place.SetZ(i % 4 == 0 ? place.GetZ() : 0.0);
    xml += Robot(i % 3 == 0 ? "e-puck" : "foot-bot", "r" + std::to_string(i),
                 PoseText(place, random.Uniform(0.0, 360.0)));
  }
  for (int i = 0; i < 40; ++i) {
    xml += ObjectText(random, i, reach);
  }
  const Real heights[] = {0.06, 0.0, 0.1, 0.25, 0.5, 2.0};  // m
  for (int i = 0; i < 6; ++i) {
    CVector3 place = DrawPoint(random, reach, 0.0);
    place.SetZ(heights[i]);
    xml += LampText("l" + std::to_string(i), place, i == 4 ? 0.0 : 0.1);
  }
  return xml;
}

struct SCount {
  int Clear = 0, Occluded = 0;
};

// what a sensor reads of all lights, by single rays
Real ComputeReading(CEmbodiedEntity& body, const CVector3& position, const CVector3& direction,
                    const std::vector<CLightEntity*>& lights, SCount& count) {
  Real reading = 0.0;
  for (const CLightEntity* light : lights) {
    const CVector3 way = light->GetPosition() - position;
    if (light->GetIntensity() <= 0.0 || way.DotProduct(direction) < -kGrazing * way.Length()) {
      continue;
    }
    SEmbodiedEntityIntersectionItem hit;
    if (GetClosestEmbodiedEntityIntersectedByRay(hit, CRay3(position, light->GetPosition()),
                                                 body)) {
      ++count.Occluded;
      continue;
    }
    ++count.Clear;
    const Real ratio = light->GetIntensity() / way.Length();
    reading += ratio * ratio;
  }
  return std::min(reading, 1.0);
}

void CheckReadings(CRobotWorld& world, const std::string& robot, SCount& count) {
  auto& root = dynamic_cast<CComposableEntity&>(world.GetRobot(robot).GetRootEntity());
  auto& body = root.GetComponent<CEmbodiedEntity>("body");
  auto& sensors = root.GetComponent<CLightSensorEquippedEntity>("light_sensors");
  const std::vector<Real>& readings =
      world.GetSensor<CCI_LightSensor>(robot, "light").GetReadings();
  const SAnchor& anchor = body.GetOriginAnchor();
  const std::vector<SSensorRay>& rays = sensors.GetLayout().Rays;
  REQUIRE(readings.size() == rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    CAPTURE(robot, i);
    CVector3 position = rays[i].Offset;
    position.Rotate(anchor.Orientation);
    position += anchor.Position;
    CVector3 direction = rays[i].Direction;
    direction.Rotate(anchor.Orientation).Normalize();
    const Real expected = ComputeReading(body, position, direction,
                                         world.GetSpace().GetExtension<CLights>().Get(), count);
    // ten roundings of a number of the order of 1; a light more or less makes a larger difference
    CHECK_THAT(readings[i], Catch::Matchers::WithinAbs(expected, 1e-13));
  }
}

}  // namespace

TEST_CASE("light: sensors see the lights that single rays reach", "[contract][sensors]") {
  // in the wide arena lines cross many cells, in the narrow one few
  const Real reach = GENERATE(0.7, 2.5);  // m
  const bool isMoved = GENERATE(false, true);
  CAPTURE(reach, isMoved);
  CRandomStream random(1, "test", "light occluders", ToText(reach));
  SCount count;
  for (int trial = 0; trial < 4; ++trial) {
    SRobotExperiment experiment;
    experiment.Sensors = "<light implementation=\"default\"/>";
    experiment.Arena = MakeArena(random, reach);
    CRobotWorld world(experiment);
    world.Step();
    if (isMoved) {
      // in a tick without motion, small and wide bodies are found where they were put since
      for (const char* id : {"o1", "o2", "o5", "o12"}) {
        world.Get<CComposableEntity>(id).GetComponent<CEmbodiedEntity>("body").MoveTo(
            DrawPoint(random, 0.5, 0.1), CQuaternion());
      }
      for (int i = 0; i < 12; ++i) {
        world.GetRobot("r" + std::to_string(i)).Sense();
      }
    }
    for (int i = 0; i < 12; ++i) {
      CheckReadings(world, "r" + std::to_string(i), count);
    }
  }
  // both cases occur often
  CHECK(count.Clear > 200);
  CHECK(count.Occluded > 500);
}

}  // namespace light_occluders_test
