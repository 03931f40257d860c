#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/run_commands.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/outputs/recording/capture.h>
#include <argos3/plugins/simulator/outputs/recording/format/drawing_coding.h>
#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_writer.h>
#include <argos3/plugins/simulator/outputs/recording/recorded_fields.h>
#include <argos3/plugins/simulator/outputs/recording/run_info.h>
#include <argos3/support/numbered_file.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace argos {

/** Records a run into a file, from which it can be replayed: `<recording>`. */
class CRecordingOutput : public CRunOutput {
 public:
  /** Reads the attributes that the plug-in's description lists, and creates the file. */
  void Init(TConfigurationNode& tree) override;
  /** The next run goes to another file: "run.rec", "run.2.rec", ... */
  void Reset() override;
  void Destroy() override;
  void Observe(CSimulator& simulator) override;
  void Finish(CSimulator& simulator) override;

 private:
  void Open();
  void Record(CSimulator& simulator);
  void AddPending();
  void KeepReplayedFields(CSpace& space);

  std::string m_location;  // place of the element
  std::string m_file;  // name as given
  UInt32 m_every = 1;
  EPrecision m_precision = EPrecision::Grid;
  UInt32 m_run = 1;  // since loading
  CCapture m_capture;
  std::optional<CRecordedFields> m_fields;  // none: no fields
  CViewDrawing m_drawing;
  bool m_hasDrawing = false;  // it is recorded
  UInt32 m_width = 0;  // pixels, of the picture for which code draws
  UInt32 m_height = 0;
  std::unique_ptr<CRecordingWriter> m_writer;  // null: closed
  std::optional<UInt32> m_lastTick;  // recorded
  std::optional<SFrameUpdate> m_pending;  // of that tick: its metrics may still change
  UInt32 m_numFrames = 0;
  UInt64 m_numRobotTicks = 0;
};

namespace {

// size of the picture for which users' code draws
constexpr UInt32 kDefaultWidth = 1280;  // pixels
constexpr UInt32 kDefaultHeight = 960;

// adds those since the last call
void TakeCommands(CSpace& space, SFrameUpdate& update) {
  for (CRunCommands::SCommand& command : space.GetExtension<CRunCommands>().Take()) {
    update.Commands.push_back({command.Tick, std::move(command.Text)});
  }
}

}  // namespace

void CRecordingOutput::Init(TConfigurationNode& tree) {
  m_location = OwnerOf(tree);
  GetNodeAttribute(tree, "file", m_file);
  if (m_file.empty()) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"file\" is empty; it must be the "
                                          "name of the recording, such as \"run.rec\"");
  }
  GetNodeAttributeOrDefault(tree, "every", m_every, m_every);
  if (m_every == 0) {
    THROW_ARGOSEXCEPTION(OwnerOf(tree)
                         << ": attribute \"every\" (ticks) must be at least 1, found 0");
  }
  std::string precision = CurrentContext().IsExactReplay ? "exact" : "grid";
  GetNodeAttributeOrDefault(tree, "precision", precision, precision);
  if (precision != "grid" && precision != "exact") {
    THROW_ARGOSEXCEPTION(OwnerOf(tree) << ": attribute \"precision\" must be \"grid\" "
                                       << "or \"exact\", found \"" << precision << '"'
                                       << DidYouMean(precision, {"grid", "exact"}));
  }
  m_precision = precision == "exact" ? EPrecision::Exact : EPrecision::Grid;
  GetNodeAttributeOrDefault(tree, "drawing", m_hasDrawing, CurrentContext().IsReplay);
  m_width = kDefaultWidth;
  m_height = kDefaultHeight;
  GetNodeAttributeOrDefault(tree, "drawing_width", m_width, m_width);
  GetNodeAttributeOrDefault(tree, "drawing_height", m_height, m_height);
  if (m_hasDrawing) {
    m_drawing.Init(tree);
  } else if (NodeExists(tree, "user_functions")) {
    THROW_ARGOSEXCEPTION(m_location << " has <user_functions>, but drawing=\"true\" is missing: "
                                       "what they draw would not be recorded");
  }
  if (NodeAttributeExists(tree, "fields")) {
    std::string fields;
    GetNodeAttribute(tree, "fields", fields);
    m_fields.emplace(m_location, fields, CurrentSpace());
  }
  CurrentSpace().GetExtension<CRunCommands>().Keep();
  try {
    if (CLoadingCheck::IsActive()) {
      CRecordingWriter::Check(m_file);
    } else {
      Open();
    }
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(tree) << ": the run cannot be recorded", error);
  }
}

void CRecordingOutput::Open() {
  SRecordingInfo info = MakeRunInfo(CurrentSimulator());
  info.Every = m_every;
  info.Precision = m_precision;
  m_writer = std::make_unique<CRecordingWriter>(NumberFile(m_file, static_cast<int>(m_run)), info);
}

void CRecordingOutput::Observe(CSimulator& simulator) {
  m_drawing.Observe(simulator);
  if (!m_lastTick || simulator.GetSpace().GetSimulationClock() % m_every == 0) {
    Record(simulator);
  }
}

