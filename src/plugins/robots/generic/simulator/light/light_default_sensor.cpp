#include <argos3/plugins/robots/generic/simulator/light_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/plugins/robots/generic/simulator/planar_rays.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/lights.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr size_t kBatch = CRayCaster::kMaxRays;
// sine of the angle below the horizon at which a light still counts as grazing: far above the
// roundings of a robot's pose, so that mirrored sensors decide alike, far below what matters
constexpr Real kGrazing = 1e-9;

// segments from some places to one point: around the segment from their centre, at each fraction of
// the length they are as far apart as the places times what is left of the length
struct SBeam {
  CVector3 Start, End;  // m, world frame; starts at the centre of the places
  Real Reach;  // m, of the places around the centre, seen from above
  Real MinZ, MaxZ;  // m, of the places

  // false if no segment can meet the solid
  bool ComesNear(const SIndexedShape& shape) const {
    const Real dx = End.GetX() - Start.GetX();
    const Real dy = End.GetY() - Start.GetY();
    const Real px = shape.X - Start.GetX();
    const Real py = shape.Y - Start.GetY();
    const Real square = dx * dx + dy * dy;
    const Real far = Reach + shape.Radius + kRoundings;
    // almost all solids are beside the line
    const Real aside = px * dy - py * dx;
    if (aside * aside > far * far * square) {
      return false;
    }
    if (square == 0.0) {
      return px * px + py * py <= far * far;
    }
    const Real along = (px * dx + py * dy) / square;
    const Real beyond = along - std::clamp(along, 0.0, 1.0);
    if (aside * aside / square + beyond * beyond * square > far * far) {
      return false;
    }
    // the part over the circle around the solid, and its heights
    const Real half = far / std::sqrt(square);
    const Real first = std::clamp(along - half, 0.0, 1.0);
    const Real last = std::clamp(along + half, 0.0, 1.0);
    const Real lowest = std::min(HeightAt(MinZ, first), HeightAt(MinZ, last));
    const Real highest = std::max(HeightAt(MaxZ, first), HeightAt(MaxZ, last));
    return lowest <= shape.ZMax + kRoundings && highest >= shape.ZMin - kRoundings;
  }

 private:
  static constexpr Real kRoundings = 1e-9;  // m

  Real HeightAt(Real start, Real fraction) const { return start + fraction * (End.GetZ() - start); }
};

}  // namespace

struct CLightDefaultSensor::SEyes {
  enum class ESight : UInt8 { Behind, Clear, Blocked };

  size_t Count = 0;
  CVector3 Positions[kBatch];  // world frame, m
  CVector3 Directions[kBatch];  // world frame, of length 1
  CVector3 Center;  // world frame, m
  Real Reach = 0.0;  // m, of the positions around the centre, seen from above
  Real MinZ = HUGE_VAL, MaxZ = -HUGE_VAL;  // m, of the positions
  Real Distances[kBatch];  // to the light, m
  ESight Sights[kBatch];  // of the light
  SPlanarRays<kBatch> Lines;  // to the light
  Real Readings[kBatch];

  SEyes(const SRayLayout& layout, const SAnchor* const* anchors, size_t first, size_t count);
  bool SeesAny() const {
    return std::any_of(Sights, Sights + Count, [](ESight sight) { return sight == ESight::Clear; });
  }
};

CLightDefaultSensor::SEyes::SEyes(const SRayLayout& layout, const SAnchor* const* anchors,
                                  size_t first, size_t count)
    : Count(count) {
  for (size_t i = 0; i < Count; ++i) {
    const SSensorRay& sensor = layout.Rays[first + i];
    const SAnchor& anchor = *anchors[sensor.Anchor];
    Positions[i] = sensor.Offset;
    Positions[i].Rotate(anchor.Orientation);
    Positions[i] += anchor.Position;
    Directions[i] = sensor.Direction;
    Directions[i].Rotate(anchor.Orientation).Normalize();
    Center += Positions[i];
    Readings[i] = 0.0;
  }
  Center /= static_cast<Real>(Count);
  for (size_t i = 0; i < Count; ++i) {
    Reach = std::max(Reach, std::hypot(Positions[i].GetX() - Center.GetX(),
                                       Positions[i].GetY() - Center.GetY()));
    MinZ = std::min(MinZ, Positions[i].GetZ());
    MaxZ = std::max(MaxZ, Positions[i].GetZ());
  }
}

void CLightDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_sensors = &robot.GetComponent<CLightSensorEquippedEntity>("light_sensors");
  m_caster.SetRobot(robot);
  m_lights = &m_caster.GetSpace().GetExtension<CLights>();
  m_sensors->Enable();
}

void CLightDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_LightSensor::Init(tree);
  GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
  m_noise.Init(tree, m_caster.GetRobot(), {"reading"}, {ReadNoiseLevel(tree)});
  m_tReadings.assign(m_sensors->GetNumSensors(), 0.0);
  Enable();
}

