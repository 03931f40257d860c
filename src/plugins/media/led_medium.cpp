#include <argos3/plugins/simulator/media/led_medium.h>

namespace argos {

REGISTER_MEDIUM(
    CLEDMedium, "led", "the authors of this project", "1.0",
    "Index of the LEDs and lights that cameras see.",
    R"(Cameras see the LEDs and lights in an LED medium; each camera selects the medium. LEDs outside the arena
are included.

REQUIRED XML

  <media>
    <led id="leds" />
  </media>

ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": spatial index of the LEDs. It has no effect on results;
             "hash" takes less memory for few LEDs in a large arena.
  grid_size  "x,y,z", integers >= 1: number of grid cells along each axis; default
             one cell for each whole metre. It has no effect on results.

For example:

  <media>
    <led id="leds" index="grid" grid_size="20,20,1" />
  </media>
)",
    "Usable")

}  // namespace argos
