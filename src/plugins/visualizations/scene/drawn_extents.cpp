#include <argos3/plugins/simulator/visualizations/scene/drawn_extents.h>

#include <argos3/core/simulator/visualization/appearance.h>
#include <argos3/core/utility/math/eigen_bridge.h>

namespace argos {

namespace {

void Extend(Eigen::AlignedBox3d& box, const SVisualPart& part, const SPose& pose) {
  const bool standsOnBase = part.Kind == SVisualPart::EKind::Box ||
                            part.Kind == SVisualPart::EKind::Cylinder ||
                            part.Kind == SVisualPart::EKind::Cone;
  const Eigen::Vector3d size = ToEigen(part.Size);
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d share((i & 1) - 0.5, ((i >> 1) & 1) - 0.5,
                                (i >> 2) - (standsOnBase ? 0.0 : 0.5));
    box.extend(pose * size.cwiseProduct(share));
  }
}

}  // namespace

const Eigen::AlignedBox3d& CDrawnExtents::Get(const SAppearance& appearance, CEmbodiedEntity* body,
                                              const SPose& origin) {
  const auto [found, isNew] = m_boxes.try_emplace(&appearance);
  Eigen::AlignedBox3d& box = found->second;
  if (isNew) {
    const Eigen::Matrix3d toBody = origin.Rotation.transpose();
    const SPose worldToBody{toBody, -toBody * origin.Translation};
    for (const SVisualPart& part : appearance.Parts) {
      Extend(box, part,
             worldToBody * ComputeAnchorPose(part.Anchor, body, origin) *
                 ToPose(part.Position, part.Orientation));
    }
  }
  return box;
}

}  // namespace argos
