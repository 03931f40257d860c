#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/visualizations/overlays/color_rule.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>
#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

#include <algorithm>

namespace argos {

/** Colours robots by a disc on top of each. */
class CMarksOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_robots.Init(tree);
    m_color.Init(tree);
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    for (const CRobotsInView::SRobot& robot : m_robots.List(simulator.GetSpace())) {
      const CColor color = m_color.Choose(*robot.Root);
      if (color.GetAlpha() == 0) {
        continue;
      }
      const CVector3& corner = robot.Box.MaxCorner;
      const CVector3 above(0.0, 0.0, corner.GetZ() + kGap);
      drawing.DrawCircle(robot.Pose.Position + above, CQuaternion(),
                         std::max(corner.GetX(), corner.GetY()), color);
    }
  }

 private:
  static constexpr Real kGap = 0.005;  // m, between a robot and its mark

  CRobotsInView m_robots;
  CColorRule m_color;
};

REGISTER_OVERLAY(CMarksOverlay, "marks", "the authors of this project", "1.0",
                 "Colours robots by a disc on top of each.",
                 OverlayXML("<marks />") + R"(  <marks of="foot-bot" color_by="team" />
  <marks color_by="value:food" min="0" max="5" />

  of        types of robots, separated by commas: "foot-bot,e-puck". Default: all robots.
  color_by  robot (each has one of seven colours, the default), type, team (the robot's controller), led (its brightest one),
            or a field of tables, such as value:food, lua:state or battery. A robot without a value has no mark.
  min       real number, default 0: value of the field that is dark blue.
  max       real number, default 1: value of the field that is yellow.
  color     in place of color_by: of all marks.
)",
                 "Usable")

}  // namespace argos
