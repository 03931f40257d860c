#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>
#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

namespace argos {

/** Writes the ids of robots above them. */
class CIdsOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_text.Read(tree);
    m_robots.Init(tree);
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    const STextStyle style = m_text.MakeStyle(drawing, STextStyle::EAlignment::Center);
    for (const CRobotsInView::SRobot& robot : m_robots.List(simulator.GetSpace())) {
      const CVector3 above(0.0, 0.0, robot.Box.MaxCorner.GetZ() + kGap);
      drawing.DrawText(robot.Pose.Position + above, robot.Root->GetId(), m_text.Color, style);
    }
  }

 private:
  static constexpr Real kGap = 0.02;  // m, between a robot and its id

  SOverlayText m_text;
  CRobotsInView m_robots;
};

REGISTER_OVERLAY(CIdsOverlay, "ids", "the authors of this project", "1.0",
                 "Writes the ids of robots above them.",
                 R"(REQUIRED XML CONFIGURATION

  <overlays> <ids /> </overlays>

in the element of a view that draws pictures, such as <offscreen>.

OPTIONAL XML CONFIGURATION

  <ids of="foot-bot" color="black" size="24" />

  of     types of robots, separated by commas: "foot-bot,e-puck". Default: all robots.
  color  default black.
  size   pixels, > 0, default 2.5 % of the height of the picture.
)",
                 "Usable")

}  // namespace argos
