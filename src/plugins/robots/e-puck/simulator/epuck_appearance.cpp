#include <argos3/plugins/robots/e-puck/simulator/epuck_appearance.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_measures.h>

namespace argos {

namespace {

// drawn by eye after photographs, except for what epuck_measures.h says
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
void AddWheel(SAppearance& robot, Real side) {
  const auto addDisc = [&robot, side](Real radius, Real width, const CColor& color) {
    SVisualPart disc = Part(
        SVisualPart::EKind::Cylinder,
        CVector3(0.0, side * 0.5 * epuck::kInterwheelDistance + 0.5 * width, epuck::kWheelRadius),
        CVector3(2.0 * radius, 2.0 * radius, width), color);
    // the axis along y: the cylinder's own axis is z
    disc.Orientation.FromAngleAxis(CRadians::PI_OVER_TWO, CVector3::X);
    robot.Parts.push_back(disc);
  };
  addDisc(epuck::kWheelRadius, 0.004, kWheel);
  addDisc(0.4 * epuck::kWheelRadius, 0.006, kHub);
}

// a ring on four struts that carries the LEDs
void AddLightGuide(SAppearance& robot) {
  constexpr Real kRingThickness = 0.006;
  constexpr Real kRingElevation = epuck::kLEDRingElevation - 0.002;
  constexpr Real kBoardElevation = 0.07;
  const Real diameter = 2.0 * epuck::kLEDRingRadius + kRingThickness;
  robot.Parts.push_back(Part(SVisualPart::EKind::Ring, CVector3(0.0, 0.0, kRingElevation),
                             CVector3(diameter, diameter, kRingThickness), kTranslucentBody));
  for (int i = 0; i < 4; ++i) {
    const CRadians angle = ToRadians(CDegrees(45.0 + 90.0 * i));
    constexpr Real kRadius = 0.0375;
    SVisualPart strut =
        Part(SVisualPart::EKind::Box,
             CVector3(kRadius * Cos(angle), kRadius * Sin(angle), kBoardElevation),
             CVector3(0.01, 0.004, kRingElevation - kBoardElevation), kTranslucentBody);
    strut.Orientation.FromAngleAxis(angle, CVector3::Z);
    robot.Parts.push_back(strut);
  }
}

void AddLEDs(SAppearance& robot) {
  for (UInt32 i = 0; i < epuck::kNumLEDs; ++i) {
    const CRadians angle =
        ToRadians(CDegrees(epuck::kLEDRingStartAngle + 360.0 / epuck::kNumLEDs * i));
    SVisualPart led = Part(SVisualPart::EKind::LED,
                           CVector3(epuck::kLEDRingRadius * Cos(angle),
                                    epuck::kLEDRingRadius * Sin(angle), epuck::kLEDRingElevation),
                           CVector3(0.008, 0.008, 0.008), kLED);
    led.LED = i;
    robot.Parts.push_back(led);
  }
}

}  // namespace

SAppearance MakeEPuckAppearance() {
  using epuck::kBodyRadius;
  SAppearance robot;
  AddWheel(robot, 1.0);
  AddWheel(robot, -1.0);
  // battery and motors inside the translucent body, between the wheels
  robot.Parts.push_back(Part(SVisualPart::EKind::Box, CVector3(0.0, 0.0, 0.006),
                             CVector3(0.044, 0.034, 0.026), kBattery));
  robot.Parts.push_back(Part(SVisualPart::EKind::Box, CVector3(0.0, 0.0, 0.004),
                             CVector3(0.058, 0.042, 0.038), kTranslucentBody));
  // main board with its ring of contacts, spacers, extension board, speaker
  robot.Parts.push_back(Disc(kBodyRadius, 0.042, 0.046, kCircuitBoard));
  robot.Parts.push_back(Disc(kBodyRadius - 0.002, 0.046, 0.0475, kGold));
  robot.Parts.push_back(Disc(kBodyRadius - 0.006, 0.0475, 0.056, kTranslucentBody));
  robot.Parts.push_back(Disc(0.022, 0.0475, 0.068, kBattery));
  robot.Parts.push_back(Disc(kBodyRadius - 0.001, 0.068, 0.072, kTopBoard));
  robot.Parts.push_back(Disc(0.014, 0.072, 0.08, kSpeaker));
  AddLightGuide(robot);
  // which way it looks
  robot.Parts.push_back(Part(SVisualPart::EKind::Box, CVector3(0.0225, 0.0, 0.072),
                             CVector3(0.021, 0.009, 0.003), kHeadingMark));
  AddLEDs(robot);
  return robot;
}

}  // namespace argos