void CLightDefaultSensor::Update() {
  const SRayLayout& layout = m_sensors->GetLayout();
  m_tReadings.assign(layout.Rays.size(), 0.0);
  if (!m_lights->Get().empty()) {
    for (size_t first = 0; first < m_tReadings.size(); first += kBatch) {
      SEyes eyes(layout, m_sensors->GetAnchors(), first,
                 std::min(kBatch, m_tReadings.size() - first));
      AddLights(eyes);
      std::copy_n(eyes.Readings, eyes.Count, m_tReadings.begin() + static_cast<ptrdiff_t>(first));
    }
  }
  for (Real& reading : m_tReadings) {
    reading = std::clamp(m_noise.Apply(0, reading), 0.0, 1.0);
  }
}

void CLightDefaultSensor::AddLights(SEyes& eyes) {
  for (const CLightEntity* light : m_lights->Get()) {
    if (light->GetIntensity() <= 0.0) {
      continue;
    }
    FindFacing(*light, eyes);
    if (!eyes.SeesAny()) {
      continue;
    }
    FindBlocked(light->GetPosition(), eyes);
    if (m_showRays) {
      Show(light->GetPosition(), eyes);
    }
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (eyes.Sights[i] == SEyes::ESight::Clear) {
        eyes.Readings[i] += CalculateReading(eyes.Distances[i], light->GetIntensity());
      }
    }
  }
}

void CLightDefaultSensor::FindFacing(const CLightEntity& light, SEyes& eyes) const {
  for (size_t i = 0; i < eyes.Count; ++i) {
    const CVector3 towards = light.GetPosition() - eyes.Positions[i];
    eyes.Distances[i] = towards.Length();
    eyes.Lines.Set(i, eyes.Positions[i].GetX(), eyes.Positions[i].GetY(), towards.GetX(),
                   towards.GetY());
    const bool behind = towards.DotProduct(eyes.Directions[i]) < -kGrazing * eyes.Distances[i];
    eyes.Sights[i] = behind ? SEyes::ESight::Behind : SEyes::ESight::Clear;
  }
}

// looks once for the solids on the way to the light, and tests all segments against them
void CLightDefaultSensor::FindBlocked(const CVector3& light, SEyes& eyes) const {
  if (m_caster.AreBodiesOutsideIndex()) {
    Real fraction = 1.0;
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (eyes.Sights[i] == SEyes::ESight::Clear &&
          m_caster.FindHit(CRay3(eyes.Positions[i], light), fraction)) {
        eyes.Sights[i] = SEyes::ESight::Blocked;
      }
    }
    return;
  }
  const CBodyIndex& index = m_caster.GetSpace().GetBodyIndex();
  const UInt32 ownBody = m_caster.GetBody().GetBodyNumber();
  const SBeam beam = {eyes.Center, light, eyes.Reach, eyes.MinZ, eyes.MaxZ};
  index.ForShapesAlongRay(CRay3(eyes.Center, light), eyes.Reach, [&](const SIndexedShape& shape) {
    if (shape.Body == ownBody || !beam.ComesNear(shape)) {
      return;
    }
    Real near[kBatch];
    eyes.Lines.FindNear(shape, eyes.Count, near);
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (eyes.Sights[i] == SEyes::ESight::Clear && !(near[i] < 0.0) &&
          index.Intersect(shape, CRay3(eyes.Positions[i], light)) <= 1.0) {
        eyes.Sights[i] = SEyes::ESight::Blocked;
      }
    }
  });
}

void CLightDefaultSensor::Show(const CVector3& light, const SEyes& eyes) const {
  for (size_t i = 0; i < eyes.Count; ++i) {
    if (eyes.Sights[i] != SEyes::ESight::Behind) {
      m_caster.GetRobot().AddCheckedRay(eyes.Sights[i] == SEyes::ESight::Blocked,
                                        CRay3(eyes.Positions[i], light));
    }
  }
}

void CLightDefaultSensor::Reset() {
  m_tReadings.assign(m_sensors->GetNumSensors(), 0.0);
  m_noise.Reset();
}

Real CLightDefaultSensor::CalculateReading(Real distance, Real intensity) {
  const Real ratio = intensity / distance;
  return ratio * ratio;
}

REGISTER_SENSOR(
    CLightDefaultSensor, "light", "default", "the authors of this project", "1.0",
    "The light sensors of any robot.",
    R"(Every light sensor of the robot reads the sum of (I/D)^2 over the lights that it sees, clamped to
[0,1], where I > 0 is the intensity of a light and D (m) its distance from the sensor. Neither the direction of the
light nor the range of the sensor plays a part, but for this: a light behind the plane through the sensor that touches
the body is hidden by the robot itself. A light is also hidden if any other body lies between it and the sensor. Without
lights all readings are 0.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <light implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <light implementation="default" show_rays="true" noise_level="0.1" />

  show_rays    "true" or "false", default "false": visualizations that can show a ray from each
               sensor to each light in front of it.
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to each
               reading in each tick, and the sum is clamped to [0,1].

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to every reading, before it is clamped.
)",
    "Usable")

}  // namespace argos
