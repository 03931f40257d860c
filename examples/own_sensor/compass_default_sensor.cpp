#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/utility/math/rng.h>

#include "ci_compass_sensor.h"

using namespace argos;

/** The simulated compass. */
class CCompassDefaultSensor : public CSimulatedSensor, public CCI_CompassSensor {
 public:
  // called first: finds the components of the robot that the sensor reads
  void SetRobot(CComposableEntity& robot) override {
    m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  }

  // reads the attributes of <compass>
  void Init(TConfigurationNode& node) override {
    CCI_CompassSensor::Init(node);
    GetNodeAttributeOrDefault(node, "noise_std_dev", m_noise, m_noise);
    if (m_noise > 0.0) {
      m_random = CRandom::CreateRNG("argos");
    }
  }

  // called in every tick; robots are updated in parallel, so it writes only to this object
  void Update() override {
    CRadians yaw, pitch, roll;
    m_body->GetOriginAnchor().Orientation.ToEulerAngles(yaw, pitch, roll);
    m_north = CRadians::PI_OVER_TWO - yaw;
    if (m_random != nullptr) {
      m_north += CRadians(m_random->Gaussian(m_noise));
    }
    m_north.SignedNormalize();
  }

  void Reset() override { m_north = CRadians::ZERO; }

 private:
  CEmbodiedEntity* m_body = nullptr;
  CRandom::CRNG* m_random = nullptr;  // belongs to the robot
  Real m_noise = 0.0;  // rad
};

REGISTER_SENSOR(CCompassDefaultSensor, "compass", "default", "A. Student", "1.0",
                "The direction of north.",
                "North is the y axis of the arena.\n\n"
                "  noise_std_dev  rad, default 0: standard deviation of Gaussian noise.",
                "Usable")
