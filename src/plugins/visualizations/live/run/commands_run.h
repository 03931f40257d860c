#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_COMMANDS_RUN_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_COMMANDS_RUN_H

#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/plugins/simulator/visualizations/live/live_engine.h>
#include <argos3/plugins/simulator/visualizations/live/run/command_executor.h>

#include <string>
#include <vector>

namespace argos {

/** Repeats a run with the commands of its viewers, which its recording has. */
class CCommandsRun : public CLiveEngine {
 public:
  CCommandsRun() : m_executor(m_cSimulator, m_drawing) {}

  /** Reads the recording. @throws CARGoSException */
  void Init(TConfigurationNode& tree) override;
  void Destroy() override { m_drawing.Destroy(); }
  void Execute() override;

 private:
  struct SCommand {
    UInt32 Tick;
    std::string Do;
    TJson Arguments;
  };

  void ReadCommands(const std::string& file);
  bool DoCommands();
  void CallPostExperiment();

  CViewDrawing m_drawing;  // for users' functions that the commands call
  CCommandExecutor m_executor;
  std::vector<SCommand> m_commands;
  size_t m_next = 0;
};

}  // namespace argos

#endif
