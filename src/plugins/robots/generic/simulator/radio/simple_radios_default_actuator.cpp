#include <argos3/plugins/robots/generic/simulator/simple_radios_default_actuator.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>

namespace argos {

void CSimpleRadiosDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_radios = &robot.GetComponent<CSimpleRadioEquippedEntity>("simple_radios");
  for (const auto& instance : m_radios->GetInstances()) {
    m_vecInterfaces.emplace_back(instance.Radio.GetId());
  }
  m_radios->Enable();
}

void CSimpleRadiosDefaultActuator::Update() {
  for (size_t i = 0; i < m_vecInterfaces.size(); ++i) {
    if (!m_vecInterfaces[i].Messages.empty()) {
      m_radios->GetInstances()[i].Radio.Send(m_vecInterfaces[i].Messages);
    }
  }
}

void CSimpleRadiosDefaultActuator::Reset() {
  for (SInterface& interface : m_vecInterfaces) {
    interface.Messages.clear();
  }
}

REGISTER_ACTUATOR(
    CSimpleRadiosDefaultActuator, "simple_radios", "default", "the authors of this project", "1.0",
    "Sends messages of any size with the robot's radios.",
    R"(The controller appends messages, arrays of bytes of any size, to the queue of a radio. The radio sends them
once, in the next tick, before the robots move, to every other radio of the medium within range.
)" + RequiredActuatorXML(R"(<simple_radios implementation="default" />)") +
        CarriedPartsManual("radios", "simple_radio", R"(<simple_radios>
      <simple_radio id="wifi" medium="radios" range="5" position="0,0,0.1" />
    </simple_radios>)"),
    "Usable")

}  // namespace argos
