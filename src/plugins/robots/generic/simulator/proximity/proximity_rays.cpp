#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>

namespace argos {

void CProximityRays::SetRobot(CComposableEntity& robot) {
  m_sensors = &robot.GetComponent<CProximitySensorEquippedEntity>("proximity_sensors");
  m_caster.SetRobot(robot);
  m_sensors->Enable();
}

void CProximityRays::Init(TConfigurationNode& tree) {
  GetNodeAttributeOrDefault(tree, "show_rays", m_showRays, m_showRays);
  m_noise.Init(tree, m_caster.GetRobot(), {"reading"},
               {m_readsNoiseLevel ? ReadNoiseLevel(tree) : CRange<Real>()});
}

SRayBounds CProximityRays::ComputeBounds(const SRayLayout& layout) const {
  SRayBounds bounds = layout;
  if (m_range != HUGE_VAL && !m_showRays && layout.Planar) {
    constexpr Real kMore = 1.0 + 1e-9;  // tolerates rounding
    bounds.Reach = std::min(layout.Reach, kMore * (layout.FarthestStart + m_range));
  }
  return bounds;
}

void CProximityRays::Cast(size_t first, size_t count, Real* fractions) {
  const SRayLayout& layout = m_sensors->GetLayout();
  const SAnchor* const* anchors = m_sensors->GetAnchors();
  if (m_anchor == nullptr) {
    m_anchor = anchors[layout.Rays.front().Anchor];
  }
  const SRayBounds bounds = ComputeBounds(layout);
  static_assert(CRayCaster::kMaxRays % SRayBlock::kSize == 0);
  const SRayBundle bundle{&layout.Rays[first],
                          &layout.Blocks[first / SRayBlock::kSize],
                          count,
                          bounds,
                          anchors,
                          *m_anchor};
  m_caster.Cast(bundle, fractions);
  if (m_showRays) {
    m_caster.Show(bundle, fractions);
  }
}

}  // namespace argos
