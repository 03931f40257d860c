#include <argos3/plugins/robots/generic/simulator/rab_component.h>

#include <argos3/plugins/robots/generic/simulator/robot_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>

namespace argos {

CEntity& MakeRABComponent(CRobotEntity& robot, const CVector3& offset) {
  const SRABParameters& parameters = robot.GetDeviceParameters().RAB;
  CEmbodiedEntity& body = robot.GetEmbodiedEntity();
  return robot.MakeOnDemand<CRABEquippedEntity>("rab_0", parameters.DataSize, parameters.Range,
                                                body.GetOriginAnchor(), body, offset);
}

}  // namespace argos
