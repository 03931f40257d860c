#include <argos3/plugins/simulator/physics_engines/dynamics3d/skin.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>

namespace argos {

Real ComputeSkin(const SRigidBody& body, const SRigidSettings& settings) {
  const SBodyDescription& description = *body.Source.Description;
  const bool isObject = body.Source.Movable && !body.HasDrive() &&
                        body.Source.Quadrotor == nullptr && description.Articulation == nullptr &&
                        settings.Stepper != SRigidSettings::EStepper::Direct;
  const bool canGrow = std::none_of(description.Shapes.begin(), description.Shapes.end(),
                                    [](const SShapeDescription& shape) {
                                      return shape.Kind == SShapeDescription::EKind::Hull ||
                                             shape.Kind == SShapeDescription::EKind::Prism;
                                    });
  return isObject && canGrow ? std::min(kSkin, kSkinShare * body.Narrowest) : 0.0;
}

}  // namespace argos
