#ifndef TARGET_ROBOT_H
#define TARGET_ROBOT_H

#include "target_table.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>

/** A robot that stands still and marks a target: in each tick it broadcasts that it is at distance
 *  0, with a sequence number that it increments. */
class CTargetRobot : public argos::CCI_Controller {
 public:
  /** Reads target: 0 or 1. @throws CARGoSException if it is another number. */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  argos::CCI_RangeAndBearingActuator* m_sender = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::UInt32 m_target = 0;
  CTargetTable m_table;
};

#endif
