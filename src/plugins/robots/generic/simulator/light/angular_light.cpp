#include <argos3/plugins/robots/generic/simulator/angular_light.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/lights.h>

#include <cmath>

namespace argos {

namespace {

// response to distance as published with ARGoS 3
constexpr Real kDecay = 2.0;
constexpr Real kReach = 2.5;
// mean of max(0, 1 - 2 delta / PI) over a full turn
constexpr Real kMeanShare = 0.25;

}  // namespace

void CAngularLight::SetRobot(CComposableEntity& robot) {
  m_sensors = &robot.GetComponent<CLightSensorEquippedEntity>("light_sensors");
  m_caster.SetRobot(robot);
  m_sensors->Enable();
  m_lights = &m_caster.GetSpace().GetExtension<CLights>();
}

size_t CAngularLight::GetNumSensors() const {
  return m_sensors->GetNumSensors();
}

void CAngularLight::Init(TConfigurationNode& tree) {
  GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
  m_noise.Init(tree, m_caster.GetRobot(), {"reading"}, {ReadNoiseLevel(tree)});
}

size_t CAngularLight::GetNumLights() const {
  return m_lights->Get().size();
}

bool CAngularLight::ComputeBeam(size_t light, SBeam& beam) {
  const CLightEntity& lamp = *m_lights->Get()[light];
  const Real intensity = lamp.GetIntensity();
  if (intensity <= 0.0) {
    return false;
  }
  const SAnchor& origin = m_caster.GetBody().GetOriginAnchor();
  // a periodic arena has images of the lamp: the nearest one counts
  const CVector3 place = m_caster.GetSpace().GetContext().Arena.Period.FindNearest(
      lamp.GetPosition(), origin.Position);
  CVector3 towards = place - origin.Position;
  const Real distance = towards.Length() / intensity;
  if (distance > kReach) {
    return false;
  }
  const CRay3 ray(origin.Position, place);
  const bool blocked = m_caster.IsBlocked(ray);
  if (m_showRays) {
    m_caster.GetRobot().AddCheckedRay(blocked, ray);
  }
  if (blocked) {
    return false;
  }
  beam.Strength = std::exp(-kDecay * distance);
  towards.Rotate(origin.Orientation.Inverse());
  beam.HasAzimuth = towards.GetX() != 0.0 || towards.GetY() != 0.0;
  beam.Azimuth = CRadians(std::atan2(towards.GetY(), towards.GetX()));
  return true;
}

Real CAngularLight::ComputeShare(const SBeam& beam, const CRadians& sensor) {
  if (!beam.HasAzimuth) {
    return kMeanShare * beam.Strength;
  }
  const Real apart = (beam.Azimuth - sensor).SignedNormalize().GetAbsoluteValue();
  return beam.Strength * std::max(0.0, 1.0 - apart / CRadians::PI_OVER_TWO.GetValue());
}

}  // namespace argos
