#include <argos3/plugins/robots/pi-puck/simulator/pipuck_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/robots/generic/simulator/differential_drive_robot_entity.h>
#include <argos3/plugins/robots/generic/simulator/robot_manual.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_appearance.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_measures.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/read_medium.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>

namespace argos {

namespace {

SBodyDescription MakeBody() {
  return DescribeWheeledCylinder(pipuck::kBodyRadius, pipuck::kBodyHeight, pipuck::kMass,
                                 pipuck::kPlanarInertia,
                                 {pipuck::kInterwheelDistance, pipuck::kWheelRadius,
                                  pipuck::kMaxDriveForce, pipuck::kMaxDriveTorque});
}

const CSharedBodies& Bodies() {
  static const CSharedBodies bodies(MakeBody());
  return bodies;
}

}  // namespace

CPiPuckEntity::CPiPuckEntity() : CComposableEntity(nullptr) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0");
  m_body->SetBodyDescription(Bodies().Get(*Bodies().GetDefault().Drive));
  AddAnchors();
  m_drive = NewComponent<CPiPuckDifferentialDriveEntity>(*this, "differential_drive_0");
  m_radios = NewComponent<CSimpleRadioEquippedEntity>(*this, "simple_radios_0");
  m_leds = NewComponent<CDirectionalLEDEquippedEntity>(*this, "leds_0");
  AddLEDs();
  m_controllable = NewComponent<CControllableEntity>(*this, "controller_0");
}

// the z axes of the wheels point outward
void CPiPuckEntity::AddAnchors() {
  m_body->AddAnchor("body", CVector3(0.0, 0.0, pipuck::kClearance));
  m_body->AddAnchor("left_wheel", CVector3(0.0, pipuck::kWheelFaceY, pipuck::kWheelRadius),
                    CQuaternion(-CRadians::PI_OVER_TWO, CVector3::X));
  m_body->AddAnchor("right_wheel", CVector3(0.0, -pipuck::kWheelFaceY, pipuck::kWheelRadius),
                    CQuaternion(CRadians::PI_OVER_TWO, CVector3::X));
  for (const char* anchor : {"body", "left_wheel", "right_wheel"}) {
    m_body->EnableAnchor(anchor);
  }
}

void CPiPuckEntity::AddLEDs() {
  SAnchor& origin = m_body->GetOriginAnchor();
  const CRadians angle = ToRadians(CDegrees(pipuck::kLEDObservableAngle));
  const auto add = [&](const std::string& id, const CVector3& position) {
    m_leds->AddLED(id, position, CQuaternion(), origin, angle, CColor::BLACK);
  };
  for (UInt32 i = 0; i < pipuck::kNumRingLEDs; ++i) {
    const CRadians azimuth = CRadians::TWO_PI * (-static_cast<Real>(i) / pipuck::kNumRingLEDs);
    add("ring_led_" + std::to_string(i),
        CVector3(pipuck::kRingRadius * Cos(azimuth), pipuck::kRingRadius * Sin(azimuth),
                 pipuck::kRingElevation));
  }
  add("front_led", CVector3(pipuck::kFrontLEDX, pipuck::kFrontLEDY, pipuck::kFrontLEDElevation));
  add("body_led", CVector3(0.0, 0.0, pipuck::kBodyLEDElevation));
}

void CPiPuckEntity::Init(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  TConfigurationNode& body = GetNode(tree, "body");
  m_body->Init(body);
  InitDrive(tree);
  InitDrive(body);
  if (NodeAttributeExists(tree, "wifi_medium")) {
    auto& medium = ReadMedium<CSimpleRadioEntity::CRegistry>(
        tree, CurrentSimulator(), "a simple radio medium", "wifi_medium");
    m_radios->AddRadio("wifi", CVector3(0.0, 0.0, pipuck::kRadioElevation),
                       m_body->GetOriginAnchor(), medium, pipuck::kRadioRange);
    m_radios->Enable();
  }
  if (NodeAttributeExists(tree, "led_medium")) {
    m_leds->SetMedium(ReadMedium<CDirectionalLEDEntity::CRegistry>(
        tree, CurrentSimulator(), "a medium of directional LEDs", "led_medium"));
    m_leds->Enable();
  }
  m_controllable->Init(GetNode(tree, "controller"));
}

void CPiPuckEntity::InitDrive(TConfigurationNode& tree) {
  SDifferentialDriveDescription drive = *m_body->GetBodyDescription()->Drive;
  if (ReadDriveLimits(tree, drive)) {
    m_body->SetBodyDescription(Bodies().Get(drive));
  }
}

void CPiPuckEntity::UpdateComponents() {
  m_drive->Update();
  if (m_radios->IsEnabled()) {
    m_radios->Update();
  }
  if (m_leds->IsEnabled()) {
    m_leds->Update();
  }
}

const SAppearance* CPiPuckEntity::GetAppearance() const {
  static const SAppearance appearance = MakePiPuckAppearance();
  return &appearance;
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CPiPuckEntity)

REGISTER_ENTITY(
    CPiPuckEntity, "pipuck", "the authors of this project", "1.0",
    "The Pi-Puck, an e-puck with a Raspberry Pi and a camera.",
    R"(A round robot, 7 cm across, with two wheels, eight range sensors, three ground sensors, a camera in front, a radio,
and ten directional LEDs: eight in a ring, from the one in front clockwise, one in front, one in the body. Its
devices are those with pipuck in their names, positioning, simple_radios, directional_leds and cameras.
)" + DriveManual(pipuck::kMaxDriveForce, pipuck::kMaxDriveTorque) +
        R"(
REQUIRED XML

  <arena size="10,10,2">
    <pipuck id="pp0">
      <body position="0.4,2.3,0" orientation="45,0,0" />
      <controller config="c1" />
    </pipuck>
  </arena>

OPTIONAL XML

  <arena size="10,10,2">
    <pipuck id="pp0" wifi_medium="radios" led_medium="directional_leds">
      <body position="0.4,2.3,0" />
      <controller config="c1">
        <params speed="10" />
      </controller>
    </pipuck>
  </arena>

ATTRIBUTES AND CHILDREN

  id                 text, required: unique among the entities of the arena.
  wifi_medium        text: the id of a medium of simple radios. Without it the robot has no radio; with it, a radio
                     of the name wifi, whose messages reach 10 m.
  led_medium         text: the id of a medium of directional LEDs. Without it no camera sees the LEDs.
  body@position      "x,y,z", m, default "0,0,0": centre of the base, in the world frame.
  body@orientation   "z,y,x", degrees, default "0,0,0": the x axis of the robot points ahead.
  controller@config  text, required: the id of a child of <controllers>.
  controller/params  replaces the <params> of the controller for this robot.
)",
    "Usable")

}  // namespace argos
