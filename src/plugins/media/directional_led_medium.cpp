#include <argos3/plugins/simulator/media/directional_led_medium.h>

namespace argos {

REGISTER_MEDIUM(
    CDirectionalLEDMedium, "directional_led", "the authors of this project", "1.0",
    "Knows where directional LEDs are, for cameras.",
    R"(Every directional LED that cameras shall see belongs to such a medium; the algorithm
directional_led_detector of the sensor "cameras" names the medium that it looks at. LEDs outside the arena count like
all others.

A robot carries directional LEDs if its element says so:

  <foot-bot id="fb0">
    <body position="0,0,0" />
    <controller config="c1" />
    <directional_leds medium="directional_leds">
      <directional_led position="0.09,0,0.05" orientation="0,90,0" anchor="origin" observable_angle="60" color="red" />
    </directional_leds>
  </foot-bot>

  directional_leds@medium  text, required: the id of a directional_led medium.
  position                 "x,y,z", m, default "0,0,0": in the frame of the anchor.
  orientation              "z,y,x", degrees, default "0,0,0": the LED shines along the z axis that this turns; "0,90,0"
                           shines ahead.
  anchor                   text, required: a frame of the body, "origin" for all that does not turn on it.
  observable_angle         degrees in (0,180], required: from how far off that axis the LED is seen.
  color                    a colour name or "R,G,B,A" with integers 0-255, default black: at the start.

REQUIRED XML

  <media>
    <directional_led id="directional_leds" />
  </media>

ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": how LEDs near a point are found. It has no effect on results;
             "hash" takes less memory where the arena is large and LEDs are few.
  grid_size  "x,y,z", integers >= 1: into how many cells the arena is divided along each axis; default
             one cell for each whole metre. It has no effect on results.

For example:

  <media>
    <directional_led id="directional_leds" index="grid" grid_size="20,20,1" />
  </media>
)",
    "Usable")

}  // namespace argos
