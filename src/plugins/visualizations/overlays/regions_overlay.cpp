#include <argos3/core/simulator/geometry/volume.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>
#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace argos {

namespace {

/* The part of a convex polygon on one side of a line, on which sign * coordinate <= sign * limit.
 */
template <typename GET>
std::vector<CVector2> CutOff(const std::vector<CVector2>& corners, GET get, Real sign, Real limit) {
  std::vector<CVector2> part;
  for (size_t i = 0; i < corners.size(); ++i) {
    const CVector2& from = corners[i];
    const CVector2& to = corners[(i + 1) % corners.size()];
    const Real outFrom = sign * (get(from) - limit);
    const Real outTo = sign * (get(to) - limit);
    if (outFrom <= 0.0) {
      part.push_back(from);
    }
    if ((outFrom < 0.0 && outTo > 0.0) || (outFrom > 0.0 && outTo < 0.0)) {
      part.push_back(from + outFrom / (outFrom - outTo) * (to - from));
    }
  }
  return part;
}

/* The part inside the arena: regions at its edge may go on without end. */
std::vector<CVector2> CutToArena(std::vector<CVector2> corners, const CRange<CVector3>& arena) {
  const auto getX = [](const CVector2& corner) { return corner.GetX(); };
  const auto getY = [](const CVector2& corner) { return corner.GetY(); };
  corners = CutOff(corners, getX, -1.0, arena.GetMin().GetX());
  corners = CutOff(corners, getX, 1.0, arena.GetMax().GetX());
  corners = CutOff(corners, getY, -1.0, arena.GetMin().GetY());
  return CutOff(corners, getY, 1.0, arena.GetMax().GetY());
}

CVector2 FindMiddle(const std::vector<CVector2>& corners) {
  CVector2 middle;
  for (const CVector2& corner : corners) {
    middle += corner / static_cast<Real>(corners.size());
  }
  return middle;
}

/* The corners of a convex polygon, moved inwards along the lines to the mean of all. */
std::vector<CVector2> Shrink(std::vector<CVector2> corners, Real by) {
  const CVector2 middle = FindMiddle(corners);
  for (CVector2& corner : corners) {
    const CVector2 inwards = middle - corner;
    corner += std::min(by / inwards.Length(), 0.5) * inwards;
  }
  return corners;
}

}  // namespace

/** Draws the regions of the physics engines, in colours, with the ids of the engines. */
class CRegionsOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_text.Read(tree);
    if (NodeAttributeExists(tree, "color")) {
      m_color = m_text.Color;
    }
    GetNodeAttributeOrDefault(tree, "ids", m_hasIds, m_hasIds);
    ReadLineWidth(tree, m_width);
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    const CRange<CVector3>& arena = simulator.GetSpace().GetArenaLimits();
    const CVector3 size = arena.GetMax() - arena.GetMin();
    const Real gap = kGap * std::min(size.GetX(), size.GetY());
    const STextStyle style = m_text.MakeStyle(drawing, STextStyle::EAlignment::Center);
    size_t number = 0;
    for (const CPhysicsEngine* const engine : simulator.GetPhysicsEngines()) {
      const SVolume& region = engine->GetVolume();
      const std::vector<CVector2> corners = CutToArena(region.GetCorners(), arena);
      // the region has no sides, or is outside
      if (corners.size() < 3) {
        continue;
      }
      const CColor color = m_color.value_or(GetPaletteColor(number));
      ++number;
      const Real lowest = region.GetLowest();
      const Real height = kHeight + (std::isfinite(lowest) ? lowest : 0.0);
      DrawOutline(Shrink(corners, gap), height, color, drawing);
      if (m_hasIds) {
        const CVector2 middle = FindMiddle(corners);
        drawing.DrawText(CVector3(middle.GetX(), middle.GetY(), height), engine->GetId(), color,
                         style);
      }
    }
  }

 private:
  void DrawOutline(const std::vector<CVector2>& corners, Real height, const CColor& color,
                   CDrawing& drawing) const {
    for (size_t i = 0; i < corners.size(); ++i) {
      const CVector2& end = corners[(i + 1) % corners.size()];
      drawing.DrawLine(CVector3(corners[i].GetX(), corners[i].GetY(), height),
                       CVector3(end.GetX(), end.GetY(), height), color, m_width);
    }
  }

  static constexpr Real kGap =
      0.006;  // share of the arena between the lines of two regions' border
  static constexpr Real kHeight = 0.003;  // m, above the floor

  SOverlayText m_text;
  std::optional<CColor> m_color;  // none: one of the palette for each engine
  bool m_hasIds = true;
  Real m_width = 3.0;  // pixels
};

REGISTER_OVERLAY(CRegionsOverlay, "regions", "the authors of this project", "1.0",
                 "Draws the regions of the physics engines, with the ids of the engines.",
                 OverlayXML("<regions />",
                            R"( It shows how several engines share space, also those of
<auto_partition>, as far as they are inside the arena. Each engine has a colour; lines lie a little inside of the region, so that both sides of a border are seen. An
engine without <boundaries> that have sides has no line.)") +
                     R"(  <regions color="black" width="3" ids="true" size="24" />

  color  of lines and ids; default: one of seven colours for each engine.
  width  of lines, pixels, > 0, default 3.
  ids    true (default): the id of each engine is in the middle of its region.
  size   of the ids, pixels, > 0, default 2.5 % of the height of the picture.
)",
                 "Usable")

}  // namespace argos
