#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <ostream>
#include <string>
#include <vector>

namespace argos {

/** A physics engine that the contract tests run over, and what it does not do. */
struct SEngineType {
  std::string Tag; /**< in experiment files */
  bool HasContacts = true; /**< bodies stop and push each other */
  bool HasMomentum = true; /**< what is pushed slides on, robots take time to reach their speed */
  std::string Children = ""; /**< without which nothing stands on the ground */
  /** m: bodies settle by as much, and wheels that really roll slip by as much in a few seconds. */
  Real Slack = 0.0;
  Real Slip = 0.0; /**< share of its length by which a path may leave its closed form */

  /** XML of an engine of this type. @param children  such as `<boundaries>`. */
  std::string ToXml(const std::string& id = "e", const std::string& attributes = "",
                    const std::string& children = "") const;
  /** XML of two of them, "west" and "east", with a border between them at x. @param x m. */
  std::string ToTwoXml(double x) const;
};

inline std::ostream& operator<<(std::ostream& stream, const SEngineType& engine) {
  return stream << engine.Tag;
}

// Every engine in which robots on wheels drive.
inline const SEngineType kDynamics2D{"dynamics2d"};
inline const SEngineType kDynamics3D{"dynamics3d", true, true, "", 3e-3, 0.02};
inline const SEngineType kKinematics2D{"kinematics2d", true, false};
inline const SEngineType kPointMass3D{"pointmass3d", false, false};
/** Those that keep bodies on the plane apart. */
inline const std::vector<SEngineType> kEnginesWithContacts{kDynamics2D, kKinematics2D};
inline const std::vector<SEngineType> kEnginesWithWheels{kDynamics2D, kDynamics3D, kKinematics2D,
                                                         kPointMass3D};

/**
 * True if a test cannot run because the engine lacks something; the report then names it.
 * @param what  is lacking: "contacts".
 */
bool IsSkipped(const SEngineType& engine, bool has, const std::string& what);

}  // namespace argos

#endif
