#ifndef FLOCKING_SCENARIOS_H
#define FLOCKING_SCENARIOS_H

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/rng.h>

#include <optional>
#include <string>
#include <vector>

class CFlockingRobot;
namespace argos {
class CFootBotEntity;
}

/**
 * Tells robots of targets, and measures the flock. Targets are directions: the first one is away
 * from the light, the second one towards it. The light is at -x, far away.
 *
 * Metrics, in each tick: `order`, length of the mean of the robots' unit heading vectors;
 * `accuracy`, (1 + order cos(angle between that mean and the target)) / 2, both in [0,1]. In
 * scenario 3 the target of the accuracy is always the first one. When a phase ends, `order_N` and
 * `accuracy_N` (N from 1) are the means of the phase's last `settled` seconds. `rise` is the time
 * at which the accuracy first reached 0.9, s; the length of phase 1 if it did not.
 */
class CFlockingScenarios : public argos::CLoopFunctions {
 public:
  /**
   * Reads, in <params>, scenario (1: a target; 2: it moves to the other end in the middle of the
   * run; 3: a second one with a higher priority exists in the middle third) and settled (s, default
   * 30).
   * @throws CARGoSException if the scenario is another one.
   */
  void Init(argos::TConfigurationNode& node) override;
  void Reset() override;
  void PostStep() override;

 private:
  /** Ends of the phases, in ticks. */
  std::vector<argos::UInt32> ComputeEnds() const;
  void BeginPhase(std::size_t phase);
  void Inform(std::size_t robot, bool second);
  std::size_t DrawRobot(std::optional<std::size_t> except);
  void Measure();
  void Record(const std::string& name, argos::Real value);

  argos::CRandom::CRNG* m_rng = nullptr;
  argos::UInt32 m_scenario = 1;
  argos::Real m_settledTime = 30.0;  // s
  std::vector<argos::UInt32> m_ends;  // ticks

  std::vector<CFlockingRobot*> m_controllers;
  std::vector<argos::CFootBotEntity*> m_robots;
  std::size_t m_phase = 0;
  std::size_t m_informed = 0;  // of the first target
  bool m_towardsLight = false;  // target of the accuracy
  argos::Real m_order = 0.0;
  argos::Real m_accuracy = 0.0;
  argos::Real m_sumOfOrder = 0.0;  // since the last `settled` seconds of the phase began
  argos::Real m_sumOfAccuracy = 0.0;
  bool m_hasRisen = false;
};

#endif
