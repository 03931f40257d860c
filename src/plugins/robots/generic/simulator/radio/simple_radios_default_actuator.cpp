#include <argos3/plugins/robots/generic/simulator/simple_radios_default_actuator.h>

#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>

namespace argos {

void CSimpleRadiosDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_radios = &robot.GetComponent<CSimpleRadioEquippedEntity>("simple_radios");
  for (const auto& instance : m_radios->GetInstances()) {
    m_vecInterfaces.emplace_back(instance.Entity.GetId());
  }
  m_radios->Enable();
}

void CSimpleRadiosDefaultActuator::Update() {
  for (size_t i = 0; i < m_vecInterfaces.size(); ++i) {
    if (!m_vecInterfaces[i].Messages.empty()) {
      m_radios->GetInstances()[i].Entity.Send(m_vecInterfaces[i].Messages);
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
    R"(The controller appends messages, arrays of bytes of any size, to those that a radio is to send. They are sent
in the next tick, once, before robots move, and reach every other radio of the medium within range.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <simple_radios implementation="default" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

on a robot that carries radios:

  <foot-bot id="fb0">
    <body position="0,0,0" />
    <controller config="c1" />
    <simple_radios>
      <simple_radio id="wifi" medium="radios" range="5" position="0,0,0.1" />
    </simple_radios>
  </foot-bot>

The medium "simple_radio" explains these attributes.
)",
    "Usable")

}  // namespace argos
