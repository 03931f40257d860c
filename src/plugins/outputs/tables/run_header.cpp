#include <argos3/plugins/simulator/outputs/tables/run_header.h>

#include <argos3/core/config.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>

#include <fmt/format.h>

#include <cmath>

namespace argos {

namespace {

using THeader = std::vector<std::pair<std::string, std::string>>;

std::vector<CVector2> ListCorners(const SShapeDescription& shape) {
  if (shape.Vertices != nullptr) {
    return *shape.Vertices;
  }
  const Real x = 0.5 * shape.Size.GetX();
  const Real y = 0.5 * shape.Size.GetY();
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

// outlines of bodies that stand upright; others are drawn as if they did
void DescribeShape(const SShapeDescription& shape, const SAnchor& origin, THeader& header) {
  const auto toWorld = [&](const CVector3& inShape) {
    CVector3 point = inShape;
    point.Rotate(shape.Orientation);
    point += shape.Offset;
    point.Rotate(origin.Orientation);
    return point + origin.Position;
  };
  using EKind = SShapeDescription::EKind;
  if (shape.Kind == EKind::Cylinder || shape.Kind == EKind::Sphere) {
    const CVector3 center = toWorld(CVector3());
    header.emplace_back(
        "circle", fmt::format("{:.6g},{:.6g},{:.6g}", center.GetX(), center.GetY(), shape.Radius));
    return;
  }
  std::string corners;
  for (const CVector2& corner : ListCorners(shape)) {
    const CVector3 point = toWorld(CVector3(corner.GetX(), corner.GetY(), 0.0));
    corners += corners.empty() ? "" : " ";
    corners += fmt::format("{:.6g},{:.6g}", point.GetX(), point.GetY());
  }
  header.emplace_back("polygon", corners);
}

}  // namespace

std::string GetVersionText() {
  return ARGOS_VERSION "-" ARGOS_RELEASE;
}

THeader DescribeRun(CSimulator& simulator) {
  THeader header = {{"experiment", simulator.GetExperimentFileName()}};
  for (const auto& [path, value] : simulator.GetOverrides()) {
    std::string text = path;
    text += '=';
    text += value;
    header.emplace_back("set", text);
  }
  header.emplace_back("seed", std::to_string(simulator.GetRandomSeed()));
  header.emplace_back("ticks_per_second",
                      fmt::format("{:.6g}", std::round(1.0 / simulator.GetTickLength())));
  return header;
}

THeader DescribeArena(CSimulator& simulator) {
  CSpace& space = simulator.GetSpace();
  const CVector3& low = space.GetArenaLimits().GetMin();
  const CVector3& high = space.GetArenaLimits().GetMax();
  THeader header = {{"arena", fmt::format("{:.6g},{:.6g} {:.6g},{:.6g}", low.GetX(), low.GetY(),
                                          high.GetX(), high.GetY())}};
  for (CEntity* root : space.GetRootEntityVector()) {
    auto* const body = FindExisting<CEmbodiedEntity>(*root);
    if (body == nullptr || body->GetBodyDescription() == nullptr ||
        FindExisting<CControllableEntity>(*root) != nullptr) {
      continue;
    }
    for (const SShapeDescription& shape : body->GetBodyDescription()->Shapes) {
      DescribeShape(shape, body->GetOriginAnchor(), header);
    }
  }
  return header;
}

}  // namespace argos
