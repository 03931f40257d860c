#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>

#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>

namespace argos {

CFootBotTurretEntity::CFootBotTurretEntity(CComposableEntity* parent, const std::string& id,
                                           SAnchor& anchor)
    : CTurretEntity(parent, id, anchor,
                    {footbot::kTurretProportionalGain, footbot::kTurretDerivativeGain}) {}

}  // namespace argos
