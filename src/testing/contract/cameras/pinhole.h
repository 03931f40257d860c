#ifndef ARGOS3_TESTING_CONTRACT_CAMERAS_PINHOLE_H
#define ARGOS3_TESTING_CONTRACT_CAMERAS_PINHOLE_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/testing/support/arena_text.h>
#include <argos3/testing/support/robot_world.h>

#include <string>

namespace argos {

/** The camera of the tests: it looks ahead from a robot, with u to the right and v down. */
struct SPinhole {
  CVector3 Robot; /**< position of the robot, m */
  Real Yaw = 0.0; /**< of the robot, degrees */
  CVector3 Offset = CVector3(0.1, 0.02, 0.15); /**< of the camera, in the robot's frame, m */
  Real FX = 500.0, FY = 450.0, CX = 320.0, CY = 230.0; /**< pixels */

  /** From the camera's frame (x right, y down, z ahead) to the world's, m. */
  CVector3 ToWorld(const CVector3& p) const {
    CVector3 inRobot = Offset + CVector3(p.GetZ(), -p.GetX(), -p.GetY());
    return inRobot.RotateZ(ToRadians(CDegrees(Yaw))) + Robot;
  }
  /** The point at that depth (m) that is projected to a pixel, in the camera's frame. */
  CVector3 At(Real u, Real v, Real depth) const {
    return CVector3((u - CX) / FX * depth, (v - CY) / FY * depth, depth);
  }
  CVector2 Project(const CVector3& p) const {
    return CVector2(FX * p.GetX() / p.GetZ() + CX, FY * p.GetY() / p.GetZ() + CY);
  }
  /**
   * @return true if a point in the camera's frame is in the picture: 640 x 480, from 0.05 to 2 m.
   */
  bool Contains(const CVector3& p) const {
    const CVector2 pixel = Project(p);
    return p.GetZ() >= 0.05 && p.GetZ() <= 2.0 && pixel.GetX() >= 0.0 && pixel.GetX() < 640.0 &&
           pixel.GetY() >= 0.0 && pixel.GetY() < 480.0;
  }

  /** XML of a `<camera>`. */
  std::string ToXml(const std::string& algorithms, const std::string& id = "front",
                    const std::string& anchor = "origin") const {
    return "<camera id=\"" + id + "\" anchor=\"" + anchor + "\" position=\"" + ToText(Offset) +
           "\" orientation=\"-90,90,0\" range=\"0.05:2\" focal_length=\"" + ToText(FX) + "," +
           ToText(FY) + "\" principal_point=\"" + ToText(CX) + "," + ToText(CY) +
           "\" resolution=\"640,480\">" + algorithms + "</camera>";
  }
  /** XML of the robot "r". */
  std::string RobotXml(const std::string& tag = "foot-bot") const {
    return argos::Robot(tag, "r", PoseText(Robot, Yaw));
  }
};

/** An experiment with all media, whose robots have the sensor "cameras". */
inline SRobotExperiment WithCameras(const std::string& cameras, const std::string& arena,
                                    const std::string& attributes = "") {
  SRobotExperiment experiment;
  experiment.Sensors =
      "<cameras implementation=\"default\" " + attributes + ">" + cameras + "</cameras>";
  experiment.Media =
      "<led id=\"leds\"/><directional_led id=\"directional_leds\"/><tag id=\"tags\"/>";
  experiment.Arena = arena;
  return experiment;
}

/** XML of a foot-bot with components. @param mounted  XML elements of the components. */
inline std::string Carrier(const std::string& id, const CVector3& position, Real yawDegrees,
                           const std::string& mounted) {
  return "<foot-bot id=\"" + id + "\"><body " + PoseText(position, yawDegrees) +
         "/><controller config=\"c\"/>" + mounted + "</foot-bot>";
}

}  // namespace argos

#endif
