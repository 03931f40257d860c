#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <sensor/ci_odometer_sensor.h>

#ifndef LABEL
#define LABEL "back_and_forth"
#endif

using namespace argos;

/* Drives 20 ticks ahead and 20 ticks back, and prints what the odometer reads. */
class CBackAndForth : public CCI_Controller {
 public:
  CBackAndForth() : m_pcWheels(NULL), m_pcOdometer(NULL), m_unTick(0) {}
  virtual void Init(TConfigurationNode& t_node) {
    m_pcWheels = GetActuator<CCI_DifferentialSteeringActuator>("differential_steering");
    m_pcOdometer = GetSensor<CCI_OdometerSensor>("odometer");
  }
  virtual void ControlStep() {
    Real fSpeed = (m_unTick / 20) % 2 == 0 ? 10.0 : -10.0;
    m_pcWheels->SetLinearVelocity(fSpeed, fSpeed);
    ++m_unTick;
    RLOG << m_unTick << " odometer " << m_pcOdometer->GetReading() << std::endl;
  }

 private:
  CCI_DifferentialSteeringActuator* m_pcWheels;
  CCI_OdometerSensor* m_pcOdometer;
  UInt32 m_unTick;
};

REGISTER_CONTROLLER(CBackAndForth, LABEL)
