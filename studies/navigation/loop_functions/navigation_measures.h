#ifndef NAVIGATION_MEASURES_H
#define NAVIGATION_MEASURES_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/vector2.h>

#include <vector>

class CNavigationRobot;
namespace argos {
class CFootBotEntity;
}

/**
 * Lets one robot or all of them navigate, and measures.
 *
 * Metrics: `delay`, mean time of the trips from one target to the other so far, s (the way to the
 * first target does not count); `trips`, their number; `rotation`, angular momentum of the moving
 * robots about their centroid, divided by the largest one that is possible with their places and
 * speeds: 1 if all go round counter-clockwise, -1 if clockwise; `mean_rotation`, the mean of
 * `rotation` over the second half of the run, and `loop`, its magnitude.
 */
class CNavigationMeasures : public argos::CLoopFunctions {
 public:
  /** Reads scenario: 1, one robot navigates; 2, all do. */
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void PostStep() override;

 private:
  struct SRobot {
    argos::CFootBotEntity* Entity = nullptr;
    CNavigationRobot* Controller = nullptr;
    argos::CVector2 Position;  // m
    argos::CVector2 Movement;  // in this tick, m
    argos::UInt32 NumArrivals = 0;
    argos::UInt32 TripStart = 0;  // tick
  };

  static argos::CVector2 GetPosition(const SRobot& robot);
  void CountTrips(SRobot& robot);
  argos::Real MeasureRotation();

  argos::UInt32 m_scenario = 1;
  std::vector<SRobot> m_robots;
  argos::UInt32 m_numTrips = 0;
  argos::Real m_sumOfDelays = 0.0;  // s
  argos::Real m_sumOfRotations = 0.0;  // in the second half
};

#endif
