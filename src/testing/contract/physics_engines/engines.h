#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H

#include <ostream>
#include <string>

namespace argos {

/** A physics engine that the contract tests run over, and what it does not do. */
struct SEngineType {
  std::string Tag; /**< in experiment files */
  bool HasContacts = true; /**< bodies stop and push each other */
  bool HasDriveLimits = true; /**< wheels push with a bounded force */

  /** XML of an engine of this type. @param children  such as `<boundaries>`. */
  std::string ToXml(const std::string& id = "e", const std::string& attributes = "",
                    const std::string& children = "") const;
  /** XML of two of them, "west" and "east", with a border between them at x. @param x m. */
  std::string ToTwoXml(double x) const;
};

inline std::ostream& operator<<(std::ostream& stream, const SEngineType& engine) {
  return stream << engine.Tag;
}

/** Every engine in which robots on wheels drive. */
inline const SEngineType kDynamics2D{"dynamics2d"};
inline const SEngineType kPointMass3D{"pointmass3d", false, false};

/**
 * True if a test cannot run because the engine lacks something; the report then names it.
 * @param what  is lacking: "contacts".
 */
bool IsSkipped(const SEngineType& engine, bool has, const std::string& what);

}  // namespace argos

#endif
