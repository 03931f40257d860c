#include <argos3/plugins/robots/eye-bot/simulator/eyebot_proximity_default_sensor.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

REGISTER_SENSOR(
    CEyeBotProximityDefaultSensor, "eyebot_proximity", "default", "the authors of this project",
    "1.0", "The proximity sensors of the eye-bot.",
    R"(A ring of 24 sensors at a height of 16 cm above the base, counter-clockwise from 7.5 degrees in steps of
15, each with a horizontal ray of 3 m that starts 5 mm outside the body. If the ray hits a body other than the robot's
own at the distance D (m) from its start, the sensor reads 1 for D < 0.009889556, otherwise
0.0100527 / (D + 0.000163144): 0.0034 at the end of its range. If the ray hits nothing, the sensor reads 0.
)" + RayReadingsManual("eyebot_proximity", "default", "the rays"),
    "Usable")

}  // namespace argos
