#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEAD_RECKONING_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEAD_RECKONING_ACTUATOR_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/plugins/robots/generic/simulator/differential_steering_default_actuator.h>

#include <optional>

namespace argos {

class CGripperEquippedEntity;

/**
 * Sets both wheel speeds of a robot so that it drifts without its sensors showing it, like a robot
 * that navigates by dead reckoning.
 *
 * With v = the mean of the commanded speeds, mu |v| is added to the speed of the right wheel over
 * the ground while the robot moves ahead (v > 0), and to the magnitude of that of the left wheel
 * while it moves back (v < 0). With equal speeds, a robot with the distance d between its wheels
 * follows a circle of radius d (2 + mu) / (2 mu): around a point on its left ahead, and on its
 * right back. So a robot that goes back and forth draws an S with a cusp. mu is drawn from a
 * Rayleigh distribution at the start, and again each time the robot's "gripper", if it has one,
 * grips a body. Encoders read the commanded speeds.
 *
 * With backward="slower", mu |v| is subtracted from the magnitude of the left wheel's speed
 * instead: the radius back is d (2 - mu) / (2 mu) around a point on the left, and the robot
 * retraces its way ahead. The source's formula says so if v is taken with its sign; its text and
 * figure, an S, need the other.
 *
 * Source: C. Pinciroli, "On the Design and Implementation of an Accurate, Efficient, and Flexible
 * Simulator for Heterogeneous Swarm Robotics Systems", PhD thesis, section 6.3.3, sigma included.
 */
class CDifferentialSteeringDeadReckoningActuator : public CDifferentialSteeringDefaultActuator {
 public:
  /**
   * Reads `sigma`, `backward` and the base class's attributes.
   * @throws CARGoSException if sigma is < 0, or `backward` is neither "faster" nor "slower".
   */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

  /** @return the current mu. */
  Real GetDeviation() const { return m_deviation; }

 private:
  void Restart();
  bool IsHolding();
  void FindGripper(const CEntity::TVector& components);

  Real m_sigma = 0.00134;
  Real m_deviation = 0.0;  // mu
  Real m_backwardSign = 1.0;  // 1: the left wheel is faster backwards; -1: slower
  bool m_wasHolding = false;
  // null if there is none yet. It is searched again when the robot's components have changed: the
  // gripper is created on demand, and this actuator does not create it
  const CGripperEquippedEntity* m_gripper = nullptr;
  size_t m_gripperPlace = 0;  // among the components
  size_t m_numComponents = 0;
  std::optional<CRandomStream> m_stream;
};

}  // namespace argos

#endif
