#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RFID_MEDIUM_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RADIO_RFID_MEDIUM_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_actuator.h>
#include <argos3/plugins/robots/generic/simulator/rfid_antenna.h>

namespace argos {

/** Hands orders to write over to a medium, which knows the tags. */
class CRFIDMediumActuator : public CSimulatedActuator, public CCI_RFIDActuator {
 public:
  void SetRobot(CComposableEntity& robot) override { m_antenna.SetRobot(robot); }
  /** Reads what CRFIDAntenna::Init() does. @throws CARGoSException if a value is wrong. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** No order. */
  void Reset() override { m_isOrdered = false; }
  const std::string& GetWrittenTag() const override { return m_antenna.GetUser().WrittenTag; }

 private:
  CRFIDAntenna m_antenna;
};

}  // namespace argos

#endif
