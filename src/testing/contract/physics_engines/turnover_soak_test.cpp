// Ten thousand robots in engines of all types, of which some are added, removed and moved in each
// tick.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/testing/contract/physics_engines/board.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace argos {

using testing::SRoomsWorld;

namespace {

constexpr UInt32 kRobots = 10000;
constexpr UInt32 kTurnover = 50;  // robots that are added, and removed, and moved in each tick
// share by which the memory may grow after the first tenth of the time
constexpr double kGrowth = 0.02;

/** Walks at random, sends what it drew last, and shows by its LEDs how many robots it hears. */
class CTurnoverController : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_leds = GetActuator<CCI_LEDsActuator>("leds");
    m_sender = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
    m_receiver = GetSensor<CCI_RangeAndBearingSensor>("range_and_bearing");
    m_proximity = GetSensor<CCI_EPuckProximitySensor>("epuck_proximity");
    m_random = CRandom::CreateRNG("argos");
  }
  void ControlStep() override {
    const UInt32 draw = m_random->Uniform(CRange<UInt32>(0, 256));
    m_sender->SetData(0, static_cast<UInt8>(draw));
    m_leds->SetAllColors(m_receiver->GetReadings().size() > 2 ? CColor::RED : CColor::BLUE);
    Real ahead = 0.0;
    for (const CCI_EPuckProximitySensor::SReading& reading : m_proximity->GetReadings()) {
      ahead += reading.Value;
    }
    ahead > 0.5 ? m_wheels->SetLinearVelocity(8.0, -8.0)
                : m_wheels->SetLinearVelocity(10.0, draw < 128 ? 10.0 : 8.0);
  }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_LEDsActuator* m_leds = nullptr;
  CCI_RangeAndBearingActuator* m_sender = nullptr;
  CCI_RangeAndBearingSensor* m_receiver = nullptr;
  CCI_EPuckProximitySensor* m_proximity = nullptr;
  CRandom::CRNG* m_random = nullptr;
};

REGISTER_CONTROLLER(CTurnoverController, "turnover_controller")

SRoomsWorld MakeRooms() {
  SRoomsWorld rooms;
  rooms.Robots = kRobots;
  rooms.Side = SRoomsWorld::SideAtSameDensity(kRobots);
  // in engines without contacts, a robot that has entered a wall could leave it on the other side
  rooms.RoomsPerSide = 1;
  rooms.Threads = 2;
  rooms.Controller = "turnover_controller";
  rooms.Actuators =
      "<leds implementation='default' medium='leds'/><range_and_bearing implementation='default'/>";
  rooms.Sensors = "<range_and_bearing implementation='medium' medium='rab'/>";
  rooms.Media = "<led id='leds'/><range_and_bearing id='rab'/>";
  return rooms;
}

// resident memory of this process, bytes
double ReadResidentMemory() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  REQUIRE(resident > 0.0);
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE));
}

