#include <argos3/plugins/simulator/visualizations/scene/enclosing_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>

namespace argos {

namespace {

bool IsInside(const SVisualPart& part, const Eigen::Vector3d& point) {
  const Eigen::Vector3d share = point.cwiseQuotient(ToEigen(part.Size));
  const double across = 2.0 * share.head<2>().norm();
  const bool inHeight = share.z() >= 0.0 && share.z() <= 1.0;
  switch (part.Kind) {
    case SVisualPart::EKind::Box:
      return inHeight && share.head<2>().cwiseAbs().maxCoeff() <= 0.5;
    case SVisualPart::EKind::Cylinder:
      return inHeight && across <= 1.0;
    case SVisualPart::EKind::Cone:
      return inHeight && across <= 1.0 - share.z();
    case SVisualPart::EKind::Sphere:
      return 2.0 * share.norm() <= 1.0;
    case SVisualPart::EKind::Ring:
    case SVisualPart::EKind::LED:
      break;
  }
  return false;
}

bool IsInside(CEntity& entity, const Eigen::Vector3d& point) {
  auto* const composable = dynamic_cast<CComposableEntity*>(&entity);
  const SAppearance* const appearance = entity.GetAppearance();
  if (composable == nullptr || appearance == nullptr) {
    return false;
  }
  auto* const body = FindExistingComponent<CEmbodiedEntity>(*composable);
  if (body == nullptr) {
    return false;
  }
  const SPose origin = ToVisiblePose(body->GetOriginAnchor());
  for (const SVisualPart& part : appearance->Parts) {
    const SPose pose =
        ComputeAnchorPose(part.Anchor, body, origin) * ToPose(part.Position, part.Orientation);
    const Eigen::Vector3d inPart = pose.Rotation.transpose() * (point - pose.Translation);
    if (part.Color.GetAlpha() == 255 && IsInside(part, inPart)) {
      return true;
    }
  }
  return false;
}

}  // namespace

const CEntity* FindEnclosingEntity(CSpace& space, const Eigen::Vector3d& point) {
  for (CEntity* root : space.GetRootEntityVector()) {
    if (IsInside(*root, point)) {
      return root;
    }
  }
  return nullptr;
}

}  // namespace argos
