#ifndef FOOTBOT_SYNCHRONIZATION_H
#define FOOTBOT_SYNCHRONIZATION_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

/**
 * Robots that stand still and flash like fireflies, and synchronise their flashes.
 *
 * A robot's phase grows from 0 to 1 within a period; then it flashes all its LEDs for one tick and
 * starts again. A visible flash of another robot advances its phase by a share of the phase, to 1
 * at most, unless it has just flashed itself.
 *
 * Source: R. E. Mirollo and S. H. Strogatz, "Synchronization of pulse-coupled biological
 * oscillators", SIAM Journal on Applied Mathematics 50 (1990).
 */
class CFootBotSynchronization : public argos::CCI_Controller {
 public:
  /** Reads the optional attributes period (ticks, > 2) and coupling (share of the phase, > 0). */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  bool SeesFlash() const;

  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_ColoredBlobOmnidirectionalCameraSensor* m_camera = nullptr;
  argos::CRandom::CRNG* m_rng = nullptr;

  argos::UInt32 m_period = 50;  // ticks
  argos::Real m_coupling = 0.1;
  argos::Real m_phase = 0.0;  // [0,1]
  argos::UInt32 m_ticksSinceFlash = 0;
};

#endif
