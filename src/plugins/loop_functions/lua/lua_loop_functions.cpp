#include <argos3/plugins/simulator/loop_functions/lua/lua_loop_functions.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/datatypes/while_true.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/wrappers/lua/lua_limits.h>
#include <argos3/core/wrappers/lua/lua_metrics.h>
#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_script.h>
#include <argos3/core/wrappers/lua/lua_state.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/plugins/simulator/loop_functions/lua/lua_drawing.h>
#include <argos3/plugins/simulator/loop_functions/lua/lua_simulation.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace argos {

namespace {

// ticks draw the same numbers after init() as after reset(), like the scripts of robots
constexpr const char* kStart = "start";
constexpr const char* kSteps = "steps";

// there is one script for all robots, whose data it may collect
constexpr UInt64 kDefaultMaxMemory = 1024 * SLuaLimits::kMebi;

constexpr const char* kHooks[] = {"init",
                                  "reset",
                                  "destroy",
                                  "pre_step",
                                  "post_step",
                                  "post_experiment",
                                  "is_experiment_finished",
                                  "floor_color",
                                  "draw_in_world",
                                  "draw_in_overlay"};

/** Pushes a hook. @return false, and pushes nothing, if the script does not define it. */
bool PushHook(lua_State* state, const char* hook) {
  const int type = lua_getglobal(state, hook);
  if (type == LUA_TNIL) {
    lua_pop(state, 1);
    return false;
  }
  if (type != LUA_TFUNCTION) {
    luaL_error(state, "the global \"%s\" must be a function, got %s", hook,
               luaL_typename(state, -1));
  }
  return true;
}

/** Converts the results of a function, which are the whole stack, to a color. */
CColor ToColor(lua_State* state) {
  try {
    CLuaArguments results(state);
    const auto color = results.Next<CColor>();
    results.Finish();
    return color;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        "floor_color(x, y) must return a color: its name, \"r,g,b,a\", or three numbers from 0 to "
        "255. What it returned, taken as arguments:",
        error);
  }
}

}  // namespace

CLuaLoopFunctions::CLuaLoopFunctions() = default;

CLuaLoopFunctions::~CLuaLoopFunctions() = default;

void CLuaLoopFunctions::Init(TConfigurationNode& tree) {
  m_params = GetNode(tree, "params");
  Load();
}

void CLuaLoopFunctions::Load() {
  std::string name;
  GetNodeAttribute(m_params, "script", name);
  SLuaLimits defaults;
  defaults.MaxMemory = kDefaultMaxMemory;
  const SLuaLimits limits = SLuaLimits::Read(m_params, defaults);
  m_state.reset();
  m_script = SLuaScript::Load(name, m_params.GetFileName(), limits.IsUnsafe);
  m_simulation = std::make_unique<CLuaSimulation>(*this);
  m_drawing = std::make_unique<CLuaDrawing>();
  m_state = std::make_unique<CLuaState>(limits);
  m_hasFailed = false;
  try {
    m_state->Run([this](lua_State* state) {
      m_simulation->Register(state, m_params);
      m_drawing->Register(state);
      CLuaMetrics::Register(state);
    });
    Seed(kStart);
    const CWhileTrue running(m_isRunning);
    m_state->Execute(*m_script);
  } catch (const CLuaError& error) {
    THROW_ARGOSEXCEPTION("the Lua loop functions \"" << m_script->Path << "\" failed\n[FATAL] "
                                                     << error.GetMessage());
  }
  ThrowIfNoHooks();
  CallHook("init");
  Seed(kSteps);
  WarnOfMisspeltHooks();
  CLuaParameters::Finish(*m_state, m_params, m_script->Source);
}

void CLuaLoopFunctions::Seed(const char* phase) {
  m_state->SeedMath(m_simulation->Seed(phase));
}

void CLuaLoopFunctions::ThrowIfNoHooks() {
  bool hasOne = false;
  std::string all;
  m_state->Run([&](lua_State* state) {
    for (const char* const hook : kHooks) {
      hasOne = hasOne || PushHook(state, hook);
    }
  });
  for (const char* const hook : kHooks) {
    AppendItem(all, std::string(hook));
  }
  if (!hasOne) {
    THROW_ARGOSEXCEPTION("the Lua loop functions \""
                         << m_script->Path
                         << "\" define none of the functions that are called: " << all);
  }
}

// a function that nothing calls, whose name is similar to that of a hook that is not there
void CLuaLoopFunctions::WarnOfMisspeltHooks() const {
  m_state->Run([this](lua_State* state) {
    const std::vector<std::string> functions = CLuaState::ListFunctions(state);
    std::vector<std::string> missing;
    for (const char* const hook : kHooks) {
      if (std::find(functions.begin(), functions.end(), hook) == functions.end()) {
        missing.emplace_back(hook);
      }
    }
    for (const std::string& name : functions) {
      const bool isHook = std::find(std::begin(kHooks), std::end(kHooks), name) != std::end(kHooks);
      const std::string near = isHook ? "" : NearestNames(name, missing, 1);
      // its definition is one use
      if (!near.empty() && m_script->Source.CountUses(name) == 1) {
        LOGERR << "[WARNING] the Lua loop functions \"" << m_script->Path
               << "\": nothing calls the global function \"" << name << "\"; did you mean \""
               << near << "\"?" << std::endl;
      }
    }
  });
}

template <typename BODY>
void CLuaLoopFunctions::Run(const char* hook, const BODY& body) {
  try {
    m_state->Run(body);
  } catch (const CLuaError& error) {
    m_hasFailed = true;
    THROW_ARGOSEXCEPTION("the Lua loop functions \"" << m_script->Path << "\" failed in " << hook
                                                     << "()\n[FATAL] " << error.GetMessage());
  }
}

