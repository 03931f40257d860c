#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_LIVE_RUN_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_LIVE_RUN_H

#include <argos3/plugins/simulator/visualizations/live/link/live_link.h>
#include <argos3/plugins/simulator/visualizations/live/live_engine.h>
#include <argos3/plugins/simulator/visualizations/live/run/command_executor.h>
#include <argos3/plugins/simulator/visualizations/live/run/live_log.h>
#include <argos3/plugins/simulator/visualizations/live/run/run_pace.h>
#include <argos3/plugins/simulator/visualizations/live/run/state_capture.h>
#include <argos3/plugins/simulator/visualizations/live/server/live_server.h>
#include <argos3/support/live_runs.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace argos {

/**
 * Runs an experiment as its viewers want, `<live>`: plays, pauses and steps, applies their commands
 * between ticks, and gives the server what they see.
 */
class CLiveRun : public CLiveEngine {
 public:
  CLiveRun();
  ~CLiveRun() override;

  /** Reads the attributes that the plug-in's description lists, and listens. */
  void Init(TConfigurationNode& tree) override;
  void Destroy() override;
  void Execute() override;

 private:
  using TClock = std::chrono::steady_clock;
  using TAction = TJson (CLiveRun::*)(const TJson& arguments);

  void ReadAttributes(TConfigurationNode& tree, SLiveServerSettings& settings);
  void Announce();
  TJson MakeWelcome();
  void Loop();
  bool MayTick() const { return !m_isFinished && (m_isPlaying || m_stepsLeft > 0); }
  void Tick();
  void CheckEnd();
  void WaitForUser();
  bool HasLingered(TClock::time_point now);
  void Serve(TClock::time_point now);
  void HandOverLog(bool isOutside);
  void CaptureState();
  void SendValues();
  void SendPerceptions();
  void SendStatus();
  void CallPostExperiment();

  void DoCommands();
  void DoServerCommand(const SLiveCommand& command);
  void DoCommand(const SLiveCommand& command);
  static TAction FindAction(const std::string& command);
  void RecordCommand(TJson command);
  TJson DoChange(const SLiveCommand& command);
  TJson Play(const TJson& arguments);
  TJson Pause(const TJson& arguments);
  TJson Step(const TJson& arguments);
  TJson SetSpeed(const TJson& arguments);
  TJson ResetRun(const TJson& arguments);
  TJson RedistributeRun(const TJson& arguments);
  TJson SeekTick(const TJson& arguments);
  TJson EndRun(const TJson& arguments);
  void GoOnAlone();
  void CheckEditing() const;
  TJson OpenScript(const TJson& arguments);
  TJson ListParameters(const TJson& arguments);
  void BeginAgain(const CCommandExecutor::SRestart& restart);

  CLiveLink m_link;
  CRunPace m_pace;
  CStateCapture m_capture;
  CCommandExecutor m_executor;
  std::unique_ptr<CLiveLog> m_log;  // null: not running
  std::unique_ptr<CLiveServer> m_server;  // null: only checked
  std::unique_ptr<CLiveRunFile> m_urlFile;  // null: none is wanted, or not running

  bool m_isPlaying = false;
  UInt32 m_stepsLeft = 0;
  bool m_isFinished = false;  // the experiment
  bool m_isEnding = false;  // a viewer wants it
  bool m_isPostExperimentDone = false;
  bool m_hasChanged = true;  // since the last state was captured
  bool m_haveValuesChanged = true;  // since they were sent
  bool m_wasTicking = false;  // as of the last status
  bool m_opensPage = true;
  bool m_hasControl = true;  // see SLiveServerSettings
  bool m_goesOn = false;  // when the last viewer has left; viewers do not delay its end
  bool m_mayEdit = false;  // viewers, the scripts of robots
  std::string m_urlFileName;  // empty: none; "auto": any
  Real m_speed = 1.0;  // at first
  Real m_linger = 30.0;  // s
  TClock::time_point m_lastViewer;  // when there was one
  std::vector<std::string> m_pinned;  // ids of entities whose values viewers want
  TClock::time_point m_valuesDue;
  TClock::time_point m_statusDue;
  std::vector<SLiveCommand> m_commands;  // reused
};

}  // namespace argos

#endif
