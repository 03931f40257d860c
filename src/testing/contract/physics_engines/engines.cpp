#include <argos3/testing/contract/physics_engines/engines.h>

#include <catch2/catch.hpp>

#include <iomanip>
#include <sstream>

namespace argos {

namespace {

constexpr Real kDefaultFriction = 1.49;  // N, of engines with friction of their own

}  // namespace

std::string SEngineType::ToXml(const std::string& id, const std::string& attributes,
                               const std::string& children) const {
  return "<" + Tag + " id='" + id + "' " + attributes + ">" + Children + children + "</" + Tag +
         ">";
}

std::string SEngineType::ToTwoXml(double x, const std::string& attributes) const {
  const auto region = [](double from, double to) {
    std::ostringstream xml;
    xml << "<boundaries><sides><vertex point='" << from << ",-10'/><vertex point='" << to
        << ",-10'/><vertex point='" << to << ",10'/><vertex point='" << from
        << ",10'/></sides></boundaries>";
    return xml.str();
  };
  return ToXml("west", attributes, region(-10, x)) + ToXml("east", attributes, region(x, 10));
}

std::string SEngineType::ToBrakingXml(Real deceleration, Real mass, const std::string& id,
                                      const std::string& children) const {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<" << Tag << " id='" << id << "'>";
  switch (Ground) {
    case EGround::Force: {
      const Real force = deceleration * mass;
      // a torque that decelerates rotation at most as strongly as motion, at 5 cm
      const Real torque = 0.05 * force;
      xml << "<friction box_linear_friction='" << force << "' box_angular_friction='" << torque
          << "' cylinder_linear_friction='" << force << "' cylinder_angular_friction='" << torque
          << "'/>";
      break;
    }
    case EGround::Weight:
      xml << "<floor friction='" << deceleration / kEngineGravity << "'/><gravity g='"
          << kEngineGravity << "'/>";
      break;
    case EGround::Nothing:
      break;
  }
  xml << children << "</" << Tag << ">";
  return xml.str();
}

Real SEngineType::GetHold(Real mass) const {
  switch (Ground) {
    case EGround::Force:
      return kDefaultFriction;
    case EGround::Weight:
      return mass * kEngineGravity;
    case EGround::Nothing:
      break;
  }
  return 0.0;
}

bool IsSkipped(const SEngineType& engine, bool has, const std::string& what) {
  if (!has) {
    WARN("skipped: " << engine.Tag << " has no " << what);
  }
  return !has;
}

}  // namespace argos
