#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>

#include <string>
#include <vector>

namespace argos {

/** Says what colours mean. */
class CLegendOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_corner.IsRight = true;
    m_style.Read(tree);
    m_corner.Read(tree);
    TConfigurationNodeIterator child("entry");
    for (child = child.begin(&tree); child != child.end(); ++child) {
      SEntry entry;
      GetNodeAttribute(*child, "color", entry.Color);
      GetNodeAttribute(*child, "text", entry.Text);
      m_entries.push_back(entry);
    }
    if (m_entries.empty()) {
      THROW_ARGOSEXCEPTION(OwnerOf(tree) << " needs at least one child <entry>");
    }
  }

  void Draw(CSimulator&, CDrawing& drawing) override {
    const STextStyle style = m_style.MakeStyle(drawing, m_corner.GetAlignment());
    const auto lines = static_cast<UInt32>(m_entries.size());
    drawing.SetOverlay();
    for (UInt32 i = 0; i < lines; ++i) {
      // a disc as high as the small letters, then the text
      CVector3 place = m_corner.PlaceLine(drawing, style.Size, i, lines);
      const Real side = m_corner.IsRight ? -1.0 : 1.0;
      drawing.DrawPoint(place + CVector3(side * 0.35 * style.Size, -0.35 * style.Size, 0.0),
                        m_entries[i].Color, 0.7 * style.Size);
      place += CVector3(side * 1.1 * style.Size, 0.0, 0.0);
      drawing.DrawText(place, m_entries[i].Text, m_style.Color, style);
    }
  }

 private:
  struct SEntry {
    CColor Color;
    std::string Text;
  };

  SOverlayText m_style;
  SPictureCorner m_corner;
  std::vector<SEntry> m_entries;
};

REGISTER_OVERLAY(CLegendOverlay, "legend", "the authors of this project", "1.0",
                 "Says what the colours of LEDs mean.",
                 R"(REQUIRED XML CONFIGURATION

  <overlays>
    <legend>
      <entry color="red" text="searching" />
      <entry color="green" text="carries an item" />
    </legend>
  </overlays>

in the element of a view that draws pictures, such as <offscreen>.

OPTIONAL XML CONFIGURATION

  <legend corner="top_right" color="black" size="24"> ... </legend>

  corner       "top_right" (default), "top_left", "bottom_left" or "bottom_right" of the picture.
  color, size  of the text: default black; pixels, > 0, default 2.5 % of the height of the picture.
  entry        at least one, from top to bottom: color and text, both required.
)",
                 "Usable")

}  // namespace argos
