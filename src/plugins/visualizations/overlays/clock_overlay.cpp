#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>

#include <fmt/format.h>

namespace argos {

/** Writes the time and the tick. */
class CClockOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_text.Read(tree);
    m_corner.Read(tree);
    GetNodeAttributeOrDefault(tree, "tick", m_showsTick, m_showsTick);
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    const UInt32 tick = simulator.GetSpace().GetSimulationClock();
    std::string text = fmt::format("{:.1f} s", tick * CPhysicsEngine::GetSimulationClockTick());
    if (m_showsTick) {
      text += fmt::format("   tick {}", tick);
    }
    const STextStyle style = m_text.MakeStyle(drawing, m_corner.GetAlignment());
    drawing.SetOverlay();
    drawing.DrawText(m_corner.PlaceLine(drawing, style.Size, 0, 1), text, m_text.Color, style);
  }

 private:
  SOverlayText m_text;
  SPictureCorner m_corner;
  bool m_showsTick = true;
};

REGISTER_OVERLAY(CClockOverlay, "clock", "the authors of this project", "1.0",
                 "Writes the simulated time and the tick into the picture.",
                 OverlayXML("<clock />") +
                     R"(  <clock corner="top_left" tick="true" color="black" size="24" />

  corner  "top_left" (default), "top_right", "bottom_left" or "bottom_right" of the picture.
  tick    bool, default true: also write the number of the tick.
  color   of the text, default black, or white in a dark view. A contour of contrasting shade keeps it readable on any ground.
  size    pixels, > 0, default 2.5 % of the height of the picture.
)",
                 "Usable")

}  // namespace argos
