#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

using namespace argos;

/** Drives straight on, and turns away from what the proximity sensors see ahead. */
class CFirstController : public CCI_Controller {
 public:
  // called once: finds the devices, reads the attributes of <params>
  void Init(TConfigurationNode& params) override {
    m_wheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_proximity = GetSensor<CCI_FootBotProximitySensor>("footbot_proximity");
    GetNodeAttributeOrDefault(params, "speed", m_speed, 10.0);
  }

  // called in every tick, after the sensors were updated
  void ControlStep() override {
    Real left = 0.0;
    Real right = 0.0;
    for (const CCI_FootBotProximitySensor::SReading& reading : m_proximity->GetReadings()) {
      const bool isAhead = Cos(reading.Angle) > 0.0;
      if (isAhead && reading.Angle > CRadians::ZERO) {
        left += reading.Value;
      } else if (isAhead) {
        right += reading.Value;
      }
    }
    if (left + right < 0.1) {
      m_wheels->SetLinearVelocity(m_speed, m_speed);
    } else if (left > right) {
      m_wheels->SetLinearVelocity(m_speed, -m_speed);
    } else {
      m_wheels->SetLinearVelocity(-m_speed, m_speed);
    }
  }

 private:
  CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  CCI_FootBotProximitySensor* m_proximity = nullptr;
  Real m_speed = 0.0;  // cm/s
};

REGISTER_CONTROLLER(CFirstController, "first_controller")
