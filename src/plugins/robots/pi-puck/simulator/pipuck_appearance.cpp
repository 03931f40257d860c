#include <argos3/plugins/robots/pi-puck/simulator/pipuck_appearance.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/generic/simulator/visual_parts.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_measures.h>

namespace argos {

namespace {

constexpr CColor kShell(191, 191, 191, 178);
constexpr CColor kBattery(0, 0, 191);
constexpr CColor kSilver(191, 191, 191);
constexpr CColor kBoard(0, 97, 41);
constexpr CColor kPost(97, 97, 97);
constexpr CColor kBlack(28, 28, 30);
constexpr CColor kTyre(12, 12, 12);
constexpr CColor kHub(230, 230, 230, 102);
constexpr CColor kLightGuide(191, 191, 191, 204);
constexpr CColor kLED(214, 216, 220);

// heights are above the ground
constexpr Real kBase = pipuck::kClearance;

void AddBox(SAppearance& robot, const CVector3& base, const CVector3& size, const CColor& color) {
  AddPart(robot, SVisualPart::EKind::Box, base, size, color);
}

// a cylinder along y whose middle is at @p middle
void AddAcross(SAppearance& robot, const CVector3& middle, Real radius, Real length,
               const CColor& color, EMaterial material = EMaterial::Plastic) {
  AddPart(robot, SVisualPart::EKind::Cylinder, middle + CVector3(0.0, 0.5 * length, 0.0),
          CVector3(2.0 * radius, 2.0 * radius, length), color, material)
      .Orientation.FromAngleAxis(CRadians::PI_OVER_TWO, CVector3::X);
}

// side: 1 left, -1 right
void AddWheel(SAppearance& robot, Real side) {
  constexpr Real kHubWidth = 0.008;
  constexpr Real kTyreWidth = 0.0024;
  const CVector3 middle(0.0, side * (pipuck::kWheelFaceY + 0.5 * kHubWidth), pipuck::kWheelRadius);
  AddAcross(robot, middle, 0.02, kHubWidth, kHub);
  AddAcross(robot, middle, pipuck::kWheelRadius, kTyreWidth, kTyre, EMaterial::Matte);
  AddAcross(robot, middle, 0.003, kHubWidth + 0.001, kSilver, EMaterial::Metal);
}

void AddBody(SAppearance& robot) {
  AddBox(robot, CVector3(0.0, 0.0, kBase + 0.0025), CVector3(0.048, 0.034, 0.01), kBattery);
  AddAcross(robot, CVector3(0.0, 0.0, kBase + 0.0217), 0.009, 0.032, kSilver, EMaterial::Metal);
  AddBox(robot, CVector3(0.0, 0.0, kBase), CVector3(0.054, 0.044, 0.036), kShell);
  AddDisc(robot, 0.035, kBase + 0.036, kBase + 0.0376, kBoard);
  AddPart(robot, SVisualPart::EKind::Ring, CVector3(0.0, 0.0, pipuck::kRingElevation),
          CVector3(2.0 * pipuck::kBodyRadius, 2.0 * pipuck::kBodyRadius, 0.006), kLightGuide);
  AddDisc(robot, 0.035, kBase + 0.0456, kBase + 0.0473, kBoard);
  for (int i = 0; i < 3; ++i) {
    const CRadians angle = ToRadians(CDegrees(60.0 + 120.0 * i));
    AddDisc(robot, 0.0025, kBase + 0.0376, kBase + 0.0456, kPost,
            CVector3(0.026 * Cos(angle), 0.026 * Sin(angle), 0.0));
  }
  // the computer with its header and connectors
  AddBox(robot, CVector3(0.0, 0.0, kBase + 0.0473), CVector3(0.005, 0.051, 0.0083), kBlack);
  AddBox(robot, CVector3(0.0, 0.0, kBase + 0.0556), CVector3(0.03, 0.065, 0.0016), kBoard);
  AddBox(robot, CVector3(-0.01, 0.0, kBase + 0.0572), CVector3(0.008, 0.04, 0.0036), kSilver);
}

void AddSensors(SAppearance& robot) {
  AddBox(robot, CVector3(0.0323, 0.0, kBase + 0.0235), CVector3(0.006, 0.017, 0.0125), kBlack);
  // the board of the ground sensors
  AddBox(robot, CVector3(0.0295, 0.0, kBase + 0.003), CVector3(0.001, 0.024, 0.02), kBoard);
  for (const Real y : {-0.01, 0.0, 0.01}) {
    AddBox(robot, CVector3(0.03, y, kBase), CVector3(0.004, 0.004, 0.003), kBlack);
  }
  // range sensors: small blocks below the main board, from the front clockwise
  constexpr Real kAzimuths[] = {-12.6, -46.9, -90.0, -140.9, 140.9, 90.0, 46.9, 12.6};  // degrees
  for (const Real azimuth : kAzimuths) {
    constexpr Real kRadius = 0.0325;
    const CRadians angle = ToRadians(CDegrees(azimuth));
    AddPart(robot, SVisualPart::EKind::Box,
            CVector3(kRadius * Cos(angle), kRadius * Sin(angle), kBase + 0.03),
            CVector3(0.004, 0.007, 0.006), kBlack)
        .Orientation.FromAngleAxis(angle, CVector3::Z);
  }
}

void AddLEDs(SAppearance& robot) {
  for (UInt32 i = 0; i < pipuck::kNumRingLEDs; ++i) {
    const CRadians azimuth = CRadians::TWO_PI * (-static_cast<Real>(i) / pipuck::kNumRingLEDs);
    AddLED(robot, i,
           CVector3(pipuck::kBodyRadius * Cos(azimuth), pipuck::kBodyRadius * Sin(azimuth),
                    pipuck::kRingElevation),
           0.007, kLED);
  }
  AddLED(robot, pipuck::kNumRingLEDs,
         CVector3(pipuck::kFrontLEDX, pipuck::kFrontLEDY, pipuck::kFrontLEDElevation), 0.0055,
         kLED);
  AddLED(robot, pipuck::kNumRingLEDs + 1, CVector3(0.0, 0.0, pipuck::kBodyLEDElevation), 0.012,
         kLED);
}

}  // namespace

SAppearance MakePiPuckAppearance() {
  SAppearance robot;
  AddWheel(robot, 1.0);
  AddWheel(robot, -1.0);
  AddBody(robot);
  AddSensors(robot);
  AddLEDs(robot);
  return robot;
}

}  // namespace argos
