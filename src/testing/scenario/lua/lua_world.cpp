#include "lua_world.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/testing/support/captured_logs.h>

#include <sstream>
#include <stdexcept>

namespace argos {

std::string ToXml(const SLuaExperiment& lua, const CTemporaryFolder& folder) {
  SExperiment experiment;
  experiment.Seed = lua.Seed;
  experiment.Threads = lua.Threads;
  experiment.Controllers = "<lua_controller id='c'><actuators>" + lua.Actuators +
                           "</actuators><sensors>" + lua.Sensors + "</sensors><params script='" +
                           folder.Write("robot.lua", lua.Script) + "' " + lua.Params +
                           "/></lua_controller>" + lua.Controllers;
  if (!lua.LoopScript.empty()) {
    experiment.LoopFunctions = "<loop_functions label='lua'><params script='" +
                               folder.Write("loop.lua", lua.LoopScript) + "' " + lua.LoopParams +
                               "/></loop_functions>";
  }
  experiment.Engines = lua.Engines;
  experiment.Media = lua.Media;
  experiment.Arena = lua.Robots + lua.Arena;
  return experiment.ToXml();
}

SLuaExperiment WithLoopFunctions(const std::string& loopScript, const std::string& arena) {
  SLuaExperiment experiment;
  experiment.LoopScript = loopScript;
  experiment.Arena = arena;
  return experiment;
}

std::string TakeScriptLog() {
  std::istringstream lines(TakeLog());
  std::string rest;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("[INFO]", 0) != 0) {
      rest += line + ' ';
    }
  }
  return rest;
}

CLuaWorld::CLuaWorld(const SLuaExperiment& experiment) {
  m_world.emplace(ToXml(experiment, m_folder));
}

CLuaController& CLuaWorld::GetController(const std::string& robot) {
  auto& entity = m_world->Get<CComposableEntity>(robot);
  return dynamic_cast<CLuaController&>(
      entity.GetComponent<CControllableEntity>("controller").GetController());
}

const SAnchor& CLuaWorld::GetAnchor(const std::string& id) {
  auto& entity = m_world->Get<CComposableEntity>(id);
  return entity.GetComponent<CEmbodiedEntity>("body").GetOriginAnchor();
}

std::string CLuaWorld::Get(const std::string& expression, const std::string& robot) {
  lua_State* const state = GetController(robot).GetLuaState();
  if (luaL_dostring(state, ("return tostring(" + expression + ")").c_str()) != LUA_OK) {
    throw std::runtime_error(lua_tostring(state, -1));
  }
  const std::string value = lua_tostring(state, -1);
  lua_settop(state, 0);
  return value;
}

void CLuaWorld::Do(const std::string& code, const std::string& robot) {
  lua_State* const state = GetController(robot).GetLuaState();
  if (luaL_dostring(state, code.c_str()) != LUA_OK) {
    throw std::runtime_error(lua_tostring(state, -1));
  }
}

std::string LoadError(const SLuaExperiment& experiment) {
  try {
    CLuaWorld world(experiment);
  } catch (const CARGoSException& error) {
    return error.what();
  }
  return "";
}

}  // namespace argos
