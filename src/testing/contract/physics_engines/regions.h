#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_REGIONS_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_REGIONS_H

#include <argos3/testing/contract/physics_engines/engines.h>

#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace argos {

/** An engine that may share space with others, and its behaviour at borders. */
struct SSharingEngine : SEngineType {
  /** robots accelerate with limited force and keep their speed across a border */
  bool KeepsSpeed = true;
  bool HasWalls = true; /**< faces of its region may be walls */
  bool HasGhosts = true; /**< robots of other engines collide across a border */
};

/** Every engine of this kind; a new engine needs one entry here. */
inline const std::vector<SSharingEngine> kSharingEngines{
    {kDynamics2D},
    {kKinematics2D, false},
    {kPointMass3D, false, true, false},
    {kDynamics3D},
};

/** A corner of a region, m, and the attributes of the side from there to the next. */
struct SCorner {
  double X, Y;
  std::string Face = "";
};

/** XML of `<boundaries>`. @param heights  elements besides the sides. */
inline std::string Boundaries(const std::vector<SCorner>& corners,
                              const std::string& heights = "") {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<boundaries>" << heights << "<sides>";
  for (const SCorner& corner : corners) {
    xml << "<vertex point='" << corner.X << "," << corner.Y << "' " << corner.Face << "/>";
  }
  xml << "</sides></boundaries>";
  return xml.str();
}

/** XML of an engine with that region; commands act at once, so that a path is one arc. */
inline std::string RegionXml(const SEngineType& engine, const std::string& id,
                             const std::vector<SCorner>& corners,
                             const std::string& attributes = "") {
  return engine.ToXml(id, engine.GetPromptness() + " " + attributes, Boundaries(corners));
}

}  // namespace argos

#endif
