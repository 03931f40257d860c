// The columns of tables that readings are copied to.

#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_front_camera_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_ground_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_imu_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_rangefinders_sensor.h>
#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_system_sensor.h>
#include <argos3/plugins/robots/prototype/control_interface/ci_joints_sensor.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace reading_columns_test {

using namespace argos;

namespace {

typedef std::vector<std::string> TNames;
typedef std::vector<Real> TNumbers;

constexpr Real kNone = -77.0;  // a number that no reading is

TNames ListNames(const CCI_Sensor& sensor) {
  TNames names;
  for (const CCI_Sensor::SColumn& column : sensor.GetReadingColumns()) {
    names.push_back(column.Name);
  }
  return names;
}

// all readings are copied; of fewer columns the first ones; nothing is written behind them
void CheckCopies(const CCI_Sensor& sensor, const TNames& names, const TNumbers& expected) {
  REQUIRE(ListNames(sensor) == names);
  REQUIRE(names.size() == expected.size());
  for (size_t count = 0; count <= expected.size(); ++count) {
    CAPTURE(count);
    TNumbers numbers(expected.size() + 2, kNone);
    sensor.CopyReadings(numbers.data(), count);
    TNumbers copied(expected.begin(), expected.begin() + static_cast<std::ptrdiff_t>(count));
    copied.resize(numbers.size(), kNone);
    CHECK(numbers == copied);
  }
  // a robot may have fewer of them than the table has columns
  TNumbers numbers(expected.size() + 2, kNone);
  sensor.CopyReadings(numbers.data(), numbers.size());
  TNumbers copied = expected;
  copied.resize(numbers.size(), kNone);
  CHECK(numbers == copied);
}

class CPheromones : public CCI_PheromoneSensor {
 public:
  CPheromones() {
    m_vecInterfaces = {{"food", {{1.5, CVector2()}, {2.5, CVector2()}}},
                       {"home", {{3.5, CVector2()}}},
                       {"none", {}}};
  }
};

class CRadios : public CCI_SimpleRadiosSensor {
 public:
  CRadios() {
    m_vecInterfaces.emplace_back("left").Messages.resize(3);
    m_vecInterfaces.emplace_back("right");
  }
};

class CTags : public CCI_RFIDSensor {
 public:
  CTags() { m_tReadings.resize(4); }
};

class CPose : public CCI_PositioningSensor {
 public:
  CPose() {
    m_sReading.Position = CVector3(1.0, 2.0, 3.0);
    m_sReading.Orientation = CQuaternion(0.5, -0.5, 0.25, -0.25);
  }
};

class CJoints : public CCI_JointsSensor {
 public:
  CJoints() {
    m_vecInterfaces.emplace_back("arm", SInterface::EMode::POSITION).Value = 0.75;
    m_vecInterfaces.emplace_back("hand", SInterface::EMode::VELOCITY).Value = -2.0;
  }
};

class CDrive : public CCI_PiPuckDifferentialDriveSensor {
 public:
  Real GetLeftVelocity() override { return 0.25; }
  Real GetRightVelocity() override { return -0.5; }
};

class CCamera : public CCI_PiPuckFrontCameraSensor {
 public:
  ELedState DetectLed(const CVector3&) const override { return ELedState::OFF; }
  Real GetTimestamp() const override { return 0.0; }
  const STag::TVector& GetTags() const override { return m_tags; }

 private:
  STag::TVector m_tags = {2, STag(1, CVector3(), CQuaternion(), CVector2(), {})};
};

class CGround : public CCI_PiPuckGroundSensor {
 public:
  void Visit(std::function<void(const SInterface&)> visit) override {
    for (UInt8 label = 0; label < 3; ++label) {
      SInterface interface(label);
      interface.Reflected = 0.25 * label;
      interface.Background = 9.0;
      visit(interface);
    }
  }
};

class CRangefinders : public CCI_PiPuckRangefindersSensor {
 public:
  void Visit(std::function<void(const SInterface&)> visit) override {
    for (const auto& [label, configuration] : MAP_SENSOR_CONFIG) {
      SInterface interface(label);
      interface.Proximity = 0.5 * label;
      interface.Illuminance = 9.0;
      visit(interface);
    }
  }
};

class CImu : public CCI_PiPuckImuSensor {
 public:
  CImu() {
    m_cAccelerometer = CVector3(1.0, 2.0, 3.0);
    m_cGryoscope = CVector3(4.0, 5.0, 6.0);
    m_cMagnetometer = CVector3(7.0, 8.0, 9.0);
  }
};

class CSystem : public CCI_PiPuckSystemSensor {
 public:
  CSystem() {
    m_fTime = 12.5;
    m_fTemperature = 40.0;
  }
};

}  // namespace

TEST_CASE("reading columns: readings with names of the experiment are copied",
          "[robots][outputs]") {
  CheckCopies(CPheromones(), {"food_1", "food_2", "home_1"}, {1.5, 2.5, 3.5});
  CheckCopies(CRadios(), {"left_count", "right_count"}, {3.0, 0.0});
  CheckCopies(CTags(), {"count"}, {4.0});
  CheckCopies(CPose(), {"x", "y", "z", "qw", "qx", "qy", "qz"},
              {1.0, 2.0, 3.0, 0.5, -0.5, 0.25, -0.25});
  CheckCopies(CJoints(), {"arm", "hand"}, {0.75, -2.0});
}

TEST_CASE("reading columns: readings of the Pi-Puck are copied", "[robots][outputs]") {
  CheckCopies(CDrive(), {"left", "right"}, {0.25, -0.5});
  CheckCopies(CCamera(), {"count"}, {2.0});
  CheckCopies(CGround(), {"1", "2", "3"}, {0.0, 0.25, 0.5});
  CheckCopies(CRangefinders(), {"1", "2", "3", "4", "5", "6", "7", "8"},
              {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5});
  CheckCopies(CImu(),
              {"acceleration_x", "acceleration_y", "acceleration_z", "turn_rate_x", "turn_rate_y",
               "turn_rate_z"},
              {1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  CheckCopies(CSystem(), {"time", "temperature"}, {12.5, 40.0});
}

TEST_CASE("reading columns: a layer of pheromones is found by its name", "[robots]") {
  const CPheromones pheromones;
  CHECK(pheromones.GetReadings("home").at(0).Value == 3.5);
  CHECK(pheromones.GetReadings().size() == 2);
  CHECK_THROWS_WITH(pheromones.GetReadings("hone"),
                    Catch::Contains("unknown layer \"hone\"") && Catch::Contains("\"home\""));
}

}  // namespace reading_columns_test
