#ifndef ARGOS3_PLUGINS_LOOP_FUNCTIONS_LUA_LUA_SIMULATION_H
#define ARGOS3_PLUGINS_LOOP_FUNCTIONS_LUA_LUA_SIMULATION_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/wrappers/lua/lua_arguments.h>
#include <argos3/core/wrappers/lua/lua_random.h>
#include <argos3/core/wrappers/lua/lua_value.h>

#include <string>

struct lua_State;

namespace argos {

class CEntity;
class CLoopFunctions;
class CSimulator;

/**
 * The functions of the table "simulation", with which Lua loop functions read and change the
 * experiment; doc/lua.md describes them. Wrong arguments throw, and so become Lua errors.
 *
 * For the main thread, between the phases of a tick.
 */
class CLuaSimulation {
 public:
  explicit CLuaSimulation(CLoopFunctions& loopFunctions);
  ~CLuaSimulation();

  /** Creates the global table. @param params  the <params> of the loop functions. */
  void Register(lua_State* state, const TConfigurationNode& params);
  /**
   * Starts simulation.random with the experiment's seed.
   * @param phase  each has a stream of its own.
   * @return a seed for math.random.
   */
  UInt64 Seed(const char* phase);

  SLuaInteger GetClock();
  Real GetTime();
  SLuaInteger GetSeed();
  SLuaResults GetIds(CLuaArguments& arguments);
  SLuaResults GetEntities(CLuaArguments& arguments);
  SLuaResults GetEntity(CLuaArguments& arguments);
  SLuaResults GetPosition(CLuaArguments& arguments);
  Real GetYaw(const std::string& id);
  bool Move(CLuaArguments& arguments);
  bool IsFree(CLuaArguments& arguments);
  SLuaResults Add(CLuaArguments& arguments);
  void Remove(const std::string& id);
  void Disable(const std::string& id);
  void Enable(const std::string& id);
  bool IsEnabled(const std::string& id);
  Real GetBattery(const std::string& id);
  void SetBattery(const std::string& id, Real charge);
  void SetLEDColor(CLuaArguments& arguments);
  void SetAllLEDColors(const std::string& id, const CColor& color);
  void SetLightColor(const std::string& id, const CColor& color);
  void SetLightIntensity(const std::string& id, Real intensity);
  Real GetLightIntensity(const std::string& id);
  SLuaResults GetVariable(CLuaArguments& arguments);
  void SetVariable(CLuaArguments& arguments);
  Real GetPheromone(CLuaArguments& arguments);
  Real GetTotalPheromone(const std::string& medium, const std::string& layer);
  void LayPheromone(CLuaArguments& arguments);
  void SetMetric(CLuaArguments& arguments);
  void FloorChanged();
  void Finish();

 private:
  void AddFunctions(lua_State* state);
  void AddConstants(lua_State* state) const;
  CEntity& GetRoot(const std::string& id);
  bool MoveOrCheck(CLuaArguments& arguments, bool checkOnly);

  CLoopFunctions& m_loopFunctions;
  CSimulator& m_simulator;
  CLuaRandom m_random;
};

}  // namespace argos

#endif
