#include <argos3/testing/support/small_world.h>

#include <iomanip>
#include <limits>
#include <sstream>

namespace argos::testing {

std::string SSmallWorldText::ToXML() const {
  return "<argos-configuration><framework><experiment ticks_per_second=\"10\" random_seed=\"" +
         std::to_string(Seed) +
         "\"/></framework><controllers><small_world_controller id=\"c\"><actuators>" + Actuators +
         "</actuators><sensors>" + Sensors +
         "</sensors><params/></small_world_controller></controllers><physics_engines>" + Engine +
         "</physics_engines><media>" + Media + "</media><arena " + ArenaAttributes + ">" + Arena +
         "</arena></argos-configuration>";
}

CSmallWorld::CSmallWorld(const SSmallWorldText& text) : m_scope(m_simulator) {
  m_document.Parse(text.ToXML(), "small world");
  m_simulator.Load(m_document, true);
}

CSmallWorld::~CSmallWorld() {
  m_simulator.Destroy();
}

void CSmallWorld::Step(UInt32 ticks) {
  for (UInt32 i = 0; i < ticks; ++i) {
    m_simulator.UpdateSpace();
  }
}

std::string Robot(const std::string& tag, const std::string& id, const std::string& pose) {
  return "<" + tag + " id=\"" + id + "\"><body " + pose + "/><controller config=\"c\"/></" + tag +
         ">";
}

std::string LoadError(const SSmallWorldText& text) {
  try {
    CSmallWorld world(text);
  } catch (std::exception& error) {
    return error.what();
  }
  return "";
}

std::string ToText(const CVector3& vector) {
  std::ostringstream stream;
  stream << std::setprecision(std::numeric_limits<Real>::max_digits10) << vector.GetX() << ","
         << vector.GetY() << "," << vector.GetZ();
  return stream.str();
}

}  // namespace argos::testing

using argos::testing::CSmallWorldController;
REGISTER_CONTROLLER(CSmallWorldController, "small_world_controller")
