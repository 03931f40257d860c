#ifndef ARGOS3_PLUGINS_LOOP_FUNCTIONS_LUA_LUA_LOOP_FUNCTIONS_H
#define ARGOS3_PLUGINS_LOOP_FUNCTIONS_LUA_LUA_LOOP_FUNCTIONS_H

#include <argos3/core/simulator/loop_functions.h>

#include <memory>
#include <mutex>
#include <string>

struct lua_State;

namespace argos {

class CLuaDrawing;
class CLuaSimulation;
class CLuaState;
struct SLuaScript;

/**
 * Loop functions written in Lua, "lua". The script defines the hooks that it needs; doc/lua.md
 * describes the hooks and the table "simulation".
 */
class CLuaLoopFunctions : public CLoopFunctions {
 public:
  CLuaLoopFunctions();
  ~CLuaLoopFunctions() override;

  /**
   * Reads `<params>`: `script` and the limits of SLuaLimits; every attribute is a string in
   * simulation.params. Runs the script and its init().
   * @throws CARGoSException with file, line and traceback, as all hooks do, if the script fails.
   */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  void PreStep() override;
  void PostStep() override;
  bool IsExperimentFinished() override;
  void PostExperiment() override;
  /** Safe on any thread: one thread at a time runs the script. White without floor_color(). */
  CColor GetFloorColor(const CVector2& positionOnFloor) override;
  /** Calls draw_in_world(). */
  void DrawInWorld(CDrawing& drawing) override;
  /** Calls draw_in_overlay(). */
  void DrawInOverlay(CDrawing& drawing) override;

 private:
  void Load();
  void CallHook(const char* hook);
  template <typename BODY>
  void Run(const char* hook, const BODY& body);
  void ThrowIfNoHooks();
  void WarnOfMisspeltHooks() const;
  void Seed(const char* phase);

  TConfigurationNode m_params;
  std::shared_ptr<const SLuaScript> m_script;
  // these precede the state, which refers to them
  std::unique_ptr<CLuaSimulation> m_simulation;
  std::unique_ptr<CLuaDrawing> m_drawing;
  std::unique_ptr<CLuaState> m_state;
  std::mutex m_floorMutex;
  bool m_isRunning = false;  // a hook is running, on the main thread
  bool m_hasFailed = false;
};

}  // namespace argos

#endif
