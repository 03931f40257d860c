// A crowd that presses: clusters that merge and split, large enough for several strips, with loads
// and grips in them, equal bit by bit for any number of threads, also after a reset.

#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

namespace argos::determinism_crowd_test {

using testing::MeasureOverlaps;
using testing::SOverlaps;
using testing::SRoomsWorld;

namespace {

/** "tugger": drives ahead, grips for some time what it meets, and drives back with it. */
class CTugger : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_gripper = GetActuator<CCI_FootBotGripperActuator>("footbot_gripper");
  }
  void Reset() override { m_step = 0; }
  void ControlStep() override {
    const UInt32 phase = m_step++ % 60;
    phase < 30 ? m_gripper->LockPositive() : m_gripper->Unlock();
    const Real speed = phase < 15 || phase >= 45 ? 8.0 : -8.0;
    m_wheels->SetLinearVelocity(speed, speed + (phase >= 45 ? 2.0 : 0.0));
  }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotGripperActuator* m_gripper = nullptr;
  UInt32 m_step = 0;
};

REGISTER_CONTROLLER(CTugger, "tugger")

// discs cover 30 % of the ground
std::string MakeCrowd(UInt32 threads, const std::string& method, bool withLoads) {
  CDynamicLoading::LoadLibrary(InBuildTree("experiments/libepuck_vector_diffusion"));
  SRoomsWorld rooms;
  rooms.Robots = 2800;
  rooms.Side = 6.0;
  rooms.RoomsPerSide = 2;
  rooms.DoorWidth = 0.8;
  rooms.Threads = threads;
  rooms.Method = method;
  rooms.Controller = "epuck_vector_diffusion_controller";
  std::string xml = rooms.ToXML();
  if (withLoads) {
    Replace(xml, "<controllers>",
            "<controllers><tugger id='tugger'><actuators><differential_steering "
            "implementation='default'/><footbot_gripper implementation='default'/></actuators>"
            "<sensors/><params/></tugger>");
    // the robots are placed around them
    std::string loads;
    for (int i = 0; i < 3; ++i) {
      const std::string number = std::to_string(i);
      loads += "<foot-bot id='t" + number + "'><body position='" + std::to_string(-2 + i) +
               ",1.5,0'/><controller config='tugger'/></foot-bot><cylinder id='c" + number +
               "' radius='0.06' height='0.1' mass='0.3' movable='true'><body position='" +
               std::to_string(-1.85 + i) + ",1.5,0'/></cylinder>";
    }
    Replace(xml, "<distribute>", loads + "<distribute>");
  }
  return xml;
}

}  // namespace

TEST_CASE("crowd determinism: every tick is equal for any number of threads, also after a reset",
          "[determinism][threads][crowd]") {
  const bool withLoads = GENERATE(false, true);
  CAPTURE(withLoads);
  constexpr UInt32 kTicks = FewerIfSanitized(80);
  CTestWorld alone(MakeCrowd(0, "balance_quantity", withLoads));
  const std::vector<UInt64> expected = RecordDigests(alone, kTicks);
  alone.GetSimulator().Reset();
  REQUIRE(RecordDigests(alone, kTicks) == expected);
  for (const UInt32 threads : MostIfSanitized({1U, 2U, 3U, 4U})) {
    for (const char* method : {"balance_quantity", "balance_length"}) {
      CAPTURE(threads, method);
      CTestWorld world(MakeCrowd(threads, method, withLoads));
      REQUIRE(RecordDigests(world, kTicks) == expected);
    }
  }
}

TEST_CASE("crowd determinism: the robots press without overlapping", "[determinism][crowd]") {
  const bool withLoads = GENERATE(false, true);
  CAPTURE(withLoads);
  CTestWorld world(MakeCrowd(0, "balance_quantity", withLoads));
  world.Step(FewerIfSanitized(60));
  SOverlaps overlaps;
  for (int i = 0; i < 10; ++i) {
    world.Step(FewerIfSanitized(10));
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);
  CHECK(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= 0.02);
  // a good part of them touches another one
  CHECK(overlaps.Touching.size() >= 3000);
}

TEST_CASE("no allocation: a tick of a crowd that presses allocates nothing",
          "[determinism][allocation][crowd]") {
  const UInt32 threads = GENERATE(0U, 2U);
  CAPTURE(threads);
  CTestWorld world(MakeCrowd(threads, "balance_length", false));
  CheckSettledTicks(world, 200, 100);
}

}  // namespace argos::determinism_crowd_test
