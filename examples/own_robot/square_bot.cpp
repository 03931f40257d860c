#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/robots/generic/simulator/differential_drive_robot_entity.h>
#include <argos3/plugins/robots/generic/simulator/visual_parts.h>

using namespace argos;

// the body: what engines, sensors and placement see. Lengths in m, masses in kg
static SBodyDescription MakeBody() {
  SBodyDescription body;
  body.Shapes = {SShapeDescription::Box(CVector3(0.12, 0.12, 0.06))};
  body.Mass = 0.5;
  body.Drive = SDifferentialDriveDescription{0.1, 0.02, 1.5, 1.5};  // wheels; N and N m
  return body;
}

// what robots of this type share: devices, by default at the origin anchor, and parts to draw
static SRobotType MakeType() {
  auto leds = std::make_shared<CLEDEquippedEntity::SLayout>();
  leds->AddLED(CVector3(0.05, 0.0, 0.06));
  auto proximity = std::make_shared<CProximitySensorEquippedEntity::SLayout>();
  for (const Real y : {0.04, -0.04}) {  // two rays, 10 cm straight ahead
    proximity->AddSensor(CVector3(0.06, y, 0.03), CVector3::X, 0.1);
  }
  SRobotType type;
  type.LEDs = leds;
  type.Proximity = proximity;
  const auto box = SVisualPart::EKind::Box;
  AddPart(type.Appearance, box, CVector3(0.0, 0.0, 0.01), CVector3(0.12, 0.12, 0.05),
          CColor(230, 140, 30));
  for (const Real y : {0.05, -0.05}) {
    AddPart(type.Appearance, box, CVector3(0.0, y, 0.0), CVector3(0.04, 0.01, 0.04), CColor::BLACK);
  }
  AddLED(type.Appearance, 0, CVector3(0.05, 0.0, 0.06), 0.015, CColor::GRAY80);
  return type;
}

static const SDifferentialDriveRobotType& SquareBotType() {
  static const SDifferentialDriveRobotType type(MakeType(), MakeBody());
  return type;
}

class CSquareBotEntity : public CDifferentialDriveRobotEntity {
 public:
  ENABLE_VTABLE();
  CSquareBotEntity()
      : CDifferentialDriveRobotEntity(SquareBotType(), "", CVector3(), CQuaternion()) {}
  void Init(TConfigurationNode& tree) override {
    InitParts(tree);  // id, <body>, <tags>, <simple_radios>, ...
    InitController(tree);
  }
  std::string GetTypeDescription() const override { return "square-bot"; }
};

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CSquareBotEntity)

REGISTER_ENTITY(CSquareBotEntity, "square-bot", "A. Student", "1.0", "A square robot, 12 cm wide.",
                "Two wheels, two proximity rays ahead, one LED.", "Usable")
