#ifndef TRAJECTORY_LOOP_FUNCTIONS_H
#define TRAJECTORY_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>

#include <deque>
#include <map>
#include <string>

/** Keeps the latest positions of all foot-bots. */
class CTrajectoryLoopFunctions : public argos::CLoopFunctions {
 public:
  typedef std::deque<argos::CVector3> TTrajectory;  // oldest first; world frame, m

  /** Reads the attribute length of `<trajectories>`: how many ticks to keep, > 0. */
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void PostStep() override;

  /** By the robot's id. */
  const std::map<std::string, TTrajectory>& GetTrajectories() const { return m_trajectories; }

 private:
  void AddPositions();

  argos::UInt32 m_length = 300;  // ticks
  std::map<std::string, TTrajectory> m_trajectories;
};

#endif
