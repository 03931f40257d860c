#include <argos3/testing/contract/physics_engines/rover.h>

#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/entities/new_component.h>

#include <iomanip>
#include <memory>
#include <sstream>

namespace argos {

void CRoverEntity::Init(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  std::string shape = "disc";
  std::string flaw;
  SPlanarDriveDescription drive{10.0, 10.0};
  GetNodeAttributeOrDefault(tree, "shape", shape, shape);
  GetNodeAttributeOrDefault(tree, "flaw", flaw, flaw);
  GetNodeAttributeOrDefault(tree, "max_force", drive.MaxForce, drive.MaxForce);
  GetNodeAttributeOrDefault(tree, "max_torque", drive.MaxTorque, drive.MaxTorque);

  auto description = std::make_shared<SBodyDescription>();
  description->Shapes.push_back(
      shape == "disc" ? SShapeDescription::Cylinder(kRadius, kHeight)
                      : SShapeDescription::Box(CVector3(2.0 * kRadius, 1.5 * kRadius, kHeight)));
  description->Mass = kMass;
  description->PlanarDrive = drive;
  if (flaw == "two_drives") {
    description->Drive = SDifferentialDriveDescription{0.1, 0.02, 10.0, 10.0};
  }
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0");
  m_body->Init(GetNode(tree, "body"));
  m_body->SetBodyDescription(description);
  if (flaw != "no_component") {
    m_drive = NewComponent<CPlanarDriveEntity>(*this, "planar_drive_0");
  }
  if (NodeExists(tree, "controller")) {
    m_controller = NewComponent<CControllableEntity>(*this, "controller_0");
    m_controller->Init(GetNode(tree, "controller"));
  }
  UpdateComponents();
}

void CRoverEntity::Drive(Real ahead, Real left, Real yawRate) {
  m_drive->SetCommand({ahead, left, yawRate});
}

std::string RoverXml(const std::string& id, Real x, Real y, Real yaw, const std::string& attributes,
                     const std::string& children) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<rover id='" << id << "' " << attributes << "><body position='"
      << x << "," << y << ",0' orientation='" << yaw << ",0,0'/>" << children << "</rover>\n";
  return xml.str();
}

REGISTER_ENTITY(CRoverEntity, "rover", "a test", "1.0", "A robot with a planar drive.", "Drives.",
                "Usable")
REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CRoverEntity)

}  // namespace argos
