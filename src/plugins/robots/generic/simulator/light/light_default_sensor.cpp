#include <argos3/plugins/robots/generic/simulator/light_default_sensor.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/planar_rays.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/lights.h>

#include <algorithm>
#include <cmath>
#include <typeinfo>

namespace argos {

namespace {

constexpr size_t kBatch = CRayCaster::kMaxRays;
// sine of the angle below the horizon at which a light still counts as visible: much larger than
// the rounding error of a robot's pose, so that mirrored sensors decide alike
constexpr Real kGrazing = 1e-9;

// segments from several sensors to one light: at a fraction f of the segment from their centre,
// their distance from it is at most (1 - f) times the radius of the sensors around their centre
struct SBeam {
  CVector3 Start, End;  // m, world frame; starts at the centre of the sensors
  Real Reach;  // m, planar radius of the sensors around their centre
  Real MinZ, MaxZ;  // m, of the sensors

  // returns false if no segment can intersect the solid
  bool MayIntersect(const SIndexedShape& shape) const {
    const Real dx = End.GetX() - Start.GetX();
    const Real dy = End.GetY() - Start.GetY();
    const Real px = shape.X - Start.GetX();
    const Real py = shape.Y - Start.GetY();
    const Real square = dx * dx + dy * dy;
    const Real far = Reach + shape.Radius + kRoundingError;
    // rejects most solids: they are beside the line
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
    // the part above the bounding circle of the solid, and its heights
    const Real half = far / std::sqrt(square);
    const Real first = std::clamp(along - half, 0.0, 1.0);
    const Real last = std::clamp(along + half, 0.0, 1.0);
    const Real lowest = std::min(HeightAt(MinZ, first), HeightAt(MinZ, last));
    const Real highest = std::max(HeightAt(MaxZ, first), HeightAt(MaxZ, last));
    return lowest <= shape.ZMax + kRoundingError && highest >= shape.ZMin - kRoundingError;
  }

 private:
  static constexpr Real kRoundingError = 1e-9;  // m

  Real HeightAt(Real start, Real fraction) const { return start + fraction * (End.GetZ() - start); }
};

}  // namespace

struct CLightDefaultSensor::SEyeBatch {
  enum class ESight : UInt8 { Behind, Clear, Blocked };

  size_t Count = 0;
  CVector3 Positions[kBatch];  // world frame, m
  CVector3 Directions[kBatch];  // world frame, of length 1
  CVector3 Center;  // world frame, m
  Real Reach = 0.0;  // m, planar radius of the positions around the centre
  Real MinZ = HUGE_VAL, MaxZ = -HUGE_VAL;  // m, of the positions
  Real Distances[kBatch];  // distances to the light, m
  ESight Sights[kBatch];  // say if the light is visible
  SPlanarRays<kBatch> Lines;  // lines to the light
  Real Readings[kBatch];

