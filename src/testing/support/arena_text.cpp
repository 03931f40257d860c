#include <argos3/testing/support/arena_text.h>

#include <iomanip>
#include <limits>
#include <sstream>

namespace argos {

std::string ToText(Real value) {
  std::ostringstream stream;
  stream << std::setprecision(std::numeric_limits<Real>::max_digits10) << value;
  return stream.str();
}

std::string ToText(const CVector3& vector) {
  return ToText(vector.GetX()) + "," + ToText(vector.GetY()) + "," + ToText(vector.GetZ());
}

std::string PoseText(const CVector3& position, Real yawDegrees) {
  return "position=\"" + ToText(position) + "\" orientation=\"" + ToText(yawDegrees) + ",0,0\"";
}

std::string PillarText(const std::string& id, Real x, Real y, Real radius, Real height) {
  return "<cylinder id=\"" + id + "\" radius=\"" + ToText(radius) + "\" height=\"" +
         ToText(height) + "\" movable=\"false\"><body " + PoseText(CVector3(x, y, 0.0)) +
         "/></cylinder>";
}

std::string BoxText(const std::string& id, const CVector3& size, const CVector3& position,
                    Real yawDegrees) {
  return "<box id=\"" + id + "\" size=\"" + ToText(size) + "\" movable=\"false\"><body " +
         PoseText(position, yawDegrees) + "/></box>";
}

std::string LightText(const std::string& id, const CVector3& position, const std::string& color) {
  return "<light id=\"" + id + "\" position=\"" + ToText(position) + "\" color=\"" + color +
         "\" intensity=\"1\" medium=\"leds\"/>";
}

}  // namespace argos
