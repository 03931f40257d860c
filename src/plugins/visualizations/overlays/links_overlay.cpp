#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/media/rab_medium.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>

#include <vector>

namespace argos {

/** Draws lines between robots that hear each other by range and bearing. */
class CLinksOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    ReadLineWidth(tree, m_width);
    GetNodeAttributeOrDefault(tree, "color", m_color, m_color);
    GetNodeAttributeOrDefault(tree, "medium", m_medium, m_medium);
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    for (CMedium* medium : simulator.GetMedia()) {
      const auto* rab = dynamic_cast<const CRABMedium*>(medium);
      if (rab != nullptr && (m_medium.empty() || m_medium == rab->GetId())) {
        DrawLinks(*rab, simulator.GetSpace().GetContext().Arena.Period, drawing);
      }
    }
  }

 private:
  // Draws from each receiver half-way to the sender: links that work both ways are whole lines.
  void DrawLinks(const CRABMedium& medium, const SPeriodicity& period, CDrawing& drawing) const {
    for (UInt32 i = 0; i < medium.GetNumDevices(); ++i) {
      const CRABEquippedEntity* const receiver = medium.GetDevice(i);
      if (receiver == nullptr) {
        continue;
      }
      const CVector3& place = receiver->GetPosition();
      for (const UInt32 number : medium.GetSenders(*receiver)) {
        if (const CRABEquippedEntity* const sender = medium.GetDevice(number)) {
          // a sender beyond a joined side is where it is nearest
          const CVector3 from = period.FindNearest(sender->GetPosition(), place);
          drawing.DrawLine(place, 0.5 * (place + from), m_color, m_width);
        }
      }
    }
  }

  CColor m_color = CColor(0, 114, 178);
  Real m_width = 1.0;  // pixels
  std::string m_medium;  // "": all
};

REGISTER_OVERLAY(
    CLinksOverlay, "links", "the authors of this project", "1.0",
    "Draws lines between robots that receive each other's messages by range and bearing.",
    OverlayXML("<links />", R"( A line begins at each robot that receives a message
in the present tick and ends half-way to its sender, so that links in both directions are whole lines.)") +
        R"(  <links medium="rab" color="blue" width="1" />

  medium  id of a range-and-bearing medium. Default: all of them.
  color   default a dark blue.
  width   pixels, > 0, default 1.
)",
    "Usable")

}  // namespace argos