/** Adds, removes and moves robots at random, and counts them. */
class CTurnover {
 public:
  CTurnover(CTestWorld& world, Real side)
      : m_world(world), m_scope(world.GetSimulator()), m_reach(0.5 * side - 0.3) {
    for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
      m_ids.push_back(robot->GetRootEntity().GetId());
    }
    REQUIRE(m_ids.size() == kRobots);
    m_fixed = CountModels() - kRobots;
  }

  void Tick() {
    for (UInt32 i = 0; i < kTurnover; ++i) {
      Remove();
      Add();
      Move();
    }
    m_world.Step();
  }

  // none is lost, none is in two engines, and all are in finite places inside the arena
  void Check() {
    CSpace& space = m_world.GetSpace();
    REQUIRE(space.GetControllableEntities().size() == kRobots);
    REQUIRE(CountModels() == m_fixed + kRobots);
    size_t wrong = 0;
    for (CControllableEntity* robot : space.GetControllableEntities()) {
      const auto& body = robot->GetParent().GetComponent<CEmbodiedEntity>("body");
      const CVector3& place = body.GetOriginAnchor().Position;
      const bool isInside =
          std::max(std::abs(place.GetX()), std::abs(place.GetY())) < m_reach + 1.0 &&
          std::isfinite(place.GetZ());
      wrong += body.GetPhysicsModelsNum() == 1 && isInside ? 0 : 1;
    }
    REQUIRE(wrong == 0);
  }

  UInt64 GetNumAdded() const { return m_added; }

 private:
  CVector3 DrawPlace() {
    return {m_random.Uniform(-m_reach, m_reach), m_random.Uniform(-m_reach, m_reach), 0.0};
  }
  size_t DrawRobot() {
    return static_cast<size_t>(m_random.Uniform(0.0, 1.0) * static_cast<double>(m_ids.size()));
  }
  CLoopFunctions& GetFunctions() { return m_world.GetSimulator().GetLoopFunctions(); }

  void Remove() {
    const size_t robot = DrawRobot();
    GetFunctions().RemoveEntity(m_ids[robot]);
    m_ids[robot] = m_ids.back();
    m_ids.pop_back();
  }

  void Add() {
    // places that are occupied are refused by moving there
    auto* robot = new CEPuckEntity("new" + std::to_string(m_added++), "diffusion");
    GetFunctions().AddEntity(*robot);
    m_ids.push_back(robot->GetId());
    MoveToFreePlace(robot->GetEmbodiedEntity());
  }

  void Move() {
    auto& robot = m_world.Get<CEPuckEntity>(m_ids[DrawRobot()]);
    MoveToFreePlace(robot.GetEmbodiedEntity());
  }

  void MoveToFreePlace(CEmbodiedEntity& body) {
    for (int trial = 0; trial < 1000; ++trial) {
      const CQuaternion heading(CRadians(m_random.Uniform(-3.0, 3.0)), CVector3::Z);
      if (GetFunctions().MoveEntity(body, DrawPlace(), heading)) {
        return;
      }
    }
    FAIL("no free place for a robot");
  }

  size_t CountModels() {
    size_t count = 0;
    for (CPhysicsEngine* engine : m_world.GetSimulator().GetPhysicsEngines()) {
      count += engine->GetNumPhysicsModels();
    }
    return count;
  }

  CTestWorld& m_world;
  CSimulator::CScope m_scope;
  CRandomStream m_random{1, "test", "turnover", "places"};
  Real m_reach;  // m, of places in x and y
  std::vector<std::string> m_ids;
  size_t m_fixed = 0;  // models of bodies that are no robots
  UInt64 m_added = 0;
};

// minutes of wall time
double ReadDuration() {
  const char* text = std::getenv("ARGOS_SOAK_MINUTES");
  return text != nullptr ? std::strtod(text, nullptr) : 60.0;
}

}  // namespace

TEST_CASE("turnover: memory stays flat while robots are added, removed and moved in every tick",
          "[.][soak][turnover]") {
  using TClock = std::chrono::steady_clock;
  const SBoard board = ListBoards().back();
  REQUIRE(board.Types.size() == kSharingEngines.size());
  const SRoomsWorld rooms = MakeRooms();
  CTestWorld world(board.ToXml(rooms));
  CTurnover turnover(world, rooms.Side);
  const std::chrono::duration<double> whole(60.0 * ReadDuration());
  const TClock::time_point start = TClock::now();
  double first = 0.0;
  double greatest = 0.0;
  UInt64 ticks = 0;
  while (TClock::now() - start < whole) {
    turnover.Tick();
    if (++ticks % 10 != 0) {
      continue;
    }
    turnover.Check();
    const double now = ReadResidentMemory();
    if (TClock::now() - start < 0.1 * whole) {
      first = std::max(first, now);
    }
    greatest = std::max(greatest, now);
  }
  WARN(ticks << " ticks, " << turnover.GetNumAdded() << " robots added; resident memory "
             << first / 1048576.0 << " MiB in the first tenth of the time, at most "
             << greatest / 1048576.0 << " MiB");
  REQUIRE(first > 0.0);
  CHECK(greatest <= (1.0 + kGrowth) * first);
}

}  // namespace argos
