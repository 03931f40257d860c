#include <argos3/core/wrappers/lua/lua_controller.h>

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/wrappers/lua/lua_arguments.h>
#include <argos3/core/wrappers/lua/lua_metrics.h>
#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_registry.h>
#include <argos3/core/wrappers/lua/lua_script.h>
#include <argos3/core/wrappers/lua/lua_state.h>
#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/core/wrappers/lua/lua_value.h>

#include <utility>

namespace argos {

namespace {

constexpr const char* kCategory = "argos";

// the start of a script draws from a stream of its own: so the steps draw the same numbers after
// init() as after reset(), although these may draw different amounts
constexpr const char* kStart = "start";
constexpr const char* kSteps = "steps";

}  // namespace

CLuaController::CLuaController() = default;

CLuaController::~CLuaController() = default;

void CLuaController::Init(TConfigurationNode& params) {
  m_params = params;
  GetNodeAttributeOrDefault(params, "script", m_scriptName, std::string());
  m_limits = SLuaLimits::Read(params, {});
  GetNodeAttributeOrDefault(params, "reuse_readings", m_reusesReadings, m_reusesReadings);
  m_onError = ReadOnError(params);
  Load();
}

void CLuaController::SetLuaScript(const std::string& script) {
  m_scriptName = script;
  m_isReplaced = false;
  Load();
}

void CLuaController::Load() {
  m_error.clear();
  m_state.reset();
  if (m_scriptName.empty()) {
    LOGERR << "[WARNING] " << m_params.GetLocation() << ": <params>: no \"script\": robot \""
           << GetId() << "\" does nothing" << std::endl;
    return;
  }
  try {
    Run(m_isReplaced ? m_script
                     : SLuaScript::Load(m_scriptName, m_params.GetFileName(), m_limits.IsUnsafe));
  } catch (const CLuaError&) {
    throw CARGoSException(m_error);
  } catch (const std::exception& error) {
    m_error = "robot \"" + GetId() + "\": its Lua script cannot be run\n" + error.what();
    throw CARGoSException(m_error);
  }
}

// @throws CLuaError after m_error was set
void CLuaController::Run(std::shared_ptr<const SLuaScript> script) {
  m_script = std::move(script);
  const char* running = "its top level";
  try {
    m_state = std::make_unique<CLuaState>(m_limits);
    m_state->KeepOrder(true);
    m_state->Run([this](lua_State* state) {
      if (m_reusesReadings) {
        CLuaTable::ReuseReadings(state);
      }
      if (m_params.IsLenient()) {
        CLuaArguments::AcceptFractions(state, "robot \"" + GetId() + "\"");
      }
      FillRobotTable(state);
      CLuaMetrics::Register(state);
    });
    m_state->KeepOrder(false);
    Seed(kStart);
    m_state->Execute(*m_script);
    running = "init()";
    m_state->Run([](lua_State* state) { CLuaState::CallOptional(state, "init"); });
    Seed(kSteps);
    CLuaParameters::Finish(*m_state, m_params, m_script->Source);
  } catch (const CLuaError& error) {
    m_error = DescribeFailure(running, error.GetMessage());
    throw;
  }
}

void CLuaController::Restart(std::shared_ptr<const SLuaScript> script) {
  std::shared_ptr<const SLuaScript> oldScript = m_script;
  std::unique_ptr<CLuaState> oldState = std::move(m_state);
  // in place of m_random, to which functions of the old state refer
  CLuaRandom oldRandom = m_random ? std::move(*m_random) : CLuaRandom(0);
  const std::string oldError = std::exchange(m_error, std::string());
  try {
    Run(std::move(script));
    m_isReplaced = true;
  } catch (const std::exception& error) {
    const std::string message = m_error.empty() ? error.what() : m_error;
    m_state = std::move(oldState);
    m_script = std::move(oldScript);
    m_random.emplace(std::move(oldRandom));
    m_error = oldError;
    throw CARGoSException(message);
  }
}

void CLuaController::FillRobotTable(lua_State* state) {
  lua_newtable(state);
  lua_pushvalue(state, -1);
  lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaRobotKey);
  CLuaUtility::AddToTable(state, "id", GetId());
  AddParameters(state);
  AddRandom(state);
  AddDevices(state);
  lua_setglobal(state, "robot");
}

void CLuaController::AddParameters(lua_State* state) const {
  CLuaParameters::Add(state, m_params);
  // SetLuaScript() may have replaced it
  lua_getfield(state, -1, "params");
  lua_pushlstring(state, m_scriptName.data(), m_scriptName.size());
  lua_setfield(state, -2, "script");
  lua_pop(state, 1);
}

void CLuaController::AddRandom(lua_State* state) {
  m_random.emplace(0);
  CLuaUtility::StartTable(state, "random");
  m_random->Register(state);
  CLuaUtility::EndTable(state);
}

void CLuaController::AddDevices(lua_State* state) {
  const auto add = [state](const char* kind, const std::string& label, auto& device) {
    const SLuaDevice current{kind, label};
    lua_pushlightuserdata(state, const_cast<SLuaDevice*>(&current));
    lua_rawsetp(state, LUA_REGISTRYINDEX, &kLuaDeviceKey);
    const int top = lua_gettop(state);
    device.CreateLuaState(state);
    lua_settop(state, top);
  };
  for (const auto& [label, actuator] : m_mapActuators) {
    add("actuator", label, *actuator);
  }
  m_sensors.clear();
  for (const auto& [label, sensor] : m_mapSensors) {
    add("sensor", label, *sensor);
    m_sensors.push_back(sensor);
  }
  // all devices are set up: the owners of the tables are not needed any more
  for (const char* const key : {&kLuaDeviceKey, &kLuaClaimsKey}) {
    lua_pushnil(state);
    lua_rawsetp(state, LUA_REGISTRYINDEX, key);
  }
}

