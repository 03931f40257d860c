#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEAD_RECKONING_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEAD_RECKONING_ACTUATOR_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/plugins/robots/generic/simulator/differential_steering_default_actuator.h>

#include <optional>

namespace argos {

class CGripperEquippedEntity;

/**
 * Turns the two wheels of a robot so that it drifts to its left, as one that navigates by dead
 * reckoning does.
 *
 * With v = the mean of the ordered speeds, the right wheel gets mu |v| more while the robot goes
 * ahead (v > 0), and the left wheel mu |v| less, so that it lags behind, while it backs up (v < 0).
 * Ordered straight on, a robot with the distance d between its wheels thus follows a circle of
 * radius d (2 + mu) / (2 mu) ahead, and d (2 - mu) / (2 mu) back, in both cases around a point on
 * its left. mu is drawn from a Rayleigh distribution at the start, and anew whenever the robot's
 * "gripper", if it has one, begins to hold something.
 *
 * Source: C. Pinciroli, "On the Design and Implementation of an Accurate, Efficient, and Flexible
 * Simulator for Heterogeneous Swarm Robotics Systems", PhD thesis, section 6.3.3, sigma included.
 */
class CDifferentialSteeringDeadReckoningActuator : public CDifferentialSteeringDefaultActuator {
 public:
  /** Reads `sigma`, and what the base class reads. @throws CARGoSException if it is < 0. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

  /** mu, as drawn last. */
  Real GetDeviation() const { return m_deviation; }

 private:
  void StartOver();
  bool IsHolding();
  void FindGripper(const CEntity::TVector& components);

  Real m_sigma = 0.00134;
  Real m_deviation = 0.0;  // mu
  bool m_wasHolding = false;
  // of the robot, or null: found anew when the robot's components have changed, because it is made
  // when first asked for, and this actuator does not ask
  const CGripperEquippedEntity* m_gripper = nullptr;
  size_t m_gripperPlace = 0;  // among the components
  size_t m_numComponents = 0;
  std::optional<CRandomStream> m_stream;
};

}  // namespace argos

#endif
