#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_COMMAND_EXECUTOR_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_COMMAND_EXECUTOR_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>
#include <argos3/plugins/simulator/visualizations/live/run/parameter_editor.h>
#include <argos3/plugins/simulator/visualizations/live/run/script_editor.h>

#include <sys/types.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace argos {

class CCI_DifferentialSteeringActuator;
class CEmbodiedEntity;
class CEntity;
class CSimulator;
class CQuaternion;
class CVector3;
class CViewDrawing;

/**
 * Does what viewers' commands change in a simulation: move, add, remove, other scripts and
 * parameters. Between ticks, on the main thread; the same commands at the same ticks give the same
 * run.
 */
class CCommandExecutor {
 public:
  /** @param drawing  users' functions that are told what viewers do. */
  CCommandExecutor(CSimulator& simulator, const CViewDrawing& drawing)
      : m_simulator(simulator), m_drawing(drawing), m_scripts(simulator), m_parameters(simulator) {}

  static bool Knows(const std::string& command);
  /**
   * @param arguments  of the viewer: anything.
   * @return what to answer besides "ok"; an object. If it has an "error", nothing was changed.
   * @throws CARGoSException with the reason if it is refused, or users' code fails.
   */
  TJson Do(const std::string& command, const TJson& arguments);

  /** To be called before each tick: robots that viewers drive go on as they were told. */
  void Drive();
  /**
   * Commands that let go what a viewer holds that is no longer in control: keys of users'
   * functions that it has not released, what it has selected, and robots that it drives.
   */
  std::vector<TJson> ListReleases();
  /** The run begins again: no robot is driven. */
  void ForgetDrivers();
  /** To be called after each tick and reset: forgets what is selected if it was removed. */
  void CheckSelection();

  /** Commands that make the run after a reset from one of the experiment file. */
  struct SRestart {
    std::vector<TJson> Done; /**< removals, which a reset does not undo */
    std::vector<TJson> ToDo; /**< scripts and parameters */
  };

  /**
   * To be called before a reset: scripts and parameters are again those of the start, and what
   * viewers have added is removed.
   */
  SRestart Restore();

  // What viewers ask, which changes nothing.

  /** See CScriptEditor::Open(). */
  TJson OpenScript(const TJson& arguments);
  /** See CParameterEditor::List(). */
  TJson ListParameters(const TJson& arguments);

  /** Types of entities that "add" can add, each once. */
  std::vector<std::string> ListTypesToAdd();

 private:
  using TAction = TJson (CCommandExecutor::*)(const TJson& arguments);

  static TAction FindAction(const std::string& command);
  CEntity& GetRoot(const TJson& arguments);
  CEntity* FindRoot(const TJson& arguments);
  TJson ApplyScript(const TJson& arguments);
  TJson SetParameter(const TJson& arguments);
  void Keep(const TJson& command, const std::string& key);
  TJson Move(const TJson& arguments);
  void MoveRoot(CEntity& root, const TJson& arguments) const;
  TJson Select(const TJson& arguments);
  TJson PressKey(const TJson& arguments);
  TJson SetDrive(const TJson& arguments);
  CCI_DifferentialSteeringActuator* FindWheels(const std::string& id);
  void LetGo(const std::string& id);
  TJson Add(const TJson& arguments);
  TJson Remove(const TJson& arguments);
  void CheckPlace(const CVector3& position) const;
  std::string DescribeObstacle(const CEmbodiedEntity& body, const CVector3& position,
                               const CQuaternion& orientation) const;
  TConfigurationNode* FindTemplate(const std::string& type);
  TConfigurationNode MakeElement(const std::string& type, const TJson& arguments);
  std::string MakeId(const std::string& type) const;

  CSimulator& m_simulator;
  const CViewDrawing& m_drawing;
  CScriptEditor m_scripts;
  CParameterEditor m_parameters;
  std::vector<std::pair<std::string, TJson>>
      m_kept;  // commands for Restore(), by what they change; a later one replaces an earlier one
  std::set<std::string> m_added;  // ids of entities
  std::vector<TJson> m_removals;  // commands that remove other entities
  std::map<std::string, std::pair<Real, Real>>
      m_driven;  // id: speeds of left and right wheel, cm/s
  std::set<std::string> m_pressed;  // keys
  std::string m_selected;  // id of a root entity; empty: none
  ssize_t m_selectedIndex = -1;  // of that entity
};

}  // namespace argos

#endif
