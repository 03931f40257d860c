#include <argos3/plugins/robots/generic/simulator/rfid_antenna.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/generic/simulator/medium_attribute.h>

namespace argos {

void CRFIDAntenna::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_body = &robot.GetComponent<CEmbodiedEntity>("body");
}

void CRFIDAntenna::Init(TConfigurationNode& tree) {
  m_medium = &ReadMedium<CRFIDMedium>(tree, m_robot->GetSimulator(), "an RFID medium");
  GetNodeAttributeOrDefault(tree, "range", m_range, m_range);
  RequireNotNegative(m_range, OwnerOf(tree), "attribute \"range\" (m)");
  GetNodeAttributeOrDefault(tree, "position", m_position, m_position);
  m_user = std::make_unique<CRFIDMedium::CUser>(*m_medium, *m_robot, m_range);
}

CVector3 CRFIDAntenna::ComputePlace() const {
  const SAnchor& origin = m_body->GetOriginAnchor();
  CVector3 place = m_position;
  place.Rotate(origin.Orientation);
  return origin.Position + place;
}

}  // namespace argos
