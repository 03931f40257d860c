#include <argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_output.h>

namespace argos {

REGISTER_RUN_OUTPUT(
    CQtOpenGlOutput, "qt-opengl", "the authors of this project", "1.0",
    "Runs experiments written for the Qt-OpenGL window: headless, or to frames.",
    R"(There is no window. An experiment file that requests it runs headless, at full speed; if
it has a <frame_grabbing> element whose headless_grabbing is not "false", frames are drawn
off-screen. One line in the log says which. For new files, use <offscreen>.

REQUIRED XML CONFIGURATION

  <visualization>
    <qt-opengl />
  </visualization>

OPTIONAL XML CONFIGURATION

  <visualization>
    <qt-opengl title="" autoplay="false" lua_editor="false" invert_mouse="false"
               show_boundary="true">
      <camera> ... as for <offscreen> ... </camera>
      <frame_grabbing directory="frames" base_name="frame_" format="png" quality="100"
                      headless_grabbing="true" headless_frame_size="1600x1200"
                      headless_frame_rate="10" />
      <user_functions label="my_functions" library="path/to/library" />
    </qt-opengl>
  </visualization>

Attributes of <qt-opengl>:
  title, autoplay, lua_editor, invert_mouse  settings of the window; checked, without effect
  show_boundary        bool; the outline of the arena. Default: true

Attributes of <frame_grabbing>:
  directory            path; must exist. Default: . (the working directory)
  base_name            string; prefix of the file names. Default: frame_
  format               string; an image format FreeImage writes. Default: png
  quality              integer, 0 to 100, or -1 for the format's own. Default: -1
  headless_grabbing    bool; false: do not draw frames. Default: true
  headless_frame_size  WxH, pixels, each from 16 to 16384. Default: 1600x1200
  headless_frame_rate  integer, at least 1, ticks; keep every n-th frame. Default: 1

The camera begins in placement 0, by default at (centre x + |size|, centre y, height), where
|size| is the length of the arena's diagonal.

<user_functions> (any number) adds what users' code draws to the frames, see doc/drawing.md;
without frames it is not loaded. Its library may be absent if a loaded library has
registered the label.
)",
    "Usable")

}  // namespace argos
