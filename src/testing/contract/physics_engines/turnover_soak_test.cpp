// Ten thousand robots in engines of all types, of which some are added, removed and moved in each
// tick.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/testing/contract/physics_engines/board.h>
#include <argos3/testing/contract/physics_engines/turnover.h>

#include <catch2/catch.hpp>

namespace argos::turnover_soak_test {

using testing::SRoomsWorld;

namespace {

constexpr UInt32 kRobots = 10000;
constexpr UInt32 kTurnover = 50;  // robots that are added, and removed, and moved in each tick

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

}  // namespace

TEST_CASE("turnover: memory stays flat while robots are added, removed and moved in every tick",
          "[.][soak][turnover]") {
  const SBoard board = ListBoards().back();
  REQUIRE(board.Types.size() == kSharingEngines.size());
  const SRoomsWorld rooms = MakeRooms();
  CTestWorld world(board.ToXml(rooms));
  CTurnover turnover(world, rooms.Side, kTurnover);
  Soak([&] { turnover.Tick(); }, [&] { turnover.Check(); });
}

}  // namespace argos::turnover_soak_test
