#include <argos3/plugins/robots/generic/simulator/tags_default_actuator.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>

namespace argos {

void CTagsDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_tags = &robot.GetComponent<CTagEquippedEntity>("tags");
  for (const auto& instance : m_tags->GetInstances()) {
    m_initSettings.push_back(instance.Tag.GetInitPayload());
  }
  m_tSettings = m_initSettings;
  m_tags->Enable();
}

void CTagsDefaultActuator::Update() {
  m_tags->SetTagPayloads(m_tSettings);
}

void CTagsDefaultActuator::Reset() {
  m_tSettings = m_initSettings;
}

REGISTER_ACTUATOR(
    CTagsDefaultActuator, "tags", "default", "the authors of this project", "1.0",
    "The payloads of a robot's tags.",
    R"(The controller sets the payload of each tag, or of all tags, as on an electronic label. The algorithm tag_detector
of the sensor "cameras" reads it. At the start and after a reset the tags have the payloads given in the robot's element.
)" + RequiredActuatorXML(R"(<tags implementation="default" />)") +
        CarriedPartsManual("tags", "tag", R"(<tags medium="tags">
      <tag position="-0.09,0,0.05" orientation="0,-90,0" anchor="origin" observable_angle="75" side_length="0.03"
           payload="fb0" />
    </tags>)"),
    "Usable")

}  // namespace argos
