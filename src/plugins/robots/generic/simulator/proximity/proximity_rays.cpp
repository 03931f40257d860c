#include <argos3/plugins/robots/generic/simulator/proximity_rays.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>

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

void CProximityRays::Cast(size_t first, size_t count, Real* fractions) {
  const SRayLayout& layout = m_sensors->GetLayout();
  const SAnchor* const* anchors = m_sensors->GetAnchors();
  if (&layout != m_layout) {
    m_layout = &layout;
    m_anchor = anchors[layout.Rays.front().Anchor];
  }
  const SRayBundle bundle{&layout.Rays[first], count, layout, anchors, *m_anchor};
  m_caster.Cast(bundle, fractions);
  if (m_showRays) {
    m_caster.Show(bundle, fractions);
  }
}

}  // namespace argos