void CLuaLoopFunctions::CallHook(const char* hook) {
  if (m_state == nullptr || m_hasFailed) {
    return;
  }
  const CSimulator::CScope scope(GetSimulator());
  const CWhileTrue running(m_isRunning);
  Run(hook, [hook](lua_State* state) {
    if (PushHook(state, hook)) {
      lua_call(state, 0, 0);
    }
  });
}

void CLuaLoopFunctions::Reset() {
  if (m_hasFailed) {
    Load();
    return;
  }
  if (m_state != nullptr) {
    Seed(kStart);
    CallHook("reset");
    Seed(kSteps);
  }
}

void CLuaLoopFunctions::Destroy() {
  // closes the state, and with it the files that the script has open, even if destroy() fails
  struct SClose {
    std::unique_ptr<CLuaState>& State;
    ~SClose() { State.reset(); }
  } const close{m_state};
  CallHook("destroy");
}

void CLuaLoopFunctions::PreStep() {
  CallHook("pre_step");
}

void CLuaLoopFunctions::PostStep() {
  CallHook("post_step");
}

void CLuaLoopFunctions::DrawInWorld(CDrawing& drawing) {
  if (m_drawing != nullptr) {
    const CLuaDrawing::CScope scope(*m_drawing, drawing);
    CallHook("draw_in_world");
  }
}

void CLuaLoopFunctions::DrawInOverlay(CDrawing& drawing) {
  if (m_drawing != nullptr) {
    const CLuaDrawing::CScope scope(*m_drawing, drawing);
    CallHook("draw_in_overlay");
  }
}

bool CLuaLoopFunctions::IsExperimentFinished() {
  if (m_state == nullptr || m_hasFailed) {
    return false;
  }
  bool finished = false;
  const CSimulator::CScope scope(GetSimulator());
  const CWhileTrue running(m_isRunning);
  Run("is_experiment_finished", [&finished](lua_State* state) {
    if (PushHook(state, "is_experiment_finished")) {
      lua_call(state, 0, 1);
      if (!lua_isboolean(state, -1)) {
        luaL_error(state, "is_experiment_finished() must return true or false, got %s",
                   luaL_typename(state, -1));
      }
      finished = lua_toboolean(state, -1) != 0;
    }
  });
  return finished;
}

void CLuaLoopFunctions::PostExperiment() {
  CallHook("post_experiment");
}

CColor CLuaLoopFunctions::GetFloorColor(const CVector2& positionOnFloor) {
  if (m_isRunning) {
    // no hook runs while robots sense, so the call comes from a hook
    THROW_ARGOSEXCEPTION(
        "a hook of the Lua loop functions reads the color of the floor, which they define");
  }
  CColor color = CColor::WHITE;
  const std::lock_guard<std::mutex> lock(m_floorMutex);
  if (m_state == nullptr || m_hasFailed) {
    return color;
  }
  const SRunningCode& caller = SRunningCode::OfThread();
  const CRunningCodeScope running(
      {"floor_color()", nullptr, "Lua loop functions", caller.Tick, caller.IsBesideOthers});
  Run("floor_color", [&](lua_State* state) {
    if (PushHook(state, "floor_color")) {
      lua_pushnumber(state, positionOnFloor.GetX());
      lua_pushnumber(state, positionOnFloor.GetY());
      lua_call(state, 2, LUA_MULTRET);
      color = ToColor(state);
    }
  });
  return color;
}

REGISTER_SYMBOL(
    CLoopFunctions, CLuaLoopFunctions, "lua", "the authors of this project", "1.0",
    "Loop functions written in Lua.",
    R"(The script defines those of these global functions that it needs; they are called without
arguments, on the main thread, in one Lua 5.4 state:

  init()                    when the arena is filled
  reset()                   when the experiment starts over
  pre_step(), post_step()   in each tick: before the robots sense, and at its end
  is_experiment_finished()  before each tick: true ends the experiment
  post_experiment()         after the last tick
  destroy()                 at the end of everything
  floor_color(x, y)         the color of the floor at a place, m, if <floor source="loop_functions"/>:
                            a name, "r,g,b,a", or three numbers from 0 to 255
  draw_in_world(), draw_in_overlay()
                            for each picture of a view; the table "draw" adds shapes to it

The table "simulation" reads the clock, finds, moves, adds and removes entities, sets colors and
lights, and ends the experiment; doc/lua.md describes it. An error in the script ends the run.

REQUIRED XML

  <loop_functions label="lua">
    <params script="foraging.lua" />
  </loop_functions>

  script  file. A relative path starts at the working directory or, if there is no such file, at the
          folder of the experiment file.

OPTIONAL XML

  <params script="foraging.lua" max_instructions="0" max_memory="2048" unsafe="false" items="20" />

  max_instructions  whole number, default 100000000: how many instructions of Lua's virtual machine the
                    script may execute in one call before it is interrupted with an error. 0: no
                    limit, which makes scripts faster.
  max_memory        whole number from 0 to 1048576, MiB, default 1024: how much memory the script may use
                    before it is interrupted with an error. 0: no limit.
  unsafe            true or false, the default: whether the script may load libraries and bytecode, use all
                    of Lua's library "debug", and define finalizers (__gc). Wrong use of these crashes
                    the program.
  any other         a string in simulation.params: simulation.params.items is "20".
)",
    "Usable")

}  // namespace argos
