#include <argos3/plugins/robots/generic/simulator/light_default_sensor.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/light_eyes.h>
#include <argos3/plugins/robots/generic/simulator/light_occluders.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/lights.h>

#include <algorithm>
#include <typeinfo>
#include <vector>

namespace argos {

// memory for the lights of one robot; stays allocated
struct CLightDefaultSensor::SScratch {
  std::vector<CRay3> Lines;  // from the centre of the sensors to the lights, m
  CLightOccluders Occluders;
};

CLightDefaultSensor::CLightDefaultSensor()
    : m_lights(&CurrentSpace().GetExtension<CLights>()),
      m_pcEmbodiedEntity(m_caster.AccessBody()),
      m_pcControllableEntity(m_caster.AccessRobot()),
      m_cSpace(CurrentSpace()) {
  m_caster.SetSpace(m_cSpace);
}

void CLightDefaultSensor::FindParts(CComposableEntity& robot) {
  m_pcLightEntity = &robot.GetComponent<CLightSensorEquippedEntity>("light_sensors");
  m_caster.SetRobot(robot);
  m_pcLightEntity->Enable();
}

void CLightDefaultSensor::Configure(TConfigurationNode& tree) {
  GetNodeAttributeOrDefault(tree, "show_rays", m_bShowRays, m_bShowRays);
  m_isPlain = typeid(*this) == typeid(CLightDefaultSensor);
  if (m_isPlain) {
    m_noise.Init(tree, *m_pcControllableEntity, {"reading"}, {ReadNoiseLevel(tree)});
  } else {
    m_noise.Init(tree, *m_pcControllableEntity, {"reading"});
    InitNoise(tree);
  }
  m_tReadings.assign(m_pcLightEntity->GetNumSensors(), 0.0);
}

void CLightDefaultSensor::Update() {
  const SRayLayout& layout = m_pcLightEntity->GetLayout();
  m_tReadings.assign(layout.Rays.size(), 0.0);
  if (!m_lights->Get().empty()) {
    SLightEyes eyes;
    for (size_t first = 0; first < m_tReadings.size(); first += SLightEyes::kCapacity) {
      eyes.Place(layout, m_pcLightEntity->GetAnchors(), first,
                 std::min(SLightEyes::kCapacity, m_tReadings.size() - first));
      AddLights(eyes);
      std::copy_n(eyes.Readings, eyes.Count, m_tReadings.begin() + static_cast<ptrdiff_t>(first));
    }
  }
  if (m_bAddNoise) {
    for (Real& reading : m_tReadings) {
      reading += DrawNoise();
    }
  }
  for (Real& reading : m_tReadings) {
    reading = std::clamp(m_noise.Apply(0, reading), 0.0, 1.0);
  }
}

void CLightDefaultSensor::AddLights(SLightEyes& eyes) {
  static thread_local SScratch scratch;
  FindOccluders(eyes, scratch);
  size_t number = 0;
  for (const CLightEntity* light : m_lights->Get()) {
    const Real intensity = light->GetIntensity();
    if (intensity <= 0.0 || eyes.LookAt(scratch.Lines[number++].GetEnd()) == 0) {
      continue;
    }
    if (m_bShowRays) {
      OccludeAndShow(eyes, scratch.Occluders);
    } else {
      Occlude(eyes, scratch.Occluders);
    }
    if (m_isPlain) {
      eyes.AddSquares(intensity);
      continue;
    }
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (eyes.IsClear[i] != 0) {
        eyes.Readings[i] += CalculateReading(eyes.Distance[i], intensity);
      }
    }
  }
}

// queries the index once for the solids near the lines to all lights that have an intensity
void CLightDefaultSensor::FindOccluders(const SLightEyes& eyes, SScratch& scratch) const {
  const SPeriodicity& period = m_cSpace.GetContext().Arena.Period;
  scratch.Lines.clear();
  for (const CLightEntity* light : m_lights->Get()) {
    if (light->GetIntensity() > 0.0) {
      // a periodic arena has images of the light: the nearest one counts
      scratch.Lines.emplace_back(eyes.Center,
                                 period.FindNearest(light->GetPosition(), eyes.Center));
    }
  }
  if (!m_caster.AreBodiesOutsideIndex()) {
    scratch.Occluders.Find(m_caster.GetSpace().GetBodyIndex(), m_caster.GetBody().GetBodyNumber(),
                           eyes, scratch.Lines);
  }
}

void CLightDefaultSensor::Occlude(SLightEyes& eyes, CLightOccluders& occluders) const {
  if (!m_caster.AreBodiesOutsideIndex()) {
    occluders.Occlude(eyes);
    return;
  }
  for (size_t i = 0; i < eyes.Count; ++i) {
    if (eyes.IsClear[i] != 0 && m_caster.IsBlocked(CRay3(eyes.GetPosition(i), eyes.Light))) {
      eyes.IsClear[i] = 0;
    }
  }
}

// the lines to the light are shown of the sensors that it is not behind
void CLightDefaultSensor::OccludeAndShow(SLightEyes& eyes, CLightOccluders& occluders) const {
  UInt64 isAhead[SLightEyes::kCapacity];
  std::copy_n(eyes.IsClear, eyes.Count, isAhead);
  Occlude(eyes, occluders);
  for (size_t i = 0; i < eyes.Count; ++i) {
    if (isAhead[i] != 0) {
      m_caster.GetRobot().AddCheckedRay(eyes.IsClear[i] == 0,
                                        CRay3(eyes.GetPosition(i), eyes.Light));
    }
  }
}

void CLightDefaultSensor::ResetReading() {
  m_tReadings.assign(m_pcLightEntity->GetNumSensors(), 0.0);
}

Real CLightDefaultSensor::CalculateReading(Real distance, Real intensity) {
  const Real ratio = intensity / distance;
  return ratio * ratio;
}

REGISTER_SENSOR(
    CLightDefaultSensor, "light", "default", "the authors of this project", "1.0",
    "The light sensors of any robot.",
    R"(Every light sensor of the robot reads the sum of (I/D)^2 over the visible lights, clamped to [0,1], where
I > 0 is the intensity of a light and D (m) its distance from the sensor. The direction of the light and the range of the
sensor have no other effect than this: the robot itself occludes a light behind the plane through the sensor that touches
the body. Any other body between a light and the sensor occludes the light. Without lights all readings are 0.
)" + RayReadingsManual("light", "default", "a ray from each sensor to each light in front of it"),
    "Usable")

}  // namespace argos
