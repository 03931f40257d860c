#include <argos3/plugins/robots/e-puck/simulator/epuck_appearance.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_measures.h>
#include <argos3/plugins/robots/generic/simulator/visual_parts.h>

namespace argos {

namespace {

// estimated from photographs, except for the values in epuck_measures.h
constexpr CColor kTranslucentBody(205, 228, 190, 190);
constexpr CColor kBattery(70, 78, 70);
constexpr CColor kWheel(30, 30, 32);
constexpr CColor kHub(190, 192, 196);
constexpr CColor kCircuitBoard(34, 122, 62);
constexpr CColor kGold(212, 172, 72);
constexpr CColor kTopBoard(168, 32, 36);
constexpr CColor kSpeaker(40, 40, 44);
constexpr CColor kHeadingMark(250, 210, 60);
constexpr CColor kLED(214, 216, 220);

// side: 1 left, -1 right
void AddWheel(SAppearance& robot, Real side) {
  const auto addDisc = [&robot, side](Real radius, Real width, const CColor& color,
                                      EMaterial material) {
    // rotates the axis of the cylinder from z to y
    AddPart(
        robot, SVisualPart::EKind::Cylinder,
        CVector3(0.0, side * 0.5 * epuck::kInterwheelDistance + 0.5 * width, epuck::kWheelRadius),
        CVector3(2.0 * radius, 2.0 * radius, width), color, material)
        .Orientation.FromAngleAxis(CRadians::PI_OVER_TWO, CVector3::X);
  };
  addDisc(epuck::kWheelRadius, 0.004, kWheel, EMaterial::Matte);
  addDisc(0.4 * epuck::kWheelRadius, 0.006, kHub, EMaterial::Metal);
}

// a ring on four struts that carries the LEDs
void AddLightGuide(SAppearance& robot) {
  constexpr Real kRingThickness = 0.006;
  constexpr Real kRingElevation = epuck::kLEDRingElevation - 0.002;
  constexpr Real kBoardElevation = 0.07;
  const Real diameter = 2.0 * epuck::kLEDRingRadius + kRingThickness;
  AddPart(robot, SVisualPart::EKind::Ring, CVector3(0.0, 0.0, kRingElevation),
          CVector3(diameter, diameter, kRingThickness), kTranslucentBody);
  for (int i = 0; i < 4; ++i) {
    const CRadians angle = ToRadians(CDegrees(45.0 + 90.0 * i));
    constexpr Real kRadius = 0.0375;
    AddPart(robot, SVisualPart::EKind::Box,
            CVector3(kRadius * Cos(angle), kRadius * Sin(angle), kBoardElevation),
            CVector3(0.01, 0.004, kRingElevation - kBoardElevation), kTranslucentBody)
        .Orientation.FromAngleAxis(angle, CVector3::Z);
  }
}

}  // namespace

SAppearance MakeEPuckAppearance() {
  using epuck::kBodyRadius;
  SAppearance robot;
  AddWheel(robot, 1.0);
  AddWheel(robot, -1.0);
  // battery and motors inside the translucent body, between the wheels
  AddPart(robot, SVisualPart::EKind::Box, CVector3(0.0, 0.0, 0.006), CVector3(0.044, 0.034, 0.026),
          kBattery);
  AddPart(robot, SVisualPart::EKind::Box, CVector3(0.0, 0.0, 0.004), CVector3(0.058, 0.042, 0.038),
          kTranslucentBody);
  // main board with its ring of contacts, spacers, extension board, speaker
  AddDisc(robot, kBodyRadius, 0.042, 0.046, kCircuitBoard);
  AddDisc(robot, kBodyRadius - 0.002, 0.046, 0.0475, kGold, CVector3(), EMaterial::Metal);
  AddDisc(robot, kBodyRadius - 0.006, 0.0475, 0.056, kTranslucentBody);
  AddDisc(robot, 0.022, 0.0475, 0.068, kBattery);
  AddDisc(robot, kBodyRadius - 0.001, 0.068, 0.072, kTopBoard);
  AddDisc(robot, 0.014, 0.072, 0.08, kSpeaker);
  AddLightGuide(robot);
  // mark of the heading
  AddPart(robot, SVisualPart::EKind::Box, CVector3(0.0225, 0.0, 0.072),
          CVector3(0.021, 0.009, 0.003), kHeadingMark);
  AddLEDRing(robot,
             {0, epuck::kNumLEDs, epuck::kLEDRingStartAngle, epuck::kLEDRingRadius,
              epuck::kLEDRingElevation},
             0.008, kLED);
  return robot;
}

}  // namespace argos
