#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_SCRIPT_EDITOR_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_SCRIPT_EDITOR_H

#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace argos {

class CControllableEntity;
class CEntity;
class CLuaController;
class CSimulator;
struct SLuaScript;

/**
 * Scripts of Lua controllers that viewers read and replace. A replaced script is in memory only,
 * and runs in all robots whose controllers name the same file. Between ticks, on the main thread.
 */
class CScriptEditor {
 public:
  explicit CScriptEditor(CSimulator& simulator) : m_simulator(simulator) {}

  /**
   * The script of a robot.
   * @return its "text", the "file" as messages name it, the number of "robots" that run it, and
   * whether it is "changed".
   * @throws CARGoSException if the robot has none, or one that cannot be edited.
   */
  TJson Open(CEntity& root) const;
  /**
   * Restarts the controllers of all robots with the script of this one. If the script does not
   * start in the first of them, nothing changes; another robot in which it fails keeps its former
   * script, which is logged.
   * @return the "file", the number of "robots", the id of the "first", and the number of those in
   * which it "failed"; or the "error", and its "line" if it has one.
   * @throws CARGoSException as Open(), or if the text is too long.
   */
  TJson Apply(CEntity& root, const std::string& text);
  /** Gives a robot that was added the script that others with the same file run now. */
  void ApplyToAdded(CEntity& root);

  /** The scripts of the files run again, for a reset. */
  void Restore();

 private:
  struct SRobot {
    CControllableEntity* Entity;
    CLuaController* Controller;
  };
  struct SChange {
    std::shared_ptr<const SLuaScript> Original;
    std::shared_ptr<const SLuaScript> Current;
    std::string Text;
  };

  SRobot GetRobot(CEntity& root) const;
  std::vector<SRobot> FindRobots(const std::string& file) const;
  static void Restart(const SRobot& robot, const std::shared_ptr<const SLuaScript>& script);
  static TJson RestartAll(const std::vector<SRobot>& robots,
                          const std::shared_ptr<const SLuaScript>& script);

  CSimulator& m_simulator;
  std::map<std::string, SChange> m_changes;  // by the file, as messages name it
};

}  // namespace argos

#endif
