#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_BATTERY_MOUNT_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_ROBOT_BATTERY_MOUNT_H

namespace argos {

class CEntity;
class CRobotEntity;

/**
 * Makes the "battery" of a robot, as its child `<battery>` says, else its parameters; for
 * SComponentOnDemand.
 */
CEntity& MakeBattery(CRobotEntity& robot);

}  // namespace argos

#endif
