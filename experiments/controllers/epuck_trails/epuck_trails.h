#ifndef EPUCK_TRAILS_H
#define EPUCK_TRAILS_H

#include "../common/steering.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>

#include <memory>

/**
 * An e-puck that fetches food with trails, like ants.
 *
 * It wanders until it stands on food, then carries some to the nest and deposits a trail on the
 * way. A robot that detects a trail with its two antennae follows it away from the nest and turns
 * to the side with the higher concentration. So the more robots bring food from a place, the more
 * robots go there.
 *
 * Food is black on the ground and the nest grey; a trail is brighter. Like desert ants, robots know
 * the direction of the nest from path integration.
 *
 * Source: J.-L. Deneubourg et al., "The self-organizing exploratory pattern of the Argentine ant",
 * Journal of Insect Behavior 3 (1990), for the choice by the relative concentrations at the
 * antennae.
 */
class CEPuckTrails : public argos::CCI_Controller {
 public:
  /**
   * Reads the optional attributes max_speed (cm/s), rate (amount of the layer "trail" deposited per
   * second on the way to the nest), threshold (1/m^2: the sum of both antennae above which there is
   * a trail), nest ("x,y", m) and wandering (standard deviation of the change of direction in a
   * tick, rad).
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

  bool HasFood() const { return m_hasFood; }
  argos::UInt64 GetDelivered() const { return m_delivered; }

 private:
  void TakeOrDeliver();
  argos::CVector2 Search();
  /** Unit vector towards the nest, in the robot's frame. */
  argos::CVector2 VectorHome() const;
  argos::CVector2 VectorOffObstacles() const;

  std::unique_ptr<CSteering> m_steering;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_PheromoneActuator* m_gland = nullptr;
  const argos::CCI_PheromoneSensor::TReadings* m_antennae = nullptr;  // left, right
  argos::CCI_EPuckProximitySensor* m_proximity = nullptr;
  argos::CCI_GroundSensor* m_ground = nullptr;
  argos::CCI_PositioningSensor* m_position = nullptr;
  argos::CRandom::CRNG* m_rng = nullptr;

  argos::Real m_rate = 1.0;
  argos::Real m_threshold = 5.0;
  argos::Real m_wandering = 0.2;
  argos::CVector2 m_nest;

  bool m_hasFood = false;
  argos::UInt64 m_delivered = 0;
  argos::Real m_drift = 0.0;  // turn of a wandering robot per tick, rad
};

#endif
