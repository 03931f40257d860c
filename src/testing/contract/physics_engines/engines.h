#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_ENGINES_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <ostream>
#include <string>
#include <vector>

namespace argos {

/** How an engine holds things that lie on the ground. */
enum class EGround {
  Nothing, /**< nothing pushes them, so nothing needs to hold them */
  Force, /**< by up to the force that `<friction>` sets, whatever they weigh */
  Weight /**< by up to a share of their weight */
};

/** A physics engine that the contract tests run over, and what it does not do. */
struct SEngineType {
  std::string Tag; /**< in experiment files */
  bool HasContacts = true; /**< bodies stop and push each other */
  bool HasMomentum = true; /**< what is pushed slides on, robots take time to reach their speed */
  std::string Children = ""; /**< without which nothing stands on the ground */
  /** m: bodies settle by as much, and wheels that really roll slip by as much in a few seconds. */
  Real Slack = 0.0;
  Real Slip = 0.0; /**< share of its length by which a path may leave its closed form */
  bool IsPlane = false; /**< all bodies stand at its `elevation` */
  bool HasSlopes = false; /**< bodies lie on tilted ones, and fall off */
  EGround Ground = EGround::Nothing;
  Real Farthest = 1e5; /**< m: where the farthest bodies may be */
  Real GripRigidity = 0.0; /**< N/m: of grips that are springs; 0: they are rigid */
  Real Push = 15.0; /**< N: what a foot-bot's wheels exert at most */
  Real Precision = 0.0; /**< relative: what the solver leaves of forces and speeds */
  Real Lateness = 0.0; /**< s: what meets something is inside it by its way in that time first */
  int DeepestCrowd = 40; /**< robots, one behind the other, that hardly overlap when they push */
  /** XML elements, each of which makes the engine compute the same in another way. */
  std::vector<std::string> Solvers = {""};

  /** XML of an engine of this type. @param children  such as `<boundaries>`. */
  std::string ToXml(const std::string& id = "e", const std::string& attributes = "",
                    const std::string& children = "") const;
  /** XML of two of them, "west" and "east", with a border between them at x. @param x m. */
  std::string ToTwoXml(double x) const;
  /**
   * XML of one in which the ground brakes things.
   * @param deceleration  m/s^2, of what slides and has the mass @p mass (kg).
   */
  std::string ToBrakingXml(Real deceleration, Real mass, const std::string& id = "e",
                           const std::string& children = "") const;
  /** What the ground holds a box of this mass (kg) with, as XML has it by default, N. */
  Real GetHold(Real mass) const;
};

inline std::ostream& operator<<(std::ostream& stream, const SEngineType& engine) {
  return stream << engine.Tag;
}

/** m/s^2, of those that have gravity. */
constexpr Real kEngineGravity = 9.81;

// Every engine in which robots on wheels drive.
inline const SEngineType kDynamics2D{
    .Tag = "dynamics2d",
    .IsPlane = true,
    .Ground = EGround::Force,
    .GripRigidity = 1e4,
    // single precision
    .Precision = 1e-5,
};
inline const SEngineType kDynamics3D{
    .Tag = "dynamics3d",
    .Slack = 3e-3,
    .Slip = 0.02,
    .HasSlopes = true,
    .Ground = EGround::Weight,
    .Farthest = 1e6,
    // its wheels bear 80 % of 1.6 kg, and do not slip up to their load
    .Push = 12.5,
    .Precision = 2e-3,
    // a substep
    .Lateness = 0.01,
    .DeepestCrowd = 4,
    .Solvers = {"", "<solver stepper='direct'/>", "<solver stepper='iterative'/>"},
};
inline const SEngineType kKinematics2D{
    .Tag = "kinematics2d",
    .HasMomentum = false,
    .IsPlane = true,
    .Ground = EGround::Force,
};
inline const SEngineType kPointMass3D{
    .Tag = "pointmass3d",
    .HasContacts = false,
    .HasMomentum = false,
    .Farthest = 1e9,
};
inline const std::vector<SEngineType> kEnginesWithWheels{kDynamics2D, kDynamics3D, kKinematics2D,
                                                         kPointMass3D};
/** Those that keep bodies on the ground apart. */
inline const std::vector<SEngineType> kEnginesWithContacts{kDynamics2D, kDynamics3D, kKinematics2D};
/** Those whose grippers hold what they grip. */
inline const std::vector<SEngineType> kEnginesWithGrips{kDynamics2D, kDynamics3D};

/**
 * True if a test cannot run because the engine lacks something; the report then names it.
 * @param what  is lacking: "contacts".
 */
bool IsSkipped(const SEngineType& engine, bool has, const std::string& what);

}  // namespace argos

#endif
