#include <argos3/plugins/simulator/media/tag_medium.h>

namespace argos {

REGISTER_MEDIUM(
    CTagMedium, "tag", "the authors of this project", "1.0", "Knows where tags are, for cameras.",
    R"(Every tag, a square with a text that cameras can read, belongs to such a medium; the algorithm tag_detector
of the sensor "cameras" names the medium that it looks at. Tags outside the arena count like all others.

A robot carries tags if its element says so:

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
  orientation       "z,y,x", degrees, default "0,0,0": the tag lies in the xy plane that this turns, and is read from
                    where the z axis points; "0,-90,0" is read from behind the robot.
  anchor            text, required: a frame of the body, "origin" for all that does not turn on it.
  observable_angle  degrees in (0,180], required: from how far off that axis the tag is read.
  side_length       m, > 0, required.
  payload           text, default empty: what is read at the start.

REQUIRED XML

  <media>
    <tag id="tags" />
  </media>

ATTRIBUTES

  id         text, required: unique among the media.
  index      "grid" (default) or "hash": how tags near a point are found. It has no effect on results;
             "hash" takes less memory where the arena is large and tags are few.
  grid_size  "x,y,z", integers >= 1: into how many cells the arena is divided along each axis; default
             one cell for each whole metre. It has no effect on results.

For example:

  <media>
    <tag id="tags" index="grid" grid_size="20,20,1" />
  </media>
)",
    "Usable")

}  // namespace argos
