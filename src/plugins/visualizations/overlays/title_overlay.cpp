#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>

#include <string>

namespace argos {

/** Writes a title. */
class CTitleOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_style.IsBold = true;
    m_style.Read(tree);
    GetNodeAttribute(tree, "text", m_text);
  }

  void Draw(CSimulator&, CDrawing& drawing) override {
    const STextStyle style = m_style.MakeStyle(drawing, STextStyle::EAlignment::Center);
    const SPictureCorner top;
    CVector3 position = top.PlaceLine(drawing, style.Size, 0, 1);
    position.SetX(0.5 * drawing.GetWidth());
    drawing.SetOverlay();
    drawing.DrawText(position, m_text, m_style.Color, style);
  }

 private:
  SOverlayText m_style;
  std::string m_text;
};

REGISTER_OVERLAY(CTitleOverlay, "title", "the authors of this project", "1.0",
                 "Writes a title at the top of the picture.",
                 OverlayXML(R"(<title text="Flocking, 20 foot-bots" />)") +
                     R"(  <title text="Flocking, 20 foot-bots" color="black" size="24" />

  text   UTF-8, required.
  color  default black, or white in a dark view.
  size   pixels, > 0, default 2.5 % of the height of the picture.
)",
                 "Usable")

}  // namespace argos
