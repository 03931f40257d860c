#ifndef USER_CONTROLLER_H
#define USER_CONTROLLER_H

/* A controller as users of ARGoS 3 write them: for foot-bots and e-pucks. */

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>

using namespace argos;

class CUserController : public CCI_Controller {
 public:
  CUserController();
  virtual ~CUserController() {}

  virtual void Init(TConfigurationNode& t_node);
  virtual void ControlStep();
  virtual void Reset();
  virtual void Destroy() {}

  UInt32 GetSteps() const { return m_unSteps; }
  const CVector2& GetCrowd() const { return m_cCrowd; }
  CCI_DifferentialSteeringActuator* GetWheels() { return m_pcWheels; }

 private:
  CCI_DifferentialSteeringActuator* m_pcWheels;
  CCI_DifferentialSteeringSensor* m_pcEncoder;
  CCI_LEDsActuator* m_pcLEDs;
  CCI_ProximitySensor* m_pcGenericProximity;
  CCI_FootBotProximitySensor* m_pcFootBotProximity;
  CCI_EPuckProximitySensor* m_pcEPuckProximity;
  CRandom::CRNG* m_pcRNG;
  CDegrees m_cAlpha;
  Real m_fDelta;
  Real m_fWheelVelocity;
  CRange<CRadians> m_cGoStraightAngleRange;
  CVector2 m_cCrowd;
  UInt32 m_unSteps;
};

#endif
