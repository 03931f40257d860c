#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_rotzonly_sensor.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/units.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr int kHeadsOfARange = 2;
constexpr int kSamplesOfATick = 6;  // number while it rotates
constexpr size_t kMaxBeams = 2 * kHeadsOfARange * kSamplesOfATick;
constexpr Real kRounding = 1e-9;  // m
static_assert(kSamplesOfATick <= SRayBlock::kSize, "the beams of a head are one block");

// @return the same angle in [0, 2 PI)
Real WrapTurn(Real angle) {
  const Real wrapped = std::fmod(angle, 2.0 * ARGOS_PI);
  return wrapped < 0.0 ? wrapped + 2.0 * ARGOS_PI : wrapped;
}

// @return the turn from the previous angle to the current one, in the direction of rotation
Real ComputeSweep(const CFootBotDistanceScannerEquippedEntity& scanner) {
  const Real difference = (scanner.GetRotation() - scanner.GetPreviousRotation()).GetValue();
  return scanner.GetRotationSpeed() < 0.0 ? -WrapTurn(-difference) : WrapTurn(difference);
}

SSensorRay MakeBeam(const CFootBotDistanceScannerEquippedEntity::SMount& mount,
                    const CRadians& angle, Real range) {
  const CVector3 outward(Cos(angle), Sin(angle), 0.0);
  SSensorRay beam;
  beam.Offset = outward * mount.Radius + CVector3(0.0, 0.0, mount.Elevation);
  beam.Direction = outward * range;
  return beam;
}

// the beams of one head in a tick; those of the heads of a range alternate
struct SHeadBeams {
  const SSensorRay* First;
  size_t Count;

  const SSensorRay& operator[](size_t sample) const { return First[sample * kHeadsOfARange]; }
};

// a circle around the mean of the middles of the beams
SRayBounds ComputeBounds(const SHeadBeams& beams) {
  SRayBounds bounds;
  for (size_t i = 0; i < beams.Count; ++i) {
    const CVector3 middle = beams[i].Offset + 0.5 * beams[i].Direction;
    bounds.CenterX += middle.GetX() / static_cast<Real>(beams.Count);
    bounds.CenterY += middle.GetY() / static_cast<Real>(beams.Count);
    bounds.Include(beams[i], i == 0);
  }
  Real squareReach = 0.0;
  for (size_t i = 0; i < beams.Count; ++i) {
    const Real startX = beams[i].Offset.GetX() - bounds.CenterX;
    const Real startY = beams[i].Offset.GetY() - bounds.CenterY;
    const Real endX = startX + beams[i].Direction.GetX();
    const Real endY = startY + beams[i].Direction.GetY();
    squareReach =
        std::max({squareReach, startX * startX + startY * startY, endX * endX + endY * endY});
  }
  bounds.Reach = std::sqrt(squareReach) + kRounding;
  return bounds;
}

// writes the fractions of the beams at the same distances from each other as the beams
void CastHead(const CRayCaster& caster, const SAnchor& origin, const SHeadBeams& beams,
              Real* fractions) {
  SSensorRay rays[kSamplesOfATick];
  for (size_t i = 0; i < beams.Count; ++i) {
    rays[i] = beams[i];
  }
  SRayBlock block;
  FillBlocks(rays, beams.Count, &block);
  const SRayBounds bounds = ComputeBounds(beams);
  const SAnchor* const anchor = &origin;
  Real found[kSamplesOfATick];
  caster.Cast({rays, &block, beams.Count, bounds, &anchor, origin}, found);
  for (size_t i = 0; i < beams.Count; ++i) {
    fractions[i * kHeadsOfARange] = found[i];
  }
}

}  // namespace

void CFootBotDistanceScannerRotZOnlySensor::FindParts(CComposableEntity& robot) {
  m_caster.SetRobot(robot);
  m_scanner = &robot.GetComponent<CFootBotDistanceScannerEquippedEntity>("distance_scanner");
  m_scanner->Enable();
}

void CFootBotDistanceScannerRotZOnlySensor::Configure(TConfigurationNode& tree) {
  GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, false);
  m_noise.Init(tree, *m_robot, {"distance"}, {ReadNoiseRange(tree, "noise_range")});
  m_shortReadings.reserve(kHeadsOfARange * kSamplesOfATick);
  m_longReadings.reserve(kHeadsOfARange * kSamplesOfATick);
}

void CFootBotDistanceScannerRotZOnlySensor::Update() {
  m_shortReadings.clear();
  m_longReadings.clear();
  switch (m_scanner->GetMode()) {
    case CFootBotDistanceScannerEquippedEntity::MODE_OFF:
      break;
    case CFootBotDistanceScannerEquippedEntity::MODE_POSITION_CONTROL:
      AddBeams(m_scanner->GetRotation());
      break;
    case CFootBotDistanceScannerEquippedEntity::MODE_SPEED_CONTROL: {
      const Real sweep = ComputeSweep(*m_scanner);
      for (int sample = 0; sample < kSamplesOfATick; ++sample) {
        AddBeams(m_scanner->GetPreviousRotation() + CRadians(sweep * sample / kSamplesOfATick));
      }
      break;
    }
  }
  Cast();
  SetReadings(m_shortReadings, m_longReadings);
}

