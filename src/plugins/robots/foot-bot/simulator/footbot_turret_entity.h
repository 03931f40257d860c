#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_ENTITY_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_ENTITY_H

#include <argos3/plugins/simulator/entities/turret_entity.h>

namespace argos {

/** The turret of a foot-bot, which carries the LEDs and the gripper. */
class CFootBotTurretEntity : public CTurretEntity {
 public:
  /** @param anchor  the rotating frame on the foot-bot's body. */
  CFootBotTurretEntity(CComposableEntity* parent, const std::string& id, SAnchor& anchor);
};

}  // namespace argos

#endif
