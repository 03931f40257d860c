#include <argos3/plugins/simulator/media/tag_medium.h>

#include <argos3/plugins/simulator/media/medium_manual.h>

namespace argos {

REGISTER_MEDIUM(
    CTagMedium, "tag", "the authors of this project", "1.0", "Index of the tags that cameras read.",
    R"(Cameras read the tags, squares with a text, in such a medium; the algorithm tag_detector
of the sensor "cameras" selects the medium. Tags outside the arena are included.

Tags on a robot:

  <foot-bot id="fb0">
    <body position="0,0,0" />
    <controller config="c1" />
    <tags medium="tags">
      <tag position="-0.09,0,0.05" orientation="0,-90,0" anchor="origin" observable_angle="75" side_length="0.03"
           payload="fb0" />
    </tags>
  </foot-bot>

  tags@medium       text, required: the id of a tag medium.
  position          "x,y,z", m, default "0,0,0": of the tag's centre, in the frame of the anchor.
  orientation       "z,y,x", degrees, default "0,0,0": of the tag's frame; the tag is in its xy plane and readable from
                    the side of its z axis. A tag with "0,-90,0" is readable from behind the robot.
  anchor            text, required: a frame of the body; "origin" is fixed to the body.
  observable_angle  degrees in (0,180], required: the largest angle to that axis at which the tag is readable.
  side_length       m, > 0, required.
  payload           text, default empty: text at the start.
)" + IndexMediumManual("tag", "tags", "tags"),
    "Usable")

}  // namespace argos
