#include <argos3/plugins/simulator/visualizations/live/live_visualization.h>

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>

namespace argos {

CLiveVisualization::CLiveVisualization() = default;
CLiveVisualization::~CLiveVisualization() = default;

void CLiveVisualization::Init(TConfigurationNode& tree) {
  try {
    CDynamicLoading::LoadLibrary("on_demand/libargos3_live");
  } catch (CARGoSException& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        "the live view needs a library that is built where Boost and nlohmann-json are installed "
        "(Debian: libboost-dev nlohmann-json3-dev); scripts/run.sh EXPERIMENT --live installs them",
        error);
  }
  m_engine.reset(
      CFactory<CLiveEngine>::New(NodeAttributeExists(tree, "commands") ? "live_commands" : "live"));
  m_engine->Init(tree);
}

void CLiveVisualization::Reset() {
  m_engine->Reset();
}

void CLiveVisualization::Destroy() {
  if (m_engine != nullptr) {
    m_engine->Destroy();
  }
}

void CLiveVisualization::Execute() {
  m_engine->Execute();
}

REGISTER_VISUALIZATION(
    CLiveVisualization, "live", "the authors of this project", "1.0",
    "Shows the running experiment in a web browser, and lets its users touch it.",
    R"(Serves a page by HTTP, and prints its URL: the robots in 3D, play, pause and step, what a robot
senses and does, the log and the metrics. Several viewers may look at one run; one of them has
control. A viewer that looks only does not change the experiment, and slows no tick. See
doc/live.md.

On the command line: --live or --live=PORT, in place of what <visualization> has; --live-socket for
a run that does not wait for viewers. A replay can be shown, too: argos3 --replay FILE --live.

REQUIRED XML CONFIGURATION

  <visualization>
    <live />
  </visualization>

OPTIONAL XML CONFIGURATION

  <visualization>
    <live port="8000" address="127.0.0.1" play="true" speed="1" fps="25" hosts="lab.example.org"
          open="false" linger="30" edit="true" url_file="run.url">
      <user_functions label="ids" library="build/libids" />
    </live>
  </visualization>

Attributes of <live>:
  port       integer from 0 to 65535; 0: a free one. Default: 0
  address    of this computer, on which to listen; 0.0.0.0: all, which lets others in who know
             the URL. Default: 127.0.0.1, for viewers on this computer and through SSH
  hosts      list: other names of this computer by which viewers may call it, such as that of a
             reverse proxy. Default: none
  play       bool; run at once. Otherwise the run waits until a viewer plays it. Default: false
  speed      number >= 0; simulated seconds in a second; 0: as fast as it goes. Default: 1
  fps        number from 0.1 to 100; states a second for each viewer. Default: 25
  open       bool; open the page where there is a display. Default: true
  linger     number >= 0, s; when the run is over and no viewer has been connected for so long,
             the program ends. Default: 30. A run without any viewer ends at once
  edit       bool; the viewer with control may edit the Lua scripts of robots, which then run as
             this user, with all that scripts may do. Files stay as they are. Default: false
  control    bool; one of the viewers can have control. false: all only look. Default: true
  url_file   path of a file that has the URL while the run lasts, and that only this user can
             read; auto: a new file in a folder that `argos3-campaign live` lists. With play="true",
             the run then goes on, at its speed, when the last viewer has left. Default: none
  commands   path of a recording: nothing is served; what viewers did in that run is done again,
             after the same ticks. On the command line, with the seed of the recording:
             --replay-commands FILE
  drawing_width, drawing_height
             pixels; size of the picture for code that draws over it. Default: 1280, 960
Children <user_functions> and <overlays> draw as in other views.
)",
    "Usable")

}  // namespace argos
