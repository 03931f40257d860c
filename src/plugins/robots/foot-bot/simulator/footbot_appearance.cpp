#include <argos3/plugins/robots/foot-bot/simulator/footbot_appearance.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>

namespace argos {

namespace {

// drawn by eye after photographs, except for what footbot_measures.h says
constexpr CColor kBlackPlastic(38, 40, 44);
constexpr CColor kTrack(22, 22, 24);
constexpr CColor kMetal(170, 174, 180);
constexpr CColor kRing(214, 216, 220);
constexpr CColor kTurret(62, 66, 74);
constexpr CColor kGripper(214, 48, 38);
constexpr CColor kHeadingMark(245, 160, 20);
constexpr CColor kCameraTube(200, 215, 225, 110);
const char* const kTurretAnchor = "turret";

SVisualPart Part(SVisualPart::EKind kind, const CVector3& position, const CVector3& size,
                 const CColor& color) {
  SVisualPart part;
  part.Kind = kind;
  part.Position = position;
  part.Size = size;
  part.Color = color;
  return part;
}

SVisualPart Disc(Real radius, Real bottom, Real top, const CColor& color) {
  return Part(SVisualPart::EKind::Cylinder, CVector3(0.0, 0.0, bottom),
              CVector3(2.0 * radius, 2.0 * radius, top - bottom), color);
}

// side: 1 left, -1 right
void AddTrackAndWheel(SAppearance& robot, Real side) {
  using footbot::kWheelRadius;
  constexpr Real kTrackWidth = 0.02;
  constexpr Real kTrackLength = 0.11;
  constexpr Real kWheelWidth = 0.012;
  const Real wheelY = 0.5 * footbot::kInterwheelDistance;
  robot.Parts.push_back(Part(SVisualPart::EKind::Box, CVector3(0.0, side * (wheelY - 0.03), 0.002),
                             CVector3(kTrackLength, kTrackWidth, 0.04), kTrack));
  // the axis along y: the cylinder's own axis is z
  SVisualPart wheel = Part(SVisualPart::EKind::Cylinder,
                           CVector3(0.0, side * wheelY + 0.5 * kWheelWidth, kWheelRadius),
                           CVector3(2.0 * kWheelRadius, 2.0 * kWheelRadius, kWheelWidth), kTrack);
  wheel.Orientation.FromAngleAxis(CRadians::PI_OVER_TWO, CVector3::X);
  robot.Parts.push_back(wheel);
}

void AddTurret(SAppearance& robot) {
  const size_t first = robot.Parts.size();
  constexpr Real kRingBottom = 0.077;
  constexpr Real kRingTop = 0.093;
  robot.Parts.push_back(Disc(footbot::kBodyRadius, kRingBottom, kRingTop, kTurret));
  robot.Parts.push_back(Part(SVisualPart::EKind::Box,
                             CVector3(footbot::kBodyRadius + 0.002, 0.0, kRingBottom + 0.002),
                             CVector3(0.016, 0.03, 0.012), kGripper));
  for (UInt32 i = 0; i < footbot::kNumRingLEDs; ++i) {
    const CRadians angle =
        ToRadians(CDegrees(footbot::kLEDRingStartAngle + 360.0 / footbot::kNumRingLEDs * i));
    SVisualPart led =
        Part(SVisualPart::EKind::LED,
             CVector3(footbot::kLEDRingRadius * Cos(angle), footbot::kLEDRingRadius * Sin(angle),
                      footbot::kLEDRingElevation),
             CVector3(0.014, 0.014, 0.014), kRing);
    led.LED = i;
    robot.Parts.push_back(led);
  }
  SVisualPart beacon = Part(SVisualPart::EKind::LED, CVector3(0.0, 0.0, footbot::kBeaconElevation),
                            CVector3(0.04, 0.04, 0.04), kRing);
  beacon.LED = footbot::kNumRingLEDs;
  robot.Parts.push_back(beacon);
  for (size_t i = first; i < robot.Parts.size(); ++i) {
    robot.Parts[i].Anchor = kTurretAnchor;
  }
}

}  // namespace

SAppearance MakeFootBotAppearance() {
  SAppearance robot;
  AddTrackAndWheel(robot, 1.0);
  AddTrackAndWheel(robot, -1.0);
  // base, ring of sensors, turret, electronics
  robot.Parts.push_back(Disc(footbot::kBodyRadius - 0.004, 0.03, 0.052, kBlackPlastic));
  robot.Parts.push_back(Disc(footbot::kBodyRadius, 0.052, 0.07, kRing));
  robot.Parts.push_back(Disc(footbot::kBodyRadius - 0.006, 0.07, 0.077, kBlackPlastic));
  AddTurret(robot);
  robot.Parts.push_back(Disc(footbot::kBodyRadius - 0.012, 0.093, 0.128, kBlackPlastic));
  robot.Parts.push_back(Disc(footbot::kBodyRadius - 0.006, 0.128, 0.132, kMetal));
  robot.Parts.push_back(
      Disc(footbot::kBodyRadius - 0.02, 0.132, footbot::kBodyHeight, kBlackPlastic));
  // which way it looks
  robot.Parts.push_back(Part(SVisualPart::EKind::Box, CVector3(0.047, 0.0, footbot::kBodyHeight),
                             CVector3(0.05, 0.016, 0.004), kHeadingMark));
  // camera: a tube with a mirror on top
  constexpr Real kTubeRadius = 0.016;
  robot.Parts.push_back(Disc(kTubeRadius + 0.006, footbot::kBodyHeight, 0.156, kMetal));
  robot.Parts.push_back(
      Disc(kTubeRadius, 0.156, footbot::kOmnidirectionalCameraElevation - 0.02, kCameraTube));
  robot.Parts.push_back(Disc(kTubeRadius + 0.004, footbot::kOmnidirectionalCameraElevation - 0.02,
                             footbot::kOmnidirectionalCameraElevation, kBlackPlastic));
  return robot;
}

}  // namespace argos
