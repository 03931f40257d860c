#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/visualizations/overlays/color_rule.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>
#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

#include <algorithm>

namespace argos {

/** Writes the ids of robots beside them. */
class CIdsOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_text.Read(tree);
    m_color.Init(tree, m_text.Color);
    m_robots.Init(tree);
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    const STextStyle style = m_text.MakeStyle(drawing, STextStyle::EAlignment::Left);
    for (const CRobotsInView::SRobot& robot : m_robots.List(simulator.GetSpace())) {
      // beside it from above as from the side
      const Real reach = std::max(robot.Box.MaxCorner.GetX(), robot.Box.MaxCorner.GetY());
      const CVector3 beside(reach + kGap, 0.0, robot.Box.MaxCorner.GetZ() + kGap);
      drawing.DrawText(robot.Pose.Position + beside, robot.Root->GetId(),
                       m_color.Choose(*robot.Root), style);
    }
  }

 private:
  static constexpr Real kGap = 0.02;  // m, between a robot and its id

  SOverlayText m_text;
  CColorRule m_color;
  CRobotsInView m_robots;
};

REGISTER_OVERLAY(CIdsOverlay, "ids", "the authors of this project", "1.0",
                 "Writes the ids of robots beside them.",
                 OverlayXML("<ids />") + R"(  <ids of="foot-bot" color="black" size="24" />

  of     types of robots, separated by commas: "foot-bot,e-puck". Default: all robots.
  color  default black, or white in a dark view.
  color_by  in place of color, as for <trails>: robot, type, team, led, or a field of tables with min and max.
  size   pixels, > 0, default 2.5 % of the height of the picture.
)",
                 "Usable")

}  // namespace argos
