#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/visualizations/overlays/overlay_attributes.h>
#include <argos3/plugins/simulator/visualizations/overlays/robots_in_view.h>

#include <algorithm>

namespace argos {

/** Draws arrows that point ahead of robots. */
class CHeadingsOverlay : public COverlay {
 public:
  void Init(TConfigurationNode& tree) override {
    m_robots.Init(tree);
    ReadLineWidth(tree, m_width);
    GetNodeAttributeOrDefault(tree, "color", m_color, m_color);
    if (NodeAttributeExists(tree, "length")) {
      ReadPositive(tree, "length", "m", m_length);
    }
  }

  void Draw(CSimulator& simulator, CDrawing& drawing) override {
    for (const CRobotsInView::SRobot& robot : m_robots.List(simulator.GetSpace())) {
      const CVector3 size = robot.Box.MaxCorner - robot.Box.MinCorner;
      // an arrow ends one radius in front of the robot if no length is given
      const Real length = m_length > 0.0 ? m_length : std::max(size.GetX(), size.GetY());
      const CVector3 above(0.0, 0.0, robot.Box.MaxCorner.GetZ() + kGap);
      drawing.SetFrame(robot.Pose.Position + above, robot.Pose.Orientation);
      const Real tip = kTip * length;
      drawing.DrawLine(CVector3(), CVector3(length - tip, 0.0, 0.0), m_color, m_width);
      drawing.DrawTriangle(CVector3(length - 0.5 * tip, 0.0, 0.0), CQuaternion(), 0.7 * tip, tip,
                           m_color);
    }
  }

 private:
  static constexpr Real kGap = 0.001;  // m, between a robot and its arrow
  static constexpr Real kTip = 0.35;  // share of the length

  CRobotsInView m_robots;
  CColor m_color = CColor::RED;
  Real m_length = 0.0;  // m; 0: by the robot's size
  Real m_width = 2.0;  // pixels
};

REGISTER_OVERLAY(CHeadingsOverlay, "headings", "the authors of this project", "1.0",
                 "Draws arrows that point ahead of robots.",
                 OverlayXML("<headings />") +
                     R"(  <headings of="foot-bot" color="red" length="0.2" width="2" />

  of      types of robots, separated by commas: "foot-bot,e-puck". Default: all robots.
  color   default red.
  length  m, > 0, from the robot's centre. Default: the robot's own size, so that the arrow ends a radius in front of it.
  width   of the line, pixels, > 0, default 2.
)",
                 "Usable")

}  // namespace argos
