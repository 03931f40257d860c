#include <argos3/plugins/simulator/visualizations/scene/camera_plan.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/visualizations/scene/enclosing_entity.h>

#include <algorithm>

namespace argos {

namespace {

CEmbodiedEntity* FindBody(CEntity& entity) {
  auto* const composable = dynamic_cast<CComposableEntity*>(&entity);
  return composable != nullptr ? FindExistingComponent<CEmbodiedEntity>(*composable) : nullptr;
}

std::optional<Eigen::Vector3d> FindPosition(CEntity& entity) {
  if (const CEmbodiedEntity* const body = FindBody(entity)) {
    return ToVisiblePose(body->GetOriginAnchor()).Translation;
  }
  if (const auto* const positional = dynamic_cast<const CPositionalEntity*>(&entity)) {
    return ToVisiblePose({positional->GetPosition(), CQuaternion()}).Translation;
  }
  return std::nullopt;
}

void ExtendToBody(CEntity& entity, CEmbodiedEntity& body, CDrawnExtents& extents,
                  CCameraFraming& framing) {
  const SPose origin = ToVisiblePose(body.GetOriginAnchor());
  const SAppearance* const appearance = entity.GetAppearance();
  if (appearance == nullptr) {
    framing.Extend(origin.Translation);
    return;
  }
  const Eigen::AlignedBox3d& box = extents.Get(*appearance, &body, origin);
  for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
    framing.Extend(origin * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  }
}

void ExtendToContents(CSpace& space, CDrawnExtents& extents, CCameraFraming& framing) {
  const Eigen::Vector3d center = ToEigen(space.GetArenaCenter());
  const Eigen::Vector3d half = 0.5 * ToEigen(space.GetArenaSize());
  for (CEntity* root : space.GetRootEntityVector()) {
    if (CEmbodiedEntity* const body = FindBody(*root)) {
      ExtendToBody(*root, *body, extents, framing);
    } else if (const auto position = FindPosition(*root)) {
      // lamps far away stand for the sun
      const Eigen::Vector3d offset = (*position - center).cwiseAbs();
      if (offset.x() <= half.x() && offset.y() <= half.y()) {
        framing.Extend(*position);
      }
    }
  }
}

void ExtendToGround(const CSpace& space, CCameraFraming& framing) {
  Eigen::Vector3d center = ToEigen(space.GetArenaCenter());
  Eigen::Vector3d half = 0.5 * ToEigen(space.GetArenaSize());
  center.z() = 0.0;
  half.z() = 0.0;
  framing.Extend(center - half, center + half);
}

}  // namespace

std::optional<Eigen::Vector3d> FindPosition(CSpace& space, const std::string& id) {
  const std::vector<CEntity*>& roots = space.GetRootEntityVector();
  const auto found = std::ranges::find(roots, id, &CEntity::GetId);
  return found != roots.end() ? FindPosition(**found) : std::nullopt;
}

CCameraPlan::CCameraPlan(const SCameraSettings& settings, double aspectRatio)
    : m_settings(settings), m_aspectRatio(aspectRatio) {}

void CCameraPlan::Reset() {
  m_framing.reset();
  m_hasLostFollowed = false;
}

SCameraPlacement CCameraPlan::ComputeAt(CSpace& space, std::uint32_t tick) {
  if (!m_settings.Followed.empty()) {
    UpdateFollowed(space);
  }
  if (m_settings.View.has_value()) {
    UpdateView(space);
  }
  SCameraPlacement placement = m_settings.Timeline.ComputeAt(tick);
  placement.Position += m_followed;
  placement.LookAt += m_followed;
  WarnIfInside(space, placement);
  return placement;
}

void CCameraPlan::UpdateFollowed(CSpace& space) {
  if (const auto position = FindPosition(space, m_settings.Followed)) {
    m_followed = *position;
  } else if (!m_hasLostFollowed) {
    m_hasLostFollowed = true;
    LOGERR << "[WARNING] the camera follows \"" << m_settings.Followed
           << "\", which does not exist any more in tick " << space.GetSimulationClock()
           << "; it stays where it is" << std::endl;
  }
}

void CCameraPlan::UpdateView(CSpace& space) {
  const bool isNew = !m_framing.has_value();
  if (isNew) {
    m_framing.emplace(*m_settings.View, m_aspectRatio, m_settings.Margin);
  }
  if (!m_settings.Followed.empty()) {
    if (isNew) {
      const Eigen::Vector3d reach = Eigen::Vector3d::Constant(m_settings.Reach);
      m_framing->Extend(-reach.cwiseProduct(Eigen::Vector3d(1.0, 1.0, 0.0)),
                        reach.cwiseProduct(Eigen::Vector3d(1.0, 1.0, 0.0)));
    }
  } else {
    if (m_settings.Fit == SCameraSettings::EFit::Arena) {
      ExtendToGround(space, *m_framing);
    }
    ExtendToContents(space, m_extents, *m_framing);
  }
  m_settings.Timeline.SetPlacement(0, m_framing->ComputePlacement());
}

void CCameraPlan::WarnIfInside(CSpace& space, const SCameraPlacement& placement) {
  if (m_hasWarnedOfInside || (m_checked.has_value() && *m_checked == placement.Position)) {
    return;
  }
  m_checked = placement.Position;
  if (const CEntity* const entity = FindEnclosingEntity(space, placement.Position)) {
    m_hasWarnedOfInside = true;
    LOGERR << "[WARNING] in tick " << space.GetSimulationClock() << " the camera is inside of \""
           << entity->GetId() << "\", at (" << placement.Position.x() << ","
           << placement.Position.y() << "," << placement.Position.z()
           << "), and shows that from within; move its position" << std::endl;
  }
}

}  // namespace argos
