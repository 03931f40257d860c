#ifndef ARGOS3_TESTING_CONTRACT_SENSORS_SYMMETRY_PROBE_H
#define ARGOS3_TESTING_CONTRACT_SENSORS_SYMMETRY_PROBE_H

#include <argos3/testing/contract/sensors/scene.h>
#include <argos3/testing/support/robot_sizes.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace argos {

// tolerance of some thousand roundings: poses are transformed and
// back, arcs are driven for a second
constexpr Real kSymmetryRoundings = 1e-11;

/**
 * A symmetry of the world: an optional reflection at the x axis, then a
 * rotation about z, then a shift.
 */
struct SSymmetryMap {
  bool IsMirror = false;
  Real Turn = 0.0; /**< degrees */
  Real ShiftX = 0.0, ShiftY = 0.0; /**< m */
  /** Probes list objects in the order of their creation, whatever their positions. */
  bool IsInOrderOfCreation = false;

  CVector3 Apply(const CVector3& point) const {
    const Real turn = Turn * M_PI / 180.0;
    const Real y = IsMirror ? -point.GetY() : point.GetY();
    return CVector3(std::cos(turn) * point.GetX() - std::sin(turn) * y + ShiftX,
                    std::sin(turn) * point.GetX() + std::cos(turn) * y + ShiftY, point.GetZ());
  }
  Real ApplyToYaw(Real degrees) const { return (IsMirror ? -degrees : degrees) + Turn; }
  CVector2 Revert(const CVector2& point) const {
    const Real turn = -Turn * M_PI / 180.0;
    const Real x = point.GetX() - ShiftX;
    const Real y = point.GetY() - ShiftY;
    const Real turned = std::sin(turn) * x + std::cos(turn) * y;
    return CVector2(std::cos(turn) * x - std::sin(turn) * y, IsMirror ? -turned : turned);
  }
};

/** A robot "r" and its size, m. */
struct SSymmetryScene {
  std::string Robot = "foot-bot";
  Real Radius = kFootBotRadius; /**< of its body */
  Real Height = 0.0; /**< of its base */
};

/** Pose of the robot in the original world, m, and degrees. */
const CVector3 kSymmetryRobotAt(0.2, 0.1, 0.0);
constexpr Real kSymmetryRobotYaw = 25.0;

/** A point at a bearing (degrees, world frame) and a distance (m) from the robot. */
inline CVector3 AroundRobot(const SSymmetryMap& map, Real bearing, Real distance, Real height) {
  const Real angle = bearing * M_PI / 180.0;
  return map.Apply(kSymmetryRobotAt +
                   CVector3(distance * std::cos(angle), distance * std::sin(angle), height));
}

typedef std::vector<Real> TSymmetryReadings;

/** Readings of a probe to which the noise of a `<noise>` child is added directly. */
struct SNoisyReadings {
  Real Sigma = 0.0; /**< of the test; 0: no such readings */
  /** limits beyond which readings are clamped or have another meaning */
  Real Min = -1e9, Max = 1e9;
  size_t Stride = 1; /**< length of the repeating group of readings ... */
  std::vector<size_t> Columns = {0}; /**< ... and indices within it that have the noise */
};

/** One sensor of one robot. */
struct SSymmetryProbe {
  std::string Name;
  SSymmetryScene Scene;
  std::string Sensors; /**< XML of the controller "c" */
  /** Returns the readings in a fixed order. */
  std::function<TSymmetryReadings(CRobotWorld&, const SSymmetryMap&)> Read;
  /** Maps the readings to those expected of the mirrored robot. */
  std::function<TSymmetryReadings(TSymmetryReadings)> Mirror;
  std::string Actuators = "";
  std::string Engine = "<toy_engine id=\"toy\"/>";
  /** Gives orders before the first tick. */
  std::function<void(CRobotWorld&, const SSymmetryMap&)> Prepare = {};
  Real MirrorTolerance = kSymmetryRoundings;
  /** XML of the arena, if not the default one. */
  std::function<std::string(const SSymmetryScene&, const SSymmetryMap&)> Arena = {};
  std::string Media = "<led id=\"leds\"/>";
  SNoisyReadings Noise = {};
};

const SSymmetryScene kFootBotScene;
const SSymmetryScene kEPuckScene{"e-puck", kEPuckRadius, 0.0};
const SSymmetryScene kEyeBotScene{"eye-bot", 0.255, 0.0};

inline TSymmetryReadings KeepReadings(TSymmetryReadings readings) {
  return readings;
}

/** All probes, one per sensor and robot. */
std::vector<SSymmetryProbe> MakeSymmetryProbes();
/** Appends sensors of signals of other robots: cameras, range and bearing, radios. */
void AppendSignalProbes(std::vector<SSymmetryProbe>& probes);
SRobotExperiment MakeSymmetryExperiment(const SSymmetryProbe& probe, const SSymmetryMap& map);

}  // namespace argos

#endif
