#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace argos {

/** Draws axes with numbers along two edges of the arena. */
class CAxesOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_text.Read(tree);
    ReadLineWidth(tree, m_width);
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    const CRange<CVector3>& arena = simulator.GetSpace().GetArenaLimits();
    const CVector3 size = arena.GetMax() - arena.GetMin();
    const Real step = RoundLengthDown(std::max(size.GetX(), size.GetY()) / kMaxNumbers);
    const CVector3 corner(arena.GetMin().GetX(), arena.GetMin().GetY(), 0.0);
    const Real tick = kTick * std::min(size.GetX(), size.GetY());
    DrawAxis({corner, CVector3::X, -CVector3::Y, size.GetX(), corner.GetX(), step, tick, "x"},
             drawing);
    // inside, because pictures have least room to the left of the arena
    DrawAxis({corner, CVector3::Y, CVector3::X, size.GetY(), corner.GetY(), step, tick, "y"},
             drawing);
  }

 private:
  struct SAxis {
    CVector3 Start, Along, Across;
    Real Length;  // m
    Real First;  // coordinate at the start, m
    Real Step;  // distance between numbers, m
    Real Tick;  // length of marks, m
    std::string Name;
  };

  void DrawAxis(const SAxis& axis, CDrawing& drawing) const {
    const STextStyle style = m_text.MakeStyle(drawing, STextStyle::EAlignment::Center);
    drawing.DrawLine(axis.Start, axis.Start + axis.Length * axis.Along, m_text.Color, m_width);
    // 1e-6 of a step: room for rounding errors at both ends
    const auto first = static_cast<SInt64>(std::ceil(axis.First / axis.Step - 1e-6));
    const auto last =
        static_cast<SInt64>(std::floor((axis.First + axis.Length) / axis.Step + 1e-6));
    for (SInt64 i = first; i <= last; ++i) {
      const Real value = static_cast<Real>(i) * axis.Step;
      const CVector3 place = axis.Start + (value - axis.First) * axis.Along;
      drawing.DrawLine(place, place + axis.Tick * axis.Across, m_text.Color, m_width);
      drawing.DrawText(place + kNumber * axis.Tick * axis.Across, fmt::format("{:g}", value),
                       m_text.Color, style);
    }
    // the name is between two numbers
    const CVector3 name = axis.Start + 0.5 * (axis.Length + axis.Step) * axis.Along;
    drawing.DrawText(name + kName * axis.Tick * axis.Across, axis.Name + " (m)", m_text.Color,
                     style);
  }

  static constexpr Real kMaxNumbers = 8.0;
  static constexpr Real kTick = 0.015;  // share of the arena
  static constexpr Real kNumber = 3.0;  // distance of numbers, in marks
  static constexpr Real kName = 6.0;  // distance of the name, in marks

  SOverlayText m_text;
  Real m_width = 1.5;  // pixels
};

REGISTER_OVERLAY(CAxesOverlay, "axes", "the authors of this project", "1.0",
                 "Draws the x and y axes with numbers along two edges of the arena.",
                 OverlayXML("<axes />", R"( The axes lie at z = 0 along the edges of least y and of
least x, with numbers in metres.)") +
                     R"(  <axes color="black" width="1.5" size="24" />

  color  of lines and numbers, default black, or white in a dark view.
  width  of lines, pixels, > 0, default 1.5.
  size   of the numbers, pixels, > 0, default 2.5 % of the height of the picture.
)",
                 "Usable")

}  // namespace argos