  SEyeBatch(const SRayLayout& layout, const SAnchor* const* anchors, size_t first, size_t count);
  bool HasClearSight() const {
    return std::any_of(Sights, Sights + Count, [](ESight sight) { return sight == ESight::Clear; });
  }
};

CLightDefaultSensor::SEyeBatch::SEyeBatch(const SRayLayout& layout, const SAnchor* const* anchors,
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
  Real squareReach = 0.0;
  for (size_t i = 0; i < Count; ++i) {
    const CVector3 offset = Positions[i] - Center;
    squareReach =
        std::max(squareReach, offset.GetX() * offset.GetX() + offset.GetY() * offset.GetY());
    MinZ = std::min(MinZ, Positions[i].GetZ());
    MaxZ = std::max(MaxZ, Positions[i].GetZ());
  }
  Reach = std::sqrt(squareReach);
  Lines.SetCenter(Center.GetX(), Center.GetY());
}

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
  if (typeid(*this) == typeid(CLightDefaultSensor)) {
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
    for (size_t first = 0; first < m_tReadings.size(); first += kBatch) {
      SEyeBatch eyes(layout, m_pcLightEntity->GetAnchors(), first,
                     std::min(kBatch, m_tReadings.size() - first));
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

void CLightDefaultSensor::AddLights(SEyeBatch& eyes) {
  for (const CLightEntity* light : m_lights->Get()) {
    if (light->GetIntensity() <= 0.0) {
      continue;
    }
    // a periodic arena has images of the light: the nearest one counts
    const CVector3 place =
        m_cSpace.GetContext().Arena.Period.FindNearest(light->GetPosition(), eyes.Center);
    FindLightsAhead(place, eyes);
    if (!eyes.HasClearSight()) {
      continue;
    }
    FindOccluded(place, eyes);
    if (m_bShowRays) {
      Show(place, eyes);
    }
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (eyes.Sights[i] == SEyeBatch::ESight::Clear) {
        eyes.Readings[i] += CalculateReading(eyes.Distances[i], light->GetIntensity());
      }
    }
  }
}

void CLightDefaultSensor::FindLightsAhead(const CVector3& light, SEyeBatch& eyes) const {
  for (size_t i = 0; i < eyes.Count; ++i) {
    const CVector3 towards = light - eyes.Positions[i];
    eyes.Distances[i] = towards.Length();
    eyes.Lines.Set(i, eyes.Positions[i].GetX(), eyes.Positions[i].GetY(), towards.GetX(),
                   towards.GetY());
    const bool behind = towards.DotProduct(eyes.Directions[i]) < -kGrazing * eyes.Distances[i];
    eyes.Sights[i] = behind ? SEyeBatch::ESight::Behind : SEyeBatch::ESight::Clear;
  }
}

// queries the index once for the solids near the segments, and tests all segments against them
void CLightDefaultSensor::FindOccluded(const CVector3& light, SEyeBatch& eyes) const {
  if (m_caster.AreBodiesOutsideIndex()) {
    Real fraction = 1.0;
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (eyes.Sights[i] == SEyeBatch::ESight::Clear &&
          m_caster.FindHit(CRay3(eyes.Positions[i], light), fraction)) {
        eyes.Sights[i] = SEyeBatch::ESight::Blocked;
      }
    }
    return;
  }
  const CBodyIndex& index = m_caster.GetSpace().GetBodyIndex();
  const UInt32 ownBody = m_caster.GetBody().GetBodyNumber();
  const SBeam beam = {eyes.Center, light, eyes.Reach, eyes.MinZ, eyes.MaxZ};
  const CBodyIndex::SRayReach reach(
      eyes.Reach, std::max(eyes.MaxZ - eyes.Center.GetZ(), eyes.Center.GetZ() - eyes.MinZ));
  auto numClear = std::count(eyes.Sights, eyes.Sights + eyes.Count, SEyeBatch::ESight::Clear);
  const auto test = [&](const SIndexedShape& shape) {
    if (shape.Body == ownBody || !beam.MayIntersect(shape)) {
      return;
    }
    float near[kBatch];
    eyes.Lines.ComputeNearness(shape, eyes.Count, near);
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (!(near[i] < 0.0F) && eyes.Sights[i] == SEyeBatch::ESight::Clear &&
          index.Intersect(shape, CRay3(eyes.Positions[i], light)) <= 1.0) {
        eyes.Sights[i] = SEyeBatch::ESight::Blocked;
        --numClear;
      }
    }
  };
  index.ForShapesAlongRay(CRay3(eyes.Center, light), reach, test,
                          [&numClear] { return numClear == 0; });
}

void CLightDefaultSensor::Show(const CVector3& light, const SEyeBatch& eyes) const {
  for (size_t i = 0; i < eyes.Count; ++i) {
    if (eyes.Sights[i] != SEyeBatch::ESight::Behind) {
      m_caster.GetRobot().AddCheckedRay(eyes.Sights[i] == SEyeBatch::ESight::Blocked,
                                        CRay3(eyes.Positions[i], light));
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
