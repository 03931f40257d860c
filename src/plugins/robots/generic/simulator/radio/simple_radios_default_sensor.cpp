#include <argos3/plugins/robots/generic/simulator/simple_radios_default_sensor.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>

namespace argos {

void CSimpleRadiosDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_radios = &robot.GetComponent<CSimpleRadioEquippedEntity>("simple_radios");
  for (const auto& instance : m_radios->GetInstances()) {
    m_vecInterfaces.emplace_back(instance.Radio.GetId());
  }
  m_radios->Enable();
}

void CSimpleRadiosDefaultSensor::Init(TConfigurationNode& tree) {
  CCI_SimpleRadiosSensor::Init(tree);
  GetNodeAttributeOrDefault(tree, "show_rays", m_bShowRays, m_bShowRays);
  Enable();
}

void CSimpleRadiosDefaultSensor::Update() {
  for (size_t i = 0; i < m_vecInterfaces.size(); ++i) {
    CSimpleRadioEntity& radio = m_radios->GetInstances()[i].Radio;
    const auto& messages = radio.GetMessages();
    for (size_t m = 0; m_bShowRays && m < messages.size(); ++m) {
      // one line for all messages of a sender
      if (m == 0 || !(messages[m].first == messages[m - 1].first)) {
        m_robot->AddCheckedRay(false, CRay3(messages[m].first, radio.GetPosition()));
      }
    }
    radio.Read(m_vecInterfaces[i].Messages);
  }
}

void CSimpleRadiosDefaultSensor::Reset() {
  for (size_t i = 0; i < m_vecInterfaces.size(); ++i) {
    m_radios->GetInstances()[i].Radio.TakeBack(m_vecInterfaces[i].Messages);
  }
}

REGISTER_SENSOR(
    CSimpleRadiosDefaultSensor, "simple_radios", "default", "the authors of this project", "1.0",
    "Receives messages of any size with the robot's radios.",
    R"(Lists for each radio of the robot the messages, arrays of bytes of any size, that other radios sent to it in
this tick, in the order in which the sending robots were added to the arena.
)" + RequiredSensorXML(R"(<simple_radios implementation="default" />)") +
        CarriedPartsManual("radios", "simple_radio", R"(<simple_radios>
      <simple_radio id="wifi" medium="radios" range="5" position="0,0,0.1" />
    </simple_radios>)") +
        OptionalXML(R"(<simple_radios implementation="default" show_rays="true" />)") +
        R"(
  show_rays  "true" or "false", default "false": visualizations show lines from the senders.
)",
    "Usable")

}  // namespace argos
