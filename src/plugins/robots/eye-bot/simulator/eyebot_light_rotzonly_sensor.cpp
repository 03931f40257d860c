#include <argos3/plugins/robots/eye-bot/simulator/eyebot_light_rotzonly_sensor.h>

namespace argos {

REGISTER_SENSOR(CEyeBotLightRotZOnlySensor, "eyebot_light", "rot_z_only",
                "the authors of this project", "1.0", "The light sensors of the eye-bot.",
                AngularLightManual("eyebot_light"), "Usable")

}  // namespace argos
