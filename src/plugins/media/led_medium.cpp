#include <argos3/plugins/simulator/media/led_medium.h>

#include <argos3/plugins/simulator/media/medium_manual.h>

namespace argos {

REGISTER_MEDIUM(
    CLEDMedium, "led", "the authors of this project", "1.0",
    "Index of the LEDs and lights that cameras see.",
    R"(Cameras see the LEDs and lights in an LED medium; each camera selects the medium. LEDs outside the arena
are included.
)" + IndexMediumManual("led", "leds", "LEDs"),
    "Usable")

}  // namespace argos
