#include <argos3/plugins/simulator/visualizations/offscreen/frame_output.h>

namespace argos {

/** Draws the arena into image files, with OpenGL and without a display: `<offscreen>`. */
class COffscreenOutput : public CFrameOutput {
 public:
  /** Reads the attributes that the plug-in's description lists. @throws CARGoSException with file
   * and line. */
  void Init(TConfigurationNode& tree) override { InitAsOffscreen(tree); }
};

REGISTER_RUN_OUTPUT(
    COffscreenOutput, "offscreen", "the authors of this project", "1.0",
    "Draws the arena into image files or films, without a display.",
    R"(Renders the arena with OpenGL in software, needing neither display nor GPU, and writes
numbered image files: the state before the first tick, after every n-th tick, and the
final state. Drawing and writing have threads of their own; at most four frames are under way. A file is <directory>/<base_name><tick, 10 digits>.<format>; it appears
under that name only when it is complete. Drawing does not change the experiment.

With file="film.mp4", or a format mp4, webm or gif, it writes a film instead, with the
program ffmpeg (ARGOS_FFMPEG, or in PATH); doc/make_a_film.md describes films. argos3
--video FILE adds a film in the view of the file's <offscreen>. Without ffmpeg, frames are
written to the folder FILE.frames, and the command that makes the film is printed.

While it runs, no other run can write frames of the same base name into the directory:
a hidden file there is locked, which is removed at the end. The next run removes files
<name>.argos3.part, which killed runs may leave.

REQUIRED XML CONFIGURATION

  <visualization>
    <offscreen />
  </visualization>

OPTIONAL XML CONFIGURATION

  <visualization>
    <offscreen file="film.mp4" speed="1" fps="30" />
    <offscreen directory="out" base_name="frame_" format="png" quality="-1"
               size="1280x960" every="1" ticks="0-50,550-600" samples="4" look="light"
               show_grid="true" show_boundary="true" show_rays="true"
               ground_texture="carpet.jpg" ground_texture_size="1">
      <camera view="oblique" fit="arena" projection="perspective" margin="0.04"
              lens_focal_length="50">
        <placements>
          <placement index="2" position="0,-3,3" look_at="0,0,0" />
          <placement index="1" position="2,2,1" look_at="0,0,0" up="0,0,1"
                     lens_focal_length="30" />
        </placements>
        <timeline loop="200">
          <keyframe placement="0" step="0" />
          <interpolate />
          <keyframe placement="1" step="100" />
          <interpolate />
        </timeline>
      </camera>
      <overlays>
        <clock />
        <ids />
        <trails duration="10" />
      </overlays>
      <user_functions label="my_drawing" library="path/to/library" />
    </offscreen>
  </visualization>

Attributes of <offscreen>:
  directory      path; folder of the files, created if missing. Default: out
  base_name      string without a slash; prefix of their names. Default: frame_
  format         string; an image format FreeImage writes: png, jpg, bmp, tif, ...; or
                 mp4, webm or gif: a film <directory>/<base_name>.<format>, whose
                 default base_name is film. Default: png
  file           path of a film, .mp4, .webm or .gif, in place of directory, base_name
                 and format. A further run after a reset: film.2.mp4, film.3.mp4, ...
  speed          of a film: simulated seconds in one of its seconds, from 0.0001 to 10000,
                 four decimals. Frames a second = speed * ticks_per_second / every.
                 Default: 1, real time
  fps            of a film: frames a second of the file, from 1 to 240 (gif: 50), for
                 which frames are repeated or left out. Default: as drawn, but from 1 to
                 60 (gif: 30)
  quality        integer, 0 to 100, or -1 for the format's own. jpg, webp: higher is
                 better; png, tif: higher is faster and larger. Default: -1
                 (png: 67). Of films, higher is better; gif: more colours
  size           WxH, pixels, each from 16 to 16384; of mp4 and webm, odd ones are made
                 even by one more pixel. Default: 1280x960
  width, height  the same as two attributes, pixels
  every          integer, at least 1, ticks; draw every n-th tick. Default: 1; of
                 films, what gives at most 30 frames a second (at least fps, if given)
  ticks          ticks and ranges of ticks, increasing, separated by commas: only their
                 frames are drawn, of these every n-th tick. Default: the whole run
  samples        1, 2, 4, 8 or 16 per pixel, for smooth edges. Default: 4
  look           light (for print) or dark (for slides). Default: light
  show_grid      bool; lines on the ground every 0.1, 1 and 10 m, as far as they can be
                 told apart, also on floors and outside the arena. Default: true
  show_boundary  bool; the outline of the arena. Default: true
  show_rays      bool; the rays of sensors that have show_rays="true", and their
                 hits, where obstructed rays end. Default: true

  ground_texture
                 path of an image file, which covers the ground of an arena that has no
                 <floor>. Only views show it: sensors see the ground as without it.
                 Default: none
  ground_texture_size
                 m, positive: width of one image, which is repeated from the lower left
                 corner of the arena. Default: one image covers the arena

Attributes of <placement>:
  index              integer, 0 to 11; idx is accepted, too
  position, look_at  x,y,z in m; place of the camera, and the point it looks at
  up                 x,y,z; upwards on the picture. Default: as upright as possible
  lens_focal_length  mm, positive; the picture's height is seen under the angle
                     2 atan(13.5 mm / lens_focal_length). Default: 20
  orthographic_height  m, positive: height of what the picture shows, in parallel
                     projection; lengths across the line of sight are true to scale.
                     Default: 0, perspective

Placement 0 is in use if there is no timeline. Unless it is given, attributes of <camera>
describe it; the others stand in a circle around the arena:
  view               oblique: from the side of negative y, 52 degrees above the horizon;
                     top: from above, +x to the right and +y upwards; side: from negative
                     y, horizontally; front: from positive x, horizontally; corner: from
                     negative x and y, isometric if orthographic. Default: oblique
  fit                arena: just contains the arena's ground and all entities; contents:
                     just contains entities (lamps only above the arena). What it shows
                     may grow in the run, but never shrinks. Default: arena
  projection         perspective or orthographic. Default: perspective
  margin             share of the picture that stays free, at least 0. Default: 0.04
  lens_focal_length  mm, positive; longer: from farther away. Default: 50
  follow             id of an entity in the arena: all placements are relative to its
                     position, and the view shows its surroundings. Default: none
  reach              m, positive: how far around the followed entity the view shows.
                     Default: 1
A <placement> that looks straight down has +x upwards; up="0,1,0" puts +x to the right.
A camera inside of an entity is reported, and shows it from within.

LEDs that are lit are drawn at least 4.4 pixels wide, and robots smaller than 5 pixels as discs
(in pictures 960 pixels high; in others in proportion; smaller if many). LEDs of the component
"leds" that a robot's appearance does not contain are drawn 1 cm wide at their places.

The timeline:
  keyframe@step       integer, ticks: from this tick on the camera is at the placement; steps must
                      not decrease
  keyframe@placement  integer; index of a placement
  timeline@loop       integer, ticks: period after which the timeline begins again, which no step
                      may exceed; 0: none. Default: 0
With <interpolate /> between two keyframes, the camera glides from one to the next; one after the
last keyframe leads back to the first.

<overlays>: its children add clock, ids, trails and more; argos3 -q overlays lists them.

<user_functions> (any number) adds what users' code draws, see doc/drawing.md:
  label    string; as in REGISTER_QTOPENGL_USER_FUNCTIONS or REGISTER_DRAWING_FUNCTIONS
  library  path; may be absent if a loaded library has registered the label
)",
    "Usable")

}  // namespace argos
