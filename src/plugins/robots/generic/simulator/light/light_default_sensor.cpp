#include <argos3/plugins/robots/generic/simulator/light_default_sensor.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/light_eyes.h>
#include <argos3/plugins/robots/generic/simulator/planar_rays.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>
#include <argos3/plugins/simulator/entities/lights.h>

#include <algorithm>
#include <cmath>
#include <typeinfo>

namespace argos {

namespace {

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

struct CLightDefaultSensor::SEyes : SLightEyes {
  // The lines from the sensors to a light.
  using TLines = SPlanarRays<kCapacity>;

  TLines MakeLines() const {
    TLines lines;
    lines.SetCenter(Center.GetX(), Center.GetY());
    for (size_t i = 0; i < Count; ++i) {
      lines.Set(i, X[i], Y[i], DX[i], DY[i]);
    }
    return lines;
  }
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
    SEyes eyes;
    for (size_t first = 0; first < m_tReadings.size(); first += SEyes::kCapacity) {
      eyes.Place(layout, m_pcLightEntity->GetAnchors(), first,
                 std::min(SEyes::kCapacity, m_tReadings.size() - first));
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

void CLightDefaultSensor::AddLights(SEyes& eyes) {
  for (const CLightEntity* light : m_lights->Get()) {
    const Real intensity = light->GetIntensity();
    if (intensity <= 0.0) {
      continue;
    }
    // a periodic arena has images of the light: the nearest one counts
    const CVector3 place =
        m_cSpace.GetContext().Arena.Period.FindNearest(light->GetPosition(), eyes.Center);
    const size_t numAhead = eyes.LookAt(place);
    if (numAhead == 0) {
      continue;
    }
    if (m_bShowRays) {
      FindOccludedAndShow(place, eyes, numAhead);
    } else {
      FindOccluded(place, eyes, numAhead);
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

// queries the index once for the solids near the segments, and tests all segments against them
void CLightDefaultSensor::FindOccluded(const CVector3& light, SEyes& eyes, size_t numClear) const {
  if (m_caster.AreBodiesOutsideIndex()) {
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (eyes.IsClear[i] != 0 && m_caster.IsBlocked(CRay3(eyes.GetPosition(i), light))) {
        eyes.IsClear[i] = 0;
      }
    }
    return;
  }
  const CBodyIndex& index = m_caster.GetSpace().GetBodyIndex();
  const UInt32 ownBody = m_caster.GetBody().GetBodyNumber();
  const SBeam beam = {eyes.Center, light, eyes.Reach, eyes.MinZ, eyes.MaxZ};
  const SRayReach reach{eyes.Reach,
                        std::max(eyes.MaxZ - eyes.Center.GetZ(), eyes.Center.GetZ() - eyes.MinZ)};
  SEyes::TLines lines;
  bool haveLines = false;
  const auto test = [&](const SIndexedShape& shape) {
    if (shape.Body == ownBody || !beam.MayIntersect(shape)) {
      return;
    }
    if (!haveLines) {
      lines = eyes.MakeLines();
      haveLines = true;
    }
    float near[SEyes::kCapacity];
    lines.ComputeNearness(shape, eyes.Count, near);
    for (size_t i = 0; i < eyes.Count; ++i) {
      if (!(near[i] < 0.0F) && eyes.IsClear[i] != 0 &&
          index.Intersect(shape, CRay3(eyes.GetPosition(i), light)) <= 1.0) {
        eyes.IsClear[i] = 0;
        --numClear;
      }
    }
  };
  index.ForShapesAlongRays(std::array{CRay3(eyes.Center, light)}, reach, test,
                           [&numClear] { return numClear == 0; });
}

// the lines to the light are shown of the sensors that it is not behind
void CLightDefaultSensor::FindOccludedAndShow(const CVector3& light, SEyes& eyes,
                                              size_t numClear) const {
  UInt64 isAhead[SEyes::kCapacity];
  std::copy_n(eyes.IsClear, eyes.Count, isAhead);
  FindOccluded(light, eyes, numClear);
  for (size_t i = 0; i < eyes.Count; ++i) {
    if (isAhead[i] != 0) {
      m_caster.GetRobot().AddCheckedRay(eyes.IsClear[i] == 0, CRay3(eyes.GetPosition(i), light));
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
