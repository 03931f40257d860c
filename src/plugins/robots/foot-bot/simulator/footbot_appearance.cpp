#include <argos3/plugins/robots/foot-bot/simulator/footbot_appearance.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>
#include <argos3/plugins/robots/generic/simulator/visual_parts.h>

namespace argos {

namespace {

// estimated from photographs, except for the values in footbot_measures.h
constexpr CColor kBlackPlastic(38, 40, 44);
constexpr CColor kTrack(22, 22, 24);
constexpr CColor kMetal(170, 174, 180);
constexpr CColor kRing(214, 216, 220);
constexpr CColor kTurret(62, 66, 74);
constexpr CColor kGripper(214, 48, 38);
constexpr CColor kHeadingMark(245, 160, 20);
constexpr CColor kCameraTube(200, 215, 225, 110);
const char* const kTurretAnchor = "turret";

// side: 1 left, -1 right
void AddTrackAndWheel(SAppearance& robot, Real side) {
  using footbot::kWheelRadius;
  constexpr Real kTrackWidth = 0.02;
  constexpr Real kTrackLength = 0.11;
  constexpr Real kWheelWidth = 0.012;
  const Real wheelY = 0.5 * footbot::kInterwheelDistance;
  AddPart(robot, SVisualPart::EKind::Box, CVector3(0.0, side * (wheelY - 0.03), 0.002),
          CVector3(kTrackLength, kTrackWidth, 0.04), kTrack, EMaterial::Matte);
  // rotates the axis of the cylinder from z to y
  AddPart(robot, SVisualPart::EKind::Cylinder,
          CVector3(0.0, side * wheelY + 0.5 * kWheelWidth, kWheelRadius),
          CVector3(2.0 * kWheelRadius, 2.0 * kWheelRadius, kWheelWidth), kTrack, EMaterial::Matte)
      .Orientation.FromAngleAxis(CRadians::PI_OVER_TWO, CVector3::X);
}

void AddTurret(SAppearance& robot) {
  const size_t first = robot.Parts.size();
  constexpr Real kRingBottom = 0.077;
  constexpr Real kRingTop = 0.093;
  AddDisc(robot, footbot::kBodyRadius, kRingBottom, kRingTop, kTurret);
  AddPart(robot, SVisualPart::EKind::Box,
          CVector3(footbot::kBodyRadius + 0.002, 0.0, kRingBottom + 0.002),
          CVector3(0.016, 0.03, 0.012), kGripper);
  AddLEDRing(robot,
             {0, footbot::kNumRingLEDs, footbot::kLEDRingStartAngle, footbot::kLEDRingRadius,
              footbot::kLEDRingElevation},
             0.014, kRing);
  AddLED(robot, footbot::kNumRingLEDs, CVector3(0.0, 0.0, footbot::kBeaconElevation), 0.04, kRing);
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
  AddDisc(robot, footbot::kBodyRadius - 0.004, 0.03, 0.052, kBlackPlastic);
  AddDisc(robot, footbot::kBodyRadius, 0.052, 0.07, kRing);
  AddDisc(robot, footbot::kBodyRadius - 0.006, 0.07, 0.077, kBlackPlastic);
  AddTurret(robot);
  AddDisc(robot, footbot::kBodyRadius - 0.012, 0.093, 0.128, kBlackPlastic);
  AddDisc(robot, footbot::kBodyRadius - 0.006, 0.128, 0.132, kMetal, CVector3(), EMaterial::Metal);
  AddDisc(robot, footbot::kBodyRadius - 0.02, 0.132, footbot::kBodyHeight, kBlackPlastic);
  // mark of the heading
  AddPart(robot, SVisualPart::EKind::Box, CVector3(0.047, 0.0, footbot::kBodyHeight),
          CVector3(0.05, 0.016, 0.004), kHeadingMark);
  // camera: a tube with a mirror on top
  constexpr Real kTubeRadius = 0.016;
  AddDisc(robot, kTubeRadius + 0.006, footbot::kBodyHeight, 0.156, kMetal, CVector3(),
          EMaterial::Metal);
  AddDisc(robot, kTubeRadius, 0.156, footbot::kOmnidirectionalCameraElevation - 0.02, kCameraTube,
          CVector3(), EMaterial::Glass);
  AddDisc(robot, kTubeRadius + 0.004, footbot::kOmnidirectionalCameraElevation - 0.02,
          footbot::kOmnidirectionalCameraElevation, kBlackPlastic);
  return robot;
}

}  // namespace argos