void CFootBotDistanceScannerRotZOnlySensor::AddBeams(const CRadians& scanner) {
  for (int head = 0; head < kHeadsOfARange; ++head) {
    const CRadians angle = scanner + CRadians::PI * head;
    m_shortReadings.push_back({CRadians(angle).SignedNormalize(), kNothing});
    m_longReadings.push_back({(angle + CRadians::PI_OVER_TWO).SignedNormalize(), kNothing});
  }
}

void CFootBotDistanceScannerRotZOnlySensor::Cast() {
  if (m_shortReadings.empty()) {
    return;
  }
  const CFootBotDistanceScannerEquippedEntity::SMount& mount = m_scanner->GetMount();
  SSensorRay beams[kMaxBeams];
  Real fractions[kMaxBeams];
  size_t count = 0;
  for (const SReading& reading : m_shortReadings) {
    beams[count++] = MakeBeam(mount, reading.Angle, footbot::kDistanceScannerShortMax);
  }
  for (const SReading& reading : m_longReadings) {
    beams[count++] = MakeBeam(mount, reading.Angle, footbot::kDistanceScannerLongMax);
  }
  // heads look in different directions: few bodies are near the beams of any one of them
  const SAnchor& origin = m_caster.GetBody().GetOriginAnchor();
  for (size_t range = 0; range < count; range += count / 2) {
    for (size_t head = 0; head < kHeadsOfARange; ++head) {
      CastHead(m_caster, origin, {beams + range + head, count / (2 * kHeadsOfARange)},
               fractions + range + head);
    }
  }
  if (m_showRays) {
    const SRayBounds bounds;
    const SAnchor* const anchor = &origin;
    m_caster.Show({beams, nullptr, count, bounds, &anchor, origin}, fractions);
  }
  const Real* fraction = fractions;
  for (SReading& reading : m_shortReadings) {
    reading.Distance = ToReading(*fraction++, footbot::kDistanceScannerShortMin,
                                 footbot::kDistanceScannerShortMax);
  }
  for (SReading& reading : m_longReadings) {
    reading.Distance =
        ToReading(*fraction++, footbot::kDistanceScannerLongMin, footbot::kDistanceScannerLongMax);
  }
}

Real CFootBotDistanceScannerRotZOnlySensor::ToReading(Real fraction, Real minimum, Real maximum) {
  if (fraction > 1.0) {
    return kNothing;
  }
  const Real distance = fraction * maximum;
  if (distance <= minimum) {
    return kTooClose;
  }
  return std::max(0.0, m_noise.Apply(0, kCentimetersPerMeter * distance));
}

void CFootBotDistanceScannerRotZOnlySensor::ResetReading() {
  SetReadings({}, {});
}

REGISTER_SENSOR(
    CFootBotDistanceScannerRotZOnlySensor, "footbot_distance_scanner", "rot_z_only",
    "the authors of this project", "1.0",
    "The distance scanner of the foot-bot, which the eye-bot may carry, too.",
    R"(Four heads rotate on the robot at a height of 12.32 cm (eye-bot: 16.35 cm) and look horizontally from the surface of its body: two for
short range, up to 26 cm, at the scanner's angle and opposite to it, and two for long range, from 12 to 142 cm, at right
angles to them. A reading is the distance to the first body on the beam, in cm from the surface of the robot's own body;
-2 if there is none in range; -1 if it is too close (long range: up to 12 cm; short range: 0). Readings are listed by the
angle of their beam in the robot's frame, in (-pi,pi].

The actuator footbot_distance_scanner must switch the scanner on. When off, it has no readings; at a fixed angle, 2 of
each range; while it rotates, 12 of each: the angle swept in the last tick is divided into six parts, and each head reads
at the beginning of each part.
)" +
        RequiredActuatorXML(R"(<footbot_distance_scanner implementation="default" />)",
                            R"(<footbot_distance_scanner implementation="rot_z_only" />)") +
        OptionalXML(
            R"(<footbot_distance_scanner implementation="rot_z_only" show_rays="true" noise_range="-0.5:0.5" />)") +
        R"(
  show_rays    "true" or "false", default "false": visualizations show the beams.
  noise_range  "min:max", cm, default "0:0": a number drawn evenly from it is added to each distance
               (not to -1 and -2); the sum is at least 0.
)" + NoiseManual("distance", "each distance (cm) in the same way."),
    "Usable")

}  // namespace argos
