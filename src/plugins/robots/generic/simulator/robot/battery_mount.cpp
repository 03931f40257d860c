#include <argos3/plugins/robots/generic/simulator/battery_mount.h>

#include <argos3/plugins/robots/generic/simulator/robot_entity.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>

namespace argos {

CEntity& MakeBattery(CRobotEntity& robot) {
  auto& battery = robot.MakeOnDemand<CBatteryEquippedEntity>("battery_0");
  TConfigurationNode* const tree = robot.GetConfigurationNode();
  if (tree != nullptr && NodeExists(*tree, "battery")) {
    battery.Configure(GetNode(*tree, "battery"));
  } else {
    battery.SetDischargeModel(robot.GetDeviceParameters().Battery.Model);
  }
  return battery;
}

}  // namespace argos
