#include <argos3/plugins/robots/foot-bot/simulator/footbot_light_rotzonly_sensor.h>

namespace argos {

REGISTER_SENSOR(CFootBotLightRotZOnlySensor, "footbot_light", "rot_z_only",
                "the authors of this project", "1.0", "The light sensors of the foot-bot.",
                AngularLightManual("footbot_light"), "Usable")

}  // namespace argos
