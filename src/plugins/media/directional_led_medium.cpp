#include <argos3/plugins/simulator/media/directional_led_medium.h>

#include <argos3/plugins/simulator/media/medium_manual.h>

namespace argos {

REGISTER_MEDIUM(
    CDirectionalLEDMedium, "directional_led", "the authors of this project", "1.0",
    "Index of the directional LEDs that cameras see.",
    R"(Cameras see the directional LEDs in such a medium; the algorithm directional_led_detector of the sensor
"cameras" selects the medium. LEDs outside the arena are included.

Directional LEDs on a robot:

  <foot-bot id="fb0">
    <body position="0,0,0" />
    <controller config="c1" />
    <directional_leds medium="directional_leds">
      <directional_led position="0.09,0,0.05" orientation="0,90,0" anchor="origin" observable_angle="60" color="red" />
    </directional_leds>
  </foot-bot>

  directional_leds@medium  text, required: the id of a directional_led medium.
  position                 "x,y,z", m, default "0,0,0": in the frame of the anchor.
  orientation              "z,y,x", degrees, default "0,0,0": of the LED's frame; the LED shines along its z axis.
                           "0,90,0" shines forward.
  anchor                   text, required: a frame of the body; "origin" is fixed to the body.
  observable_angle         degrees in (0,180], required: the largest angle to that axis at which the LED is visible.
  color                    a colour name or "R,G,B,A" with integers 0-255, default black: colour at the start.
)" + IndexMediumManual("directional_led", "directional_leds", "LEDs"),
    "Usable")

}  // namespace argos
