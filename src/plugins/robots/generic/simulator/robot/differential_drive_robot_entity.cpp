#include <argos3/plugins/robots/generic/simulator/differential_drive_robot_entity.h>

#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>

namespace argos {

CSharedBodies::CSharedBodies(const SBodyDescription& body)
    : m_default(std::make_shared<const SBodyDescription>(body)) {}

std::shared_ptr<const SBodyDescription> CSharedBodies::Get(
    const SDifferentialDriveDescription& drive) const {
  const auto hasDrive = [&drive](const SBodyDescription& body) {
    return body.Drive->InterwheelDistance == drive.InterwheelDistance &&
           body.Drive->WheelRadius == drive.WheelRadius && body.Drive->MaxForce == drive.MaxForce &&
           body.Drive->MaxTorque == drive.MaxTorque;
  };
  if (hasDrive(*m_default)) {
    return m_default;
  }
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_nonDefault.erase(std::remove_if(m_nonDefault.begin(), m_nonDefault.end(),
                                    [](const auto& other) { return other.expired(); }),
                     m_nonDefault.end());
  for (const auto& other : m_nonDefault) {
    std::shared_ptr<const SBodyDescription> known = other.lock();
    if (known != nullptr && hasDrive(*known)) {
      return known;
    }
  }
  auto body = std::make_shared<SBodyDescription>(*m_default);
  body->Drive = drive;
  m_nonDefault.push_back(body);
  return body;
}

SBodyDescription DescribeWheeledCylinder(Real radius, Real height, Real mass, Real planarInertia,
                                         const SDifferentialDriveDescription& drive) {
  SBodyDescription body;
  body.Shapes.push_back(SShapeDescription::Cylinder(radius, height));
  body.Mass = mass;
  body.PlanarInertia = planarInertia;
  body.Drive = drive;
  return body;
}

bool ReadDriveLimits(TConfigurationNode& tree, SDifferentialDriveDescription& drive) {
  if (!NodeExists(tree, "dynamics2d")) {
    return false;
  }
  TConfigurationNode& engine = GetNode(tree, "dynamics2d");
  if (!NodeExists(engine, "differential_steering")) {
    return false;
  }
  TConfigurationNode& limits = GetNode(engine, "differential_steering");
  ReadOptionalPositive(limits, "max_force", "N", drive.MaxForce);
  ReadOptionalPositive(limits, "max_torque", "N m", drive.MaxTorque);
  return true;
}

CWheeledEntity& AddWheels(CComposableEntity& robot, const SDifferentialDriveDescription& drive) {
  auto* const wheels = NewComponent<CWheeledEntity>(robot, "wheels_0", size_t(2));
  const Real y = 0.5 * drive.InterwheelDistance;
  wheels->SetWheel(0, CVector3(0.0, y, 0.0), drive.WheelRadius);
  wheels->SetWheel(1, CVector3(0.0, -y, 0.0), drive.WheelRadius);
  return *wheels;
}

CDifferentialDriveRobotEntity::CDifferentialDriveRobotEntity(
    const SDifferentialDriveRobotType& type, const std::string& id, const CVector3& position,
    const CQuaternion& orientation)
    : CRobotEntity(type, id, position, orientation), m_bodies(type.Bodies) {
  GetEmbodiedEntity().SetBodyDescription(m_bodies.GetSharedDefault());
  m_wheels = &AddWheels(*this, *m_bodies.GetDefault().Drive);
  AddController();
}

void CDifferentialDriveRobotEntity::InitParts(TConfigurationNode& tree) {
  CRobotEntity::InitParts(tree);
  SDifferentialDriveDescription drive = *m_bodies.GetDefault().Drive;
  if (ReadDriveLimits(tree, drive)) {
    GetEmbodiedEntity().SetBodyDescription(m_bodies.Get(drive));
  }
}

}  // namespace argos
