#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/pose_grid.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <array>

namespace argos {

namespace {

SBoundingBox GetBox(const CEmbodiedEntity& body) {
  const SBodyDescription* const description = body.GetBodyDescription();
  if (description == nullptr || description->Shapes.empty()) {
    return {};
  }
  const SBoundingBox box = description->ComputeBoundingBox(CVector3(), CQuaternion());
  return {SnapToPoseGrid(box.MinCorner), SnapToPoseGrid(box.MaxCorner)};
}

}  // namespace

void CRobotsInView::Init(TConfigurationNode& node) {
  std::string types;
  GetNodeAttributeOrDefault(node, "of", types, types);
  Tokenize(types, m_types, ", ");
  if (m_types.empty() && NodeAttributeExists(node, "of")) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"of\" names no type of robots");
  }
}

const std::vector<CRobotsInView::SRobot>& CRobotsInView::List(CSpace& space) {
  m_robots.clear();
  for (CControllableEntity* controller : space.GetControllableEntities()) {
    CComposableEntity& root = controller->GetParent();
    if (!m_types.empty() &&
        std::find(m_types.begin(), m_types.end(), root.GetTypeDescription()) == m_types.end()) {
      continue;
    }
    if (auto* body = FindExistingComponent<CEmbodiedEntity>(root)) {
      m_robots.push_back({&root, SnapToPoseGrid(body->GetOriginAnchor()), GetBox(*body)});
    }
  }
  return m_robots;
}

CColor GetPaletteColor(size_t index) {
  static const std::array<CColor, 7> palette = {
      CColor(0, 114, 178), CColor(213, 94, 0),   CColor(0, 158, 115), CColor(204, 121, 167),
      CColor(230, 159, 0), CColor(86, 180, 233), CColor(240, 228, 66)};
  return palette[index % palette.size()];
}

}  // namespace argos
