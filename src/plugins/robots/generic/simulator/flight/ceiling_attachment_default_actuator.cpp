#include <argos3/plugins/robots/generic/simulator/ceiling_attachment_default_actuator.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>

namespace argos {

CCeilingAttachmentDefaultActuator::~CCeilingAttachmentDefaultActuator() {
  if (m_quadrotor != nullptr) {
    m_quadrotor->SetAttached(false);
  }
}

void CCeilingAttachmentDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_quadrotor = &robot.GetComponent<CQuadRotorEntity>("quadrotor");
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  m_space = &CurrentSpace();
}

void CCeilingAttachmentDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_CeilingAttachmentActuator::Init(tree);
  GetNodeAttributeOrDefault(tree, "reach", m_reach, m_reach);
  RequireIn(kNotNegative, m_reach, tree.GetLocation() + ": <ceiling_attachment>",
            "attribute \"reach\"");
}

bool CCeilingAttachmentDefaultActuator::IsAttached() const {
  return m_quadrotor->IsAttached();
}

Real CCeilingAttachmentDefaultActuator::ComputeGap() const {
  return m_space->GetArenaLimits().GetMax().GetZ() - m_body->GetBoundingBox().MaxCorner.GetZ();
}

void CCeilingAttachmentDefaultActuator::Update() {
  if (m_wantsAttachment != m_quadrotor->IsAttached()) {
    m_quadrotor->SetAttached(m_wantsAttachment && ComputeGap() <= m_reach);
  }
}

void CCeilingAttachmentDefaultActuator::Reset() {
  m_wantsAttachment = false;
}

REGISTER_ACTUATOR(
    CCeilingAttachmentDefaultActuator, "ceiling_attachment", "default",
    "the authors of this project", "1.0", "Attaches a flying robot to the ceiling.",
    R"(The ceiling is the upper limit of the arena. After attach(), the robot attaches in the first tick in which its
top is in reach of the ceiling: from then on it stays where it is, without control and whatever pushes it, until detach(); then
it flies on from rest, with the targets that its other actuators have by then. At the start and after a reset it is detached.
)" + RequiredActuatorXML(R"(<ceiling_attachment implementation="default" />)") +
        OptionalXML(R"(<ceiling_attachment implementation="default" reach="0.05" />)") + R"(
  reach  m, >= 0, default 0.05: largest distance between robot and ceiling.
)",
    "Usable")

}  // namespace argos
