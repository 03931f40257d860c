#include <argos3/plugins/simulator/entities/passive_body_manual.h>

namespace argos {

std::string PassiveBodyManual(const std::string& name, const std::string& start,
                              const std::string& ledOffset) {
  return R"(  movable           "true" or "false", required.
  mass              kg, from 1e-6 to 1e9: required if movable, ignored otherwise.
  body@position     "x,y,z", m, default "0,0,0": the centre of the base, in the world frame.
  body@orientation  "z,y,x", degrees, default "0,0,0".

OPTIONAL XML

LEDs on the )" +
         name + R"(, seen by cameras:

  <arena size="10,10,2">
    )" + start +
         R"(
      <body position="1,0,0" orientation="0,0,0" />
      <leds medium="leds">
        <led offset=")" +
         ledOffset + R"(" anchor="origin" color="red" />
      </leds>
    </)" +
         name + R"(>
  </arena>

with their LED medium:

  <media>
    <led id="leds" />
  </media>

  leds@medium       text, required: the id of an LED medium.
  leds/led@offset   "x,y,z", m, required: from the centre of the base, in the )" +
         name + R"('s frame.
  leds/led@anchor   text, required: "origin".
  leds/led@color    a colour name or "R,G,B,A" with integers 0-255, required.
  rfid_tags         RFID tags on the )" +
         name + R"(; see the entity "rfid_tag".
)";
}

}  // namespace argos
