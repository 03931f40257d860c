#include <argos3/plugins/robots/eye-bot/simulator/eyebot_appearance.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_measures.h>
#include <argos3/plugins/robots/generic/simulator/visual_parts.h>

namespace argos {

namespace {

using EKind = SVisualPart::EKind;

// estimated from photographs, except for the values in eyebot_measures.h
constexpr CColor kCarbon(34, 36, 40);
constexpr CColor kElectronics(58, 62, 70);
constexpr CColor kMetal(176, 180, 186);
constexpr CColor kHoop(226, 228, 232);
constexpr CColor kBlade(44, 46, 52);
constexpr CColor kSweptDisc(126, 138, 150, 64);
constexpr CColor kHeadingMark(245, 160, 20);
constexpr CColor kLens(16, 18, 26);

// m
constexpr Real kHoopElevation =
    0.5 * (eyebot::kLowerLEDRingElevation + eyebot::kUpperLEDRingElevation);
constexpr Real kHoopThickness = 0.018;
constexpr Real kArmHeight = 0.012;
constexpr Real kRotorDistance = 0.142;  // distance of its axis from the robot's
constexpr Real kRotorRadius = 0.088;
constexpr Real kUpperRotor = 0.205;  // height
constexpr Real kLowerRotor = 0.118;
constexpr Real kCoreRadius = 0.046;
constexpr Real kCoreTop = 0.235;
constexpr Real kFootDistance = 0.11;

// @return a point of the plane, relative to the robot's axis
CVector3 At(Real distance, const CRadians& angle) {
  return CVector3(distance * Cos(angle), distance * Sin(angle), 0.0);
}

void AddRotor(SAppearance& robot, const CVector3& axis, Real height, const CRadians& blades) {
  constexpr Real kThickness = 0.0025;
  const CVector3 centre = axis + CVector3(0.0, 0.0, height);
  AddPart(robot, EKind::Box, centre, CVector3(1.94 * kRotorRadius, 0.016, kThickness), kBlade)
      .Orientation.FromAngleAxis(blades, CVector3::Z);
  AddDisc(robot, 0.011, height - 0.004, height + 0.008, kMetal, axis, EMaterial::Metal);
  AddDisc(robot, kRotorRadius, height + 0.0005, height + 0.002, kSweptDisc, axis);
}

// an arm with its motors and two counter-rotating propellers
void AddArm(SAppearance& robot, const CRadians& angle) {
  constexpr Real kMotorRadius = 0.014;
  const Real bottom = kHoopElevation - 0.5 * kArmHeight;
  const Real length = eyebot::kBodyRadius - kHoopThickness;
  AddPart(robot, EKind::Box, At(0.5 * length, angle) + CVector3(0.0, 0.0, bottom),
          CVector3(length, 0.018, kArmHeight), kCarbon)
      .Orientation.FromAngleAxis(angle, CVector3::Z);
  const CVector3 axis = At(kRotorDistance, angle);
  AddDisc(robot, kMotorRadius, kLowerRotor, kUpperRotor, kElectronics, axis);
  AddRotor(robot, axis, kUpperRotor, angle + ToRadians(CDegrees(35.0)));
  AddRotor(robot, axis, kLowerRotor, angle - ToRadians(CDegrees(55.0)));
}

void AddLeg(SAppearance& robot, const CRadians& angle) {
  const CVector3 foot = At(kFootDistance, angle);
  AddDisc(robot, 0.005, 0.0, kHoopElevation, kCarbon, foot);
  AddDisc(robot, 0.012, 0.0, 0.008, kElectronics, foot);
  // a strut from the leg to the core
  AddPart(robot, EKind::Box, 0.5 * foot + CVector3(0.0, 0.0, kHoopElevation - 0.005),
          CVector3(kFootDistance, 0.008, 0.006), kCarbon)
      .Orientation.FromAngleAxis(angle, CVector3::Z);
}

void AddLEDs(SAppearance& robot) {
  constexpr Real kDiameter = 0.011;
  SVisualLEDRing ring = {0, eyebot::kNumRingLEDs, eyebot::kLEDRingStartAngle,
                         eyebot::kLEDRingRadius, eyebot::kLowerLEDRingElevation};
  AddLEDRing(robot, ring, kDiameter, kHoop);
  ring.First = eyebot::kNumRingLEDs;
  ring.Elevation = eyebot::kUpperLEDRingElevation;
  AddLEDRing(robot, ring, kDiameter, kHoop);
  const CVector3 extra = At(eyebot::kExtraLEDRadius, ToRadians(CDegrees(eyebot::kExtraLEDAngle))) +
                         CVector3(0.0, 0.0, eyebot::kExtraLEDElevation);
  AddLED(robot, 2 * eyebot::kNumRingLEDs, extra, kDiameter, kHoop);
}

}  // namespace

SAppearance MakeEyeBotAppearance() {
  SAppearance robot;
  // core: camera below, electronics, mark of the heading
  AddDisc(robot, 0.024, 0.066, 0.09, kCarbon);
  AddPart(robot, EKind::Sphere, CVector3(0.0, 0.0, 0.068), CVector3(0.032, 0.032, 0.032), kLens,
          EMaterial::Glass);
  AddDisc(robot, kCoreRadius, 0.09, kCoreTop, kElectronics);
  AddDisc(robot, kCoreRadius + 0.003, kHoopElevation - 0.01, kHoopElevation + 0.01, kMetal,
          CVector3(), EMaterial::Metal);
  AddPart(robot, EKind::Box, CVector3(0.025, 0.0, kCoreTop), CVector3(0.04, 0.016, 0.005),
          kHeadingMark);
  AddPart(robot, EKind::Box,
          CVector3(eyebot::kBodyRadius - 0.5 * kHoopThickness, 0.0, kHoopElevation),
          CVector3(kHoopThickness, 0.04, 0.6 * kHoopThickness), kHeadingMark);
  // mast, and the device for attaching to a ceiling
  AddDisc(robot, 0.009, kCoreTop, 0.535, kCarbon);
  AddDisc(robot, 0.02, 0.51, 0.54, kElectronics);
  AddDisc(robot, 0.05, 0.54, eyebot::kBodyHeight, kMetal, CVector3(), EMaterial::Metal);
  for (UInt32 i = 0; i < 4; ++i) {
    AddArm(robot, ToRadians(CDegrees(45.0 + 90.0 * i)));
    AddLeg(robot, ToRadians(CDegrees(90.0 * i)));
  }
  // the hoop around everything that carries the LEDs
  AddPart(robot, EKind::Ring, CVector3(0.0, 0.0, kHoopElevation),
          CVector3(2.0 * eyebot::kBodyRadius, 2.0 * eyebot::kBodyRadius, kHoopThickness), kHoop);
  AddLEDs(robot);
  return robot;
}

}  // namespace argos
