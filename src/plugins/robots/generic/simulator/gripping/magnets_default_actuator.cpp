#include <argos3/plugins/robots/generic/simulator/magnets_default_actuator.h>

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>

namespace argos {

void CMagnetsDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_robot = &robot;
  m_magnets = &robot.GetComponent<CMagnetEquippedEntity>("magnets");
  for (const auto& instance : m_magnets->GetInstances()) {
    m_vecInterfaces.emplace_back(instance.Magnet.GetId(), 0.0);
  }
}

void CMagnetsDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_MagnetsActuator::Init(tree);
  m_noise.Init(tree, m_robot->GetComponent<CControllableEntity>("controller"), {"current"});
}

void CMagnetsDefaultActuator::Update() {
  for (size_t i = 0; i < m_vecInterfaces.size(); ++i) {
    const Real current = m_noise.Apply(0, m_vecInterfaces[i].Current);
    m_magnets->GetInstances()[i].Magnet.SetCurrent(current);
  }
}

void CMagnetsDefaultActuator::Reset() {
  for (SInterface& interface : m_vecInterfaces) {
    interface.Current = 0.0;
  }
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CMagnetsDefaultActuator, "magnets", "default", "the authors of this project", "1.0",
    "The currents of a robot's magnets.",
    R"(The controller sets the current of each magnet, as a multiple of the current for which the magnet's active
field is given. The magnet's field is passive_field + current * active_field, a dipole moment in the frame of its
anchor. Its effect on other magnets is computed by physics engines that model magnetism, and ignored by others. Currents
are 0 at the start and after a reset.
)" + RequiredActuatorXML(R"(<magnets implementation="default" />)") +
        R"(
on a robot that carries magnets:
)" + CarrierXML(R"(<magnets>
      <magnet id="front" offset="0.08,0,0.05" anchor="origin" passive_field="1,0,0" active_field="-1,0,0" />
    </magnets>)") +
        R"(
  id             text, default magnet_0, magnet_1, ...: the magnet's name for the controller.
  offset         "x,y,z", m, required: in the frame of the anchor.
  anchor         text, required: a frame of the body; "origin" for magnets that do not rotate on the body.
  passive_field  "x,y,z", required: the field without current.
  active_field   "x,y,z", default "0,0,0": the field that one unit of current adds.
)" +
        OptionalNoiseXML("magnets",
                         R"(on="current" model="gaussian" std_dev="0.01" relative="true")") +
        NoiseManual("current", "the current, in each tick."),
    "Usable")

}  // namespace argos
