#ifndef ARGOS3_TESTING_SCENARIO_LUA_LUA_WORLD_H
#define ARGOS3_TESTING_SCENARIO_LUA_LUA_WORLD_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/wrappers/lua/lua_controller.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/temporary_folder.h>

#include <memory>
#include <optional>
#include <string>

namespace argos {

/** A script that does nothing. */
inline const std::string kIdleScript =
    "function init() end function step() end function reset() end function destroy() end\n";

/** An experiment with one foot-bot, "fb", at the origin, that runs a script. */
struct SLuaExperiment {
  std::string Script = kIdleScript; /**< text of robot.lua */
  std::string LoopScript = ""; /**< text of loop.lua; if empty there are no loop functions */
  std::string Params = ""; /**< more attributes of the robot's <params> */
  std::string LoopParams = ""; /**< more attributes of the loop functions' <params> */
  std::string Actuators = "<differential_steering implementation='default'/>";
  std::string Sensors = "";
  /** children of <controllers> in addition to the one of the script */
  std::string Controllers = "";
  std::string Robots =
      "<foot-bot id='fb'><body position='0,0,0'/><controller config='c'/></foot-bot>";
  std::string Media = "<led id='leds'/>";
  std::string Arena = ""; /**< children of <arena> in addition to the robots */
  std::string Engines = "<dynamics2d id='dyn2d'/>";
  UInt32 Seed = 1;
  UInt32 Threads = 0;
};

/** One with a robot that does nothing, and loop functions. @param loopScript text of loop.lua. */
SLuaExperiment WithLoopFunctions(const std::string& loopScript, const std::string& arena = "");

/** Runs such an experiment. */
class CLuaWorld {
 public:
  /** @throws CARGoSException on any loading error. */
  explicit CLuaWorld(const SLuaExperiment& experiment);

  CTestWorld& World() { return *m_world; }
  const CTemporaryFolder& Folder() const { return m_folder; }
  void Step(UInt32 ticks = 1) { m_world->Step(ticks); }
  CSimulator& GetSimulator() { return m_world->GetSimulator(); }
  CLuaController& GetController(const std::string& robot = "fb");
  const SAnchor& GetAnchor(const std::string& id = "fb");
  /** Result of tostring() for an expression in the robot's script. */
  std::string Get(const std::string& expression, const std::string& robot = "fb");
  /** Runs statements in the robot's script. */
  void Do(const std::string& code, const std::string& robot = "fb");
  /** Destroys the experiment, so that destroy() runs. */
  void Destroy() { GetSimulator().Destroy(); }

 private:
  CTemporaryFolder m_folder;
  std::optional<CTestWorld> m_world;
};

/** The XML of such an experiment, with scripts in a folder. */
std::string ToXml(const SLuaExperiment& experiment, const CTemporaryFolder& folder);

/** Log output of scripts since the last call, without messages of the program; a space ends each
 * line. */
std::string TakeScriptLog();

/** The error on loading; empty if it loads. */
std::string LoadError(const SLuaExperiment& experiment);

}  // namespace argos

#endif
