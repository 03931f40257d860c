#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <ostream>
#include <string>
#include <vector>

namespace argos {

/** Friction between objects and the ground in an engine. */
enum class EGround {
  Nothing, /**< none: objects cannot be pushed */
  Force, /**< limited by `<friction>`, whatever the weight */
  Weight /**< limited by a share of the weight */
};

/** A physics engine that the contract tests cover, and its capabilities. */
struct SEngineType {
  std::string Tag; /**< tag in experiment files */
  bool HasContacts = true; /**< bodies stop and push each other */
  bool HasMomentum = true; /**< pushed bodies slide on, robots accelerate with limited force */
  std::string Children = ""; /**< XML that is needed for bodies to stand on the ground */
  /** m: bodies settle by this distance, and rolling wheels slip by it in a few seconds. */
  Real Slack = 0.0;
  Real Slip = 0.0; /**< share of a path's length by which its end may differ from the closed form */
  bool IsPlane = false; /**< all bodies stand at its `elevation` */
  bool HasSlopes = false; /**< bodies can lie on tilted bodies and fall off */
  EGround Ground = EGround::Nothing;
  Real Farthest = 1e6; /**< m: greatest distance of bodies from the origin */
  Real GripRigidity = 0.0; /**< N/m: stiffness of grips; 0: rigid */
  Real Push = 15.0; /**< N: greatest force of a foot-bot's wheels */
  Real Precision = 0.0; /**< relative error of the solver in forces and speeds */
  /** s: bodies penetrate obstacles by their motion in this time before contacts are detected */
  Real Lateness = 0.0;
  /** greatest number of robots in a column that overlap within the limits */
  int DeepestCrowd = 40;
  bool HasLag = false; /**< has the attribute `velocity_lag` */
  /** XML elements of solvers that must all give equal results. */
  std::vector<std::string> Solvers = {""};

  /** XML of an engine of this type. @param children  such as `<boundaries>`. */
  std::string ToXml(const std::string& id = "e", const std::string& attributes = "",
                    const std::string& children = "") const;
  /** XML of an engine in which commands act at once, so that paths are those of one command. */
  std::string ToPromptXml(const std::string& id = "e", const std::string& children = "") const {
    return ToXml(id, GetPromptness(), children);
  }
  /** The attributes for that. */
  std::string GetPromptness() const { return HasLag ? "velocity_lag='0'" : ""; }
  /** XML of two engines, "west" and "east", with a border at x. @param x m. */
  std::string ToTwoXml(double x, const std::string& attributes = "") const;
  /**
   * XML of an engine with friction on the ground.
   * @param deceleration  m/s^2, of a sliding body of mass @p mass (kg).
   */
  std::string ToBrakingXml(Real deceleration, Real mass, const std::string& id = "e",
                           const std::string& children = "") const;
  /** Time until a command takes effect, in ticks. @param iterations  as in the file; 0: absent. */
  Real GetLag(UInt32 iterations = 0) const {
    return HasLag ? (iterations > 0 ? 1.0 / iterations : 0.1) : 0.0;
  }
  /** Greatest friction force on a resting box of this mass (kg) with the default XML, N. */
  Real GetHold(Real mass) const;
};

inline std::ostream& operator<<(std::ostream& stream, const SEngineType& engine) {
  return stream << engine.Tag;
}

/** m/s^2, of the engines with gravity. */
constexpr Real kEngineGravity = 9.81;

// Every engine in which wheeled robots can drive.
inline const SEngineType kDynamics2D{
    .Tag = "dynamics2d",
    .IsPlane = true,
    .Ground = EGround::Force,
    .GripRigidity = 1e4,
    // single precision
    .Precision = 1e-5,
    .HasLag = true,
};
inline const SEngineType kDynamics3D{
    .Tag = "dynamics3d",
    .Slack = 3e-3,
    .Slip = 0.02,
    .HasSlopes = true,
    .Ground = EGround::Weight,
    // the wheels bear 80 % of 1.6 kg and do not slip below that load
    .Push = 12.5,
    .Precision = 2e-3,
    // the length of a substep
    .Lateness = 0.01,
    .DeepestCrowd = 4,
    .Solvers = {"", "<solver stepper='direct'/>", "<solver stepper='iterative'/>"},
};
inline const SEngineType kKinematics2D{
    .Tag = "kinematics2d",
    .HasMomentum = false,
    .IsPlane = true,
    .Ground = EGround::Force,
    .HasLag = true,
};
inline const SEngineType kPointMass3D{
    .Tag = "pointmass3d",
    .HasContacts = false,
    .HasMomentum = false,
    .Farthest = 1e9,
};
inline const std::vector<SEngineType> kEnginesWithWheels{kDynamics2D, kDynamics3D, kKinematics2D,
                                                         kPointMass3D};
/** Engines that keep bodies on the ground apart. */
inline const std::vector<SEngineType> kEnginesWithContacts{kDynamics2D, kDynamics3D, kKinematics2D};
/** Engines that support grips. */
inline const std::vector<SEngineType> kEnginesWithGrips{kDynamics2D, kDynamics3D};

/**
 * @return true if a test cannot run because the engine lacks something, which is then reported.
 * @param what  the missing capability, such as "contacts".
 */
bool IsSkipped(const SEngineType& engine, bool has, const std::string& what);

}  // namespace argos

#endif
