#include <argos3/testing/contract/physics_engines/engines.h>

#include <catch2/catch.hpp>

#include <sstream>

namespace argos {

std::string SEngineType::ToXml(const std::string& id, const std::string& attributes,
                               const std::string& children) const {
  return "<" + Tag + " id='" + id + "' " + attributes + ">" + Children + children + "</" + Tag +
         ">";
}

std::string SEngineType::ToTwoXml(double x) const {
  const auto region = [](double from, double to) {
    std::ostringstream xml;
    xml << "<boundaries><sides><vertex point='" << from << ",-10'/><vertex point='" << to
        << ",-10'/><vertex point='" << to << ",10'/><vertex point='" << from
        << ",10'/></sides></boundaries>";
    return xml.str();
  };
  return ToXml("west", "", region(-10, x)) + ToXml("east", "", region(x, 10));
}

bool IsSkipped(const SEngineType& engine, bool has, const std::string& what) {
  if (!has) {
    SUCCEED("skipped: " << engine.Tag << " has no " << what);
  }
  return !has;
}

}  // namespace argos
