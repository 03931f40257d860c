#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_components.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

namespace argos {

const Real* FindWheels(CEmbodiedEntity& body) {
  const SBodyDescription& description = *body.GetBodyDescription();
  if (!body.IsMovable() || !description.Drive || description.Propellers) {
    return nullptr;
  }
  auto& root = static_cast<CComposableEntity&>(body.GetRootEntity());
  const auto& wheels = root.GetComponent<CWheeledEntity>("wheels");
  if (wheels.GetNumWheels() < 2) {
    THROW_ARGOSEXCEPTION("robot \"" << root.GetId() << "\" has a differential drive, but "
                                    << wheels.GetNumWheels() << " wheel instead of 2");
  }
  return wheels.GetWheelVelocities();
}

const CQuadRotorEntity* FindQuadrotor(CEmbodiedEntity& body) {
  if (!body.IsMovable() || !body.GetBodyDescription()->Propellers) {
    return nullptr;
  }
  auto& root = static_cast<CComposableEntity&>(body.GetRootEntity());
  return &root.GetComponent<CQuadRotorEntity>("quadrotor");
}

}  // namespace argos
