#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>

#include <algorithm>

namespace argos {

/** Draws a bar of known length on the ground. */
class CScaleBarOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_text.Read(tree);
    ReadLineWidth(tree, m_width);
    if (NodeAttributeExists(tree, "length")) {
      ReadPositive(tree, "length", "m", m_length);
    }
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    const CRange<CVector3>& arena = simulator.GetSpace().GetArenaLimits();
    const CVector3 size = arena.GetMax() - arena.GetMin();
    const Real length = m_length > 0.0 ? m_length : RoundLengthDown(kShare * size.GetX());
    const Real margin = kMargin * std::min(size.GetX(), size.GetY());
    // outside of the arena, where nothing covers it
    const CVector3 start(arena.GetMin().GetX(), arena.GetMin().GetY() - kGap * margin, 0.0);
    const CVector3 end = start + CVector3(length, 0.0, 0.0);
    const CVector3 serif(0.0, 0.25 * margin, 0.0);
    drawing.DrawLine(start, end, m_text.Color, m_width);
    for (const CVector3& tip : {start, end}) {
      drawing.DrawLine(tip - serif, tip + serif, m_text.Color, m_width);
    }
    drawing.DrawText(end + 2.0 * CVector3(serif.GetY(), 0.0, 0.0), FormatLength(length),
                     m_text.Color, m_text.MakeStyle(drawing, STextStyle::EAlignment::Left));
  }

 private:
  static constexpr Real kShare = 0.25;  // greatest share of the arena
  static constexpr Real kMargin = 0.05;  // share of the arena
  static constexpr Real kGap = 0.25;  // share of the margin between arena and bar

  SOverlayText m_text;
  Real m_length = 0.0;  // m; 0: by the size of the arena
  Real m_width = 3.0;  // pixels
};

REGISTER_OVERLAY(
    CScaleBarOverlay, "scale_bar", "the authors of this project", "1.0",
    "Draws a bar of known length on the ground.",
    R"(The bar lies along x, outside of the arena at its corner of least x and y, where nothing covers it, at z = 0, so that
it is true to scale in any view.

)" + OverlayXML("<scale_bar />") +
        R"(  <scale_bar length="1" color="black" width="3" size="24" />

  length  m, > 0. Default: 1, 2 or 5 times a power of ten, at most a quarter of the arena.
  color   of bar and text, default black, or white in a dark view.
  width   of the bar, pixels, > 0, default 3.
  size    of the text, pixels, > 0, default 2.5 % of the height of the picture.
)",
    "Usable")

}  // namespace argos