void CRecordingOutput::Record(CSimulator& simulator) {
  if (m_writer == nullptr) {
    Open();
  }
  CSpace& space = simulator.GetSpace();
  if (!m_lastTick && !m_fields) {
    KeepReplayedFields(space);
  }
  SFrameUpdate update = m_writer->TakeUpdate();
  m_capture.Take(space, update);
  if (m_fields) {
    m_fields->Take(space, update);
  }
  if (m_hasDrawing) {
    CByteWriter out(update.Drawing);
    WriteDrawing(m_drawing.Draw(simulator, m_width, m_height), out);
  }
  TakeMetrics(space, update);
  TakeCommands(space, update);
  AddPending();
  m_pending = std::move(update);
  m_lastTick = space.GetSimulationClock();
  ++m_numFrames;
  m_numRobotTicks += space.GetControllableEntities().size();
}

void CRecordingOutput::AddPending() {
  if (m_pending) {
    m_writer->Add(std::move(*m_pending));
    m_pending.reset();
  }
}

// a recording of a replay has all that the replay has
void CRecordingOutput::KeepReplayedFields(CSpace& space) {
  std::set<std::string> names;
  for (const CEntity* root : space.GetRootEntityVector()) {
    if (const auto* const source = dynamic_cast<const CFieldSource*>(root)) {
      std::vector<std::string> listed;
      source->ListFields(listed);
      names.insert(listed.begin(), listed.end());
    }
  }
  if (!names.empty()) {
    m_fields.emplace(m_location, fmt::format("{}", fmt::join(names, ",")), space);
  }
}

void CRecordingOutput::Finish(CSimulator& simulator) {
  if (m_lastTick != simulator.GetSpace().GetSimulationClock()) {
    Record(simulator);
  } else if (m_pending) {
    // PostExperiment() may have recorded results, or replaced those of the last tick
    TakeMetrics(simulator.GetSpace(), *m_pending);
    TakeCommands(simulator.GetSpace(), *m_pending);
  }
  AddPending();
  m_writer->Close();
  const auto perRobot = [this](UInt64 bytes) {
    return m_numRobotTicks > 0 ? static_cast<Real>(bytes) / static_cast<Real>(m_numRobotTicks)
                               : 0.0;
  };
  CLogControl::Notify(fmt::format(
      "Recorded {} states to {}: {} bytes, {:.3g} for each robot and state, {:.3g} "
      "before compression",
      m_numFrames, NumberFile(m_file, static_cast<int>(m_run)), m_writer->GetNumWrittenBytes(),
      perRobot(m_writer->GetNumWrittenBytes()), perRobot(m_writer->GetNumCodedBytes())));
  m_writer.reset();
}

void CRecordingOutput::Reset() {
  if (m_writer != nullptr) {
    AddPending();
  }
  m_writer.reset();
  m_capture.Restart();
  m_lastTick.reset();
  m_numFrames = 0;
  m_numRobotTicks = 0;
  ++m_run;
}

void CRecordingOutput::Destroy() {
  // after an error: what was recorded until then is written
  if (m_writer != nullptr) {
    AddPending();
    m_writer->Close();
  }
  m_writer.reset();
  m_fields.reset();
  m_drawing.Destroy();
}

REGISTER_RUN_OUTPUT(
    CRecordingOutput, "recording", "the authors of this project", "1.0",
    "Records a run into a file, from which it can be replayed.",
    R"(Writes what pictures show of each tick: poses, colours of LEDs, lamps, rays of sensors, the
colours of the floor, robots in quarantine, which entities come and go, and metrics; besides, the
experiment as it is run, with overrides, seed, version and date. argos3 --replay FILE
shows it in any view, without controllers and physics: see doc/recording.md.

Files are compressed, and written on a thread of their own. A recording of a killed run
can be replayed up to about a second before its end. A file that is no recording is not
overwritten. If the experiment is reset, the next run goes to another file: run.2.rec,
run.3.rec, ... Recording does not change the experiment.

On the command line: --record FILE.

REQUIRED XML CONFIGURATION

  <outputs>
    <recording file="run.rec" />
  </outputs>

OPTIONAL XML CONFIGURATION

  <outputs>
    <recording file="run.rec" every="1" precision="grid"
               fields="battery,readings:footbot_proximity,lua:state" drawing="true">
      <user_functions label="ids" library="build/libids" />
    </recording>
  </outputs>

Attributes of <recording>:
  file       path; an older recording of that name is replaced
  every      integer, at least 1, ticks; record every n-th tick, and the last one.
             Default: 1
  precision  grid: poses rounded to 2^-20 m (about a micrometre), as views draw them.
             exact: all bits, for files several times as large. Default: grid, or
             exact in the replay of an exact recording
  fields     list: fields of robots to be recorded besides, which tables of a replay then
             have; argos3 -q fields lists them. Neither poses, which are there anyway, nor
             messages, of which a robot may have several. Default: none
  drawing    bool; record what the loop functions and the children <user_functions> draw,
             which every view of a replay then shows. Default: false
  drawing_width, drawing_height
             pixels; size of the picture for code that draws over it. Default: 1280, 960
)",
    "Usable")

}  // namespace argos
