#include <argos3/plugins/simulator/visualizations/live/run/commands_run.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/run_commands.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/outputs/recording/format/recording_reader.h>

namespace argos {

void CCommandsRun::Init(TConfigurationNode& tree) {
  std::string file;
  GetNodeAttribute(tree, "commands", file);
  m_drawing.Init(tree);
  ReadCommands(file);
}

void CCommandsRun::ReadCommands(const std::string& file) {
  CRecordingReader reader(file);
  for (const SRecordedFrame* frame = reader.ReadNext(); frame != nullptr;
       frame = reader.ReadNext()) {
    for (const SRecordedCommand& command : frame->Commands) {
      TJson arguments = TJson::parse(command.Text, nullptr, false);
      if (!arguments.is_object() || !arguments.contains("do") || !arguments["do"].is_string()) {
        THROW_ARGOSEXCEPTION("the recording \""
                             << file << "\" has a command that is none: " << command.Text);
      }
      m_commands.push_back({command.Tick, arguments["do"].get<std::string>(), arguments});
    }
  }
  LOG << "[INFO] Repeating " << m_commands.size() << " commands of viewers, recorded in \"" << file
      << '"' << std::endl;
}

void CCommandsRun::Execute() {
  while (true) {
    const bool isFinished = m_cSimulator.IsExperimentFinished();
    if (isFinished) {
      CallPostExperiment();
    }
    const bool isEnded = !DoCommands();
    if (isEnded && !isFinished) {
      CallPostExperiment();
    }
    if (isEnded || isFinished) {
      return;
    }
    m_executor.Drive();
    m_cSimulator.UpdateSpace();
    m_executor.CheckSelection();
  }
}

// Does the commands given after this tick. @return false if one of them has ended the run
bool CCommandsRun::DoCommands() {
  const UInt32 tick = m_cSpace.GetSimulationClock();
  for (; m_next < m_commands.size() && m_commands[m_next].Tick <= tick; ++m_next) {
    const SCommand& command = m_commands[m_next];
    m_cSpace.GetExtension<CRunCommands>().Add(tick, ToText(command.Arguments));
    if (command.Do == "end") {
      return false;
    }
    try {
      m_executor.Do(command.Do, command.Arguments);
    } catch (const std::exception& error) {
      // as in the recorded run
      LOG << "[INFO] " << command.Do << " was refused: " << error.what() << std::endl;
    }
  }
  return true;
}

void CCommandsRun::CallPostExperiment() {
  CLoopFunctions& loopFunctions = m_cSimulator.GetLoopFunctions();
  CallHook(m_cSpace.GetContext(), "PostExperiment()",
           [&loopFunctions] { loopFunctions.PostExperiment(); });
}

REGISTER_LIVE_ENGINE(CCommandsRun, "live_commands")

}  // namespace argos
