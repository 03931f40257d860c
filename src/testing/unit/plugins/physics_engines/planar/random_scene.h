#ifndef ARGOS3_TESTING_UNIT_PLUGINS_PHYSICS_ENGINES_PLANAR_RANDOM_SCENE_H
#define ARGOS3_TESTING_UNIT_PLUGINS_PHYSICS_ENGINES_PLANAR_RANDOM_SCENE_H

#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace argos {

/** Discs and ten obstacles, of which some are discs, at random places. */
struct SRandomScene {
  struct SDisc {
    Real X, Y, Radius;  // m
  };
  std::vector<SDisc> Discs;
  std::vector<SFootprint> Obstacles;

  /** @param side  of the square in which they are, m. */
  SRandomScene(int numDiscs, Real side, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<Real> position(-0.5 * side, 0.5 * side);
    std::uniform_real_distribution<Real> radius(0.03, 0.12);
    std::uniform_real_distribution<Real> angle(0.0, 6.28);
    for (int i = 0; i < numDiscs; ++i) {
      Discs.push_back({position(generator), position(generator), radius(generator)});
    }
    for (int i = 0; i < 10; ++i) {
      const Real yaw = angle(generator);
      const bool isDisc = i % 3 == 0;
      Obstacles.push_back({position(generator), position(generator), isDisc ? 1.0 : std::cos(yaw),
                           isDisc ? 0.0 : std::sin(yaw), isDisc ? 0.0 : 0.1 * side,
                           isDisc ? 0.0 : 0.01, isDisc ? radius(generator) : 0.0});
    }
  }
};

/** From a point to an obstacle; 0 inside of it, m. */
inline Real DistanceTo(const SFootprint& obstacle, Real x, Real y) {
  const Real dx = x - obstacle.X;
  const Real dy = y - obstacle.Y;
  const Real along = std::abs(obstacle.Cos * dx + obstacle.Sin * dy) - obstacle.HalfX;
  const Real across = std::abs(obstacle.Cos * dy - obstacle.Sin * dx) - obstacle.HalfY;
  const Real outside = std::hypot(std::max(along, 0.0), std::max(across, 0.0));
  return std::max(outside - obstacle.Radius, 0.0);
}

}  // namespace argos

#endif
