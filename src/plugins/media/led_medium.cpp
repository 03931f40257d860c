#include <argos3/plugins/simulator/media/led_medium.h>

namespace argos {

REGISTER_MEDIUM(
    CLEDMedium, "led", "the authors of this project", "1.0",
    "Knows where LEDs and lights are, for cameras.",
    R"(Every LED and light that cameras shall see belongs to an LED medium; cameras name the medium
they look at. LEDs outside the arena count like all others.

REQUIRED XML

  <media>
    <led id="leds" />
  </media>

ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": how LEDs near a point are found. It has no effect on results;
             "hash" takes less memory where the arena is large and LEDs are few.
  grid_size  "x,y,z", integers >= 1: into how many cells the arena is divided along each axis; default
             one cell for each whole metre. It has no effect on results.

For example:

  <media>
    <led id="leds" index="grid" grid_size="20,20,1" />
  </media>
)",
    "Usable")

}  // namespace argos
