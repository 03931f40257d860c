// A library of controllers with one error each.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>

#include <fstream>
#include <limits>
#include <stdexcept>

using namespace argos;

namespace {

class CIdle : public CCI_Controller {};

class CThrowsInInit : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override { throw std::runtime_error("no good beginning"); }
};

/* Works for two steps, writes its calls to the file given by a parameter, and then throws. */
class CThrowsInStep : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    std::string file;
    GetNodeAttributeOrDefault(params, "file", file, file);
    GetNodeAttributeOrDefault(params, "no_exception", m_throwsInteger, m_throwsInteger);
    if (!file.empty()) {
      m_file.open(file);
    }
  }
  void ControlStep() override {
    m_file << "step " << m_step << '\n';
    if (m_step++ == 2 && m_throwsInteger) {
      throw 42;
    }
    if (m_step == 3) {
      throw std::runtime_error("tired after two steps");
    }
  }

 private:
  int m_step = 0;
  bool m_throwsInteger = false;
  std::ofstream m_file;
};

class CThrowsInDestroy : public CCI_Controller {
 public:
  void Destroy() override { throw std::runtime_error("no good end"); }
};

class CNotANumber : public CCI_Controller {
 public:
  void Init(TConfigurationNode&) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
  }
  void ControlStep() override {
    m_wheels->SetLinearVelocity(std::numeric_limits<Real>::quiet_NaN(), 0.0);
  }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
};

/* Requests the devices given by its parameters, the sensor as a proximity sensor. */
class CAsksForDevice : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    std::string sensor;
    std::string actuator;
    GetNodeAttributeOrDefault(params, "sensor", sensor, sensor);
    GetNodeAttributeOrDefault(params, "actuator", actuator, actuator);
    if (!sensor.empty()) {
      GetSensor<CCI_ProximitySensor>(sensor);
    }
    if (!actuator.empty()) {
      GetActuator<CCI_Actuator>(actuator);
    }
  }
};

/* Sends messages with the number of bytes given by its parameters. */
class CSendsMessage : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    GetNodeAttribute(params, "bytes", m_bytes);
    m_messages = GetActuator<CCI_RangeAndBearingActuator>("range_and_bearing");
  }
  void ControlStep() override { m_messages->SetData(CByteArray(m_bytes)); }

 private:
  UInt32 m_bytes = 0;
  CCI_RangeAndBearingActuator* m_messages = nullptr;
};

}  // namespace

REGISTER_CONTROLLER(CIdle, "test_idle")
REGISTER_CONTROLLER(CThrowsInInit, "test_throws_in_init")
REGISTER_CONTROLLER(CThrowsInStep, "test_throws_in_step")
REGISTER_CONTROLLER(CThrowsInDestroy, "test_throws_in_destroy")
REGISTER_CONTROLLER(CNotANumber, "test_not_a_number")
REGISTER_CONTROLLER(CAsksForDevice, "test_asks_for_device")
REGISTER_CONTROLLER(CSendsMessage, "test_sends_message")
