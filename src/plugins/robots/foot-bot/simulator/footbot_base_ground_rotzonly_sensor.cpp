#include <argos3/plugins/robots/foot-bot/simulator/footbot_base_ground_rotzonly_sensor.h>

namespace argos {

REGISTER_SENSOR(
    CFootBotBaseGroundRotZOnlySensor, "footbot_base_ground", "rot_z_only",
    "the authors of this project", "1.0", "The ground sensors around the base of the foot-bot.",
    R"(The eight sensors around the base of the foot-bot, at (8, 0), (4.2, 6.5), (0, 8), (-4.2, 6.5), (-8, 0), (-4.2, -6.5),
(0, -8) and (4.2, -6.5) cm from its centre (x ahead, y left). Each reads 0 if the grey level of the floor straight below
it, (0.299 red + 0.587 green + 0.114 blue) / 255, is less than 0.5, otherwise 1.
Bodies do not occlude the floor.
)" + GroundSensorManual("footbot_base_ground", "it is compared with 0.5"),
    "Usable")

}  // namespace argos
