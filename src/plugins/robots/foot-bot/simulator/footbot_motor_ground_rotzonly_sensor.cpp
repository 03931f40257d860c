#include <argos3/plugins/robots/foot-bot/simulator/footbot_motor_ground_rotzonly_sensor.h>

namespace argos {

REGISTER_SENSOR(
    CFootBotMotorGroundRotZOnlySensor, "footbot_motor_ground", "rot_z_only",
    "the authors of this project", "1.0", "The ground sensors between the wheels of the foot-bot.",
    R"(The four sensors between the wheels of the foot-bot, at (6.3, 1.16), (-6.3, 1.16), (-6.3, -1.16) and (6.3, -1.16) cm
from its centre (x ahead, y left). Each reads the colour of the floor straight below it, as the grey level
(0.299 red + 0.587 green + 0.114 blue) / 255: 0 is black, 1 is white.
Bodies do not occlude the floor.
)" + GroundSensorManual("footbot_motor_ground", "it is clamped to [0,1]"),
    "Usable")

}  // namespace argos
