#include <argos3/testing/contract/sensors/scene.h>

#include <argos3/testing/support/robot_world.h>

namespace argos {

std::string Pose(const CVector3& position, Real yaw) {
  return "position=\"" + ToText(position) + "\" orientation=\"" + ToText(yaw) + ",0,0\"";
}

std::string Cylinder(const std::string& id, const CVector3& position, Real radius, Real height) {
  return "<cylinder id=\"" + id + "\" radius=\"" + ToText(radius) + "\" height=\"" +
         ToText(height) + "\" movable=\"false\"><body " + Pose(position) + "/></cylinder>";
}

std::string Box(const std::string& id, const CVector3& size, const CVector3& position, Real yaw) {
  return "<box id=\"" + id + "\" size=\"" + ToText(size) + "\" movable=\"false\"><body " +
         Pose(position, yaw) + "/></box>";
}

std::string Light(const std::string& id, const CVector3& position, Real intensity) {
  return "<light id=\"" + id + "\" position=\"" + ToText(position) + "\" intensity=\"" +
         ToText(intensity) + "\" color=\"yellow\" medium=\"leds\"/>";
}

}  // namespace argos