void CLuaController::Seed(const char* phase) {
  // a robot without a simulator may have no category
  const UInt32 seed = CRandom::ExistsCategory(kCategory) ? CRandom::GetSeedOf(kCategory) : 0;
  CRandomStream seeds(seed, kCategory, GetId(), std::string("Lua ") + phase);
  m_random->Seed(static_cast<UInt32>(seeds.Next()));
  m_state->SeedMath(seeds.Next());
}

void CLuaController::ReadSensors(lua_State* state, bool isAfterReset) const {
  lua_rawgetp(state, LUA_REGISTRYINDEX, &kLuaRobotKey);
  const int robot = lua_gettop(state);
  for (CCI_Sensor* const sensor : m_sensors) {
    // a reset changes the readings of all sensors
    if (isAfterReset || sensor->IsSwitchedOn()) {
      sensor->ReadingsToLuaState(state);
      lua_settop(state, robot);
    }
  }
  lua_settop(state, robot - 1);
}

void CLuaController::ControlStep() {
  if (m_state == nullptr || !IsOK()) {
    return;
  }
  m_state->LoadAhead();
  try {
    m_state->Run([this](lua_State* state) {
      ReadSensors(state, false);
      CLuaState::CallGlobal(state, "step");
    });
  } catch (const CLuaError& error) {
    Fail("step()", error.GetMessage());
  }
}

void CLuaController::Reset() {
  if (!IsOK()) {
    Load();
    return;
  }
  if (m_state == nullptr) {
    return;
  }
  Seed(kStart);
  try {
    m_state->Run([this](lua_State* state) {
      ReadSensors(state, true);
      CLuaState::CallOptional(state, "reset");
    });
    Seed(kSteps);
  } catch (const CLuaError& error) {
    Fail("reset()", error.GetMessage());
  }
}

void CLuaController::Destroy() {
  const std::unique_ptr<CLuaState> state = std::move(m_state);
  if (state == nullptr || !IsOK()) {
    return;
  }
  try {
    state->Run([](lua_State* stack) { CLuaState::CallOptional(stack, "destroy"); });
  } catch (const CLuaError& error) {
    Fail("destroy()", error.GetMessage());
  }
}

EOnError CLuaController::ChooseOnError(std::optional<EOnError> configured) const {
  return m_onError ? *m_onError : configured.value_or(EOnError::StopRobot);
}

std::vector<std::string> CLuaController::FindMissingFunctions() const {
  std::vector<std::string> messages;
  if (m_state == nullptr || !IsOK()) {
    return messages;
  }
  m_state->Run([this, &messages](lua_State* state) {
    for (const char* const name : {"step", "reset", "destroy"}) {
      const std::string fault = CLuaState::FindFaultOfFunction(state, name);
      // the others may be left out, but not be misspelt
      const bool isNeeded =
          name == std::string("step") || fault.find("did you mean") != std::string::npos;
      if (!fault.empty() && isNeeded) {
        messages.push_back("the Lua script \"" + m_script->Path + "\": " + fault);
      }
    }
  });
  return messages;
}

lua_State* CLuaController::GetLuaState() const {
  return m_state != nullptr ? m_state->Get() : nullptr;
}

void CLuaController::Fail(const char* function, const std::string& message) {
  m_error = DescribeFailure(function, message);
  throw CARGoSException(m_error);
}

std::string CLuaController::DescribeFailure(const char* function,
                                            const std::string& message) const {
  return "robot \"" + GetId() + "\": the Lua script \"" + m_script->Path + "\" failed in " +
         function + "\n[FATAL] " + message;
}

#ifdef ARGOS_DYNAMIC_LIBRARY_LOADING
REGISTER_SYMBOL(
    CCI_Controller, CLuaController, "lua_controller", "the authors of this project", "1.0",
    "A controller written in Lua.",
    R"(Each robot runs the functions init(), step(), reset() and destroy() of a script in a Lua 5.4
state of its own. What scripts see is described in doc/lua.md.

REQUIRED XML

  <controllers>
    <lua_controller id="c1">
      <actuators>
        <differential_steering implementation="default" />
      </actuators>
      <sensors />
      <params script="wander.lua" />
    </lua_controller>
  </controllers>

  script  file. A relative path starts at the working directory or, if there is no such file, at the
          folder of the experiment file. Left out: the robot does nothing, and a warning says so.

OPTIONAL XML

  <params script="wander.lua" on_error="end_run" max_instructions="1000000" max_memory="16"
          unsafe="true" reuse_readings="true" speed="12" />

  on_error          "stop_robot" (the default): a script that fails in step() or reset() is not called any
                    more, the robot keeps its last commands, and the run goes on. "end_run": the run
                    ends with an error. "quarantine": as stop_robot, and the robot leaves physics and
                    media. Before the attribute of the same name of <lua_controller> and <experiment>.
  max_instructions  whole number, default 100000000: how many instructions of Lua's virtual machine the
                    script may execute in one call before it is interrupted with an error. 0: no
                    limit, which makes scripts faster.
  max_memory        whole number from 0 to 1048576, MiB, default 64: how much memory the script may use
                    before it is interrupted with an error. 0: no limit.
  unsafe            true or false, the default: whether the script may load libraries and bytecode, use all
                    of Lua's library "debug", and define finalizers (__gc). Wrong use of these crashes
                    the program.
  reuse_readings    true or false, the default: whether the entries of lists such as messages and blobs are the
                    same tables in each tick, which saves time; otherwise a script may keep them.
  any other         a string in robot.params: robot.params.speed is "12".
)",
    "Usable")
#endif

}  // namespace argos
