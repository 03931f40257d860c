#ifndef SHELTER_H
#define SHELTER_H

#include "shelter_message.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ceiling_attachment_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

#include <string>
#include <vector>

/**
 * A shelter: an eye-bot at the ceiling, which houses a group of foot-bots.
 *
 * It counts the robots of its group (red) with its camera, and broadcasts the probability to join,
 * target size / capacity while the group is too small, else 0, and the probability to leave, which
 * falls exponentially after each reset. A shelter is reset when it is activated, and when it gets
 * the reset signal of another one, which it passes on.
 *
 * Its id is "shelter<number>". Its LEDs are yellow, white while it believes that its group has
 * converged, and black while it is not active.
 */
class CShelter : public argos::CCI_Controller {
 public:
  /**
   * Reads the optional attributes range (m, radius of the disc on the floor), capacity (robots),
   * sizes (target sizes of the shelters 0, 1, ..., separated by commas; the last holds for the
   * others, too), leave_high and leave_low (per tick), delta (ticks until 90 % of the
   * exponential has fallen), count_every (ticks), window (ticks, of the test of convergence), hops
   * (shelters that a reset signal reaches, one after the other), height (m, of the camera above the
   * lights of the robots), aperture (degrees, of the camera), and events: "2+500 1-2500" activates
   * shelter 2 in tick 500, and deactivates shelter 1 in tick 2500. A shelter whose first event is
   * an activation is not active before.
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  struct SEvent {
    argos::UInt32 Tick;
    bool Activates;
  };

  void ReadSizes(const std::string& sizes);
  void ReadEvents(const std::string& events);
  void FollowEvents();
  void HearResets();
  /** Restarts the decay, and sends the signal on to @p hops more shelters. */
  void Restart(argos::UInt8 hops);
  void Count();
  void JudgeConvergence();
  void Broadcast();
  void Show();

  argos::CCI_CeilingAttachmentActuator* m_ceiling = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_RangeAndBearingActuator* m_mouth = nullptr;
  argos::CCI_RangeAndBearingSensor* m_ears = nullptr;
  argos::CCI_ColoredBlobPerspectiveCameraSensor* m_camera = nullptr;

  argos::UInt32 m_number = 0;
  argos::Real m_range = 0.8;
  argos::UInt32 m_capacity = 50;
  argos::UInt32 m_size = 25;  // target
  argos::Real m_leaveHigh = 1e-2;
  argos::Real m_leaveLow = 1e-5;
  argos::Real m_delta = 1000.0;
  argos::UInt32 m_countEvery = 10;
  argos::UInt32 m_window = 500;
  argos::UInt32 m_hops = 255;
  argos::Real m_height = 1.826;
  argos::Real m_aperture = 40.0;
  std::vector<SEvent> m_events;  // of this shelter, in the order of their ticks
  bool m_startsActive = true;

  argos::UInt32 m_tick = 0;
  bool m_isActive = true;
  argos::UInt32 m_ticksSinceReset = 0;
  argos::UInt32 m_deafTicks = 0;  // how long it ignores further reset signals
  argos::UInt8 m_hopsToSend = 0;
  argos::UInt32 m_group = 0;  // robots, at the last count
  argos::UInt32 m_windowTicks = 0;
  argos::UInt32 m_windowGroup = 0;
  bool m_isSteady = true;  // in the window so far
  bool m_hasConverged = false;
};

#endif
