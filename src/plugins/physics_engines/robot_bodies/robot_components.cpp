#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/recorded_body.h>
#include <argos3/plugins/simulator/entities/joint_equipped_entity.h>
#include <argos3/plugins/simulator/entities/planar_drive_entity.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

namespace argos {

namespace {

CDriveSource FindPlanarDrive(CEmbodiedEntity& body) {
  const SBodyDescription& description = *body.GetBodyDescription();
  auto& root = static_cast<CComposableEntity&>(body.GetRootEntity());
  if (description.Drive || description.Propellers) {
    THROW_ARGOSEXCEPTION("robot \"" << root.GetId() << "\" has a planar drive and "
                                    << (description.Drive ? "a differential one" : "propellers")
                                    << ": its description must have one of them only");
  }
  return CDriveSource(root.GetComponent<CPlanarDriveEntity>("planar_drive").GetCommand());
}

// of a type of its own, or "wheels"
const CWheeledEntity& FindWheels(CComposableEntity& root) {
  for (const CEntity* component : root.GetExistingComponents()) {
    if (const auto* const wheels = dynamic_cast<const CWheeledEntity*>(component)) {
      return *wheels;
    }
  }
  return root.GetComponent<CWheeledEntity>("wheels");
}

}  // namespace

CDriveSource FindDrive(CEmbodiedEntity& body, const CRecordedBody* recorded) {
  const SBodyDescription& description = *body.GetBodyDescription();
  if (!body.IsMovable()) {
    return {};
  }
  if (description.IsRecorded) {
    return recorded != nullptr ? recorded->GetDrive() : CDriveSource();
  }
  if (description.PlanarDrive) {
    return FindPlanarDrive(body);
  }
  if (!description.Drive || description.Propellers) {
    return {};
  }
  auto& root = static_cast<CComposableEntity&>(body.GetRootEntity());
  const CWheeledEntity& wheels = FindWheels(root);
  if (wheels.GetNumWheels() < 2) {
    THROW_ARGOSEXCEPTION("robot \"" << root.GetId() << "\" has a differential drive, but "
                                    << wheels.GetNumWheels() << " wheel instead of 2");
  }
  return {wheels.GetWheelVelocities(), description.Drive->InterwheelDistance};
}

const CQuadRotorEntity* FindQuadrotor(CEmbodiedEntity& body) {
  if (!body.IsMovable() || !body.GetBodyDescription()->Propellers) {
    return nullptr;
  }
  auto& root = static_cast<CComposableEntity&>(body.GetRootEntity());
  return &root.GetComponent<CQuadRotorEntity>("quadrotor");
}

CJointEquippedEntity* FindJoints(CEmbodiedEntity& body) {
  if (body.GetBodyDescription()->Articulation == nullptr) {
    return nullptr;
  }
  auto& root = static_cast<CComposableEntity&>(body.GetRootEntity());
  return &root.GetComponent<CJointEquippedEntity>("joints");
}

}  // namespace argos
