#include <argos3/plugins/simulator/loop_functions/lua/lua_simulation.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/wrappers/lua/lua_closure.h>
#include <argos3/core/wrappers/lua/lua_controller.h>
#include <argos3/core/wrappers/lua/lua_parameters.h>
#include <argos3/core/wrappers/lua/lua_utility.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/media/pheromone_medium.h>

#include <cmath>
#include <vector>

namespace argos {

namespace {

constexpr const char* kPath = "simulation.";

struct SPose {
  CVector3 Position;
  CQuaternion Orientation;
};

template <auto METHOD>
void AddMethod(lua_State* state, const char* name, CLuaSimulation& simulation) {
  CLuaClosure::PushMethod<METHOD>(state, kPath + std::string(name), simulation);
  lua_setfield(state, -2, name);
}

// problem: "has no LEDs"
[[noreturn]] void ThrowUnfit(const CEntity& entity, const char* problem) {
  THROW_ARGOSEXCEPTION("\"" << entity.GetId() << "\" (<" << entity.GetTypeDescription() << ">) "
                            << problem);
}

/** A component of a root entity; null if it has none of that type. */
template <typename COMPONENT>
COMPONENT* FindComponent(CEntity& entity, const char* type) {
  auto* const composable = dynamic_cast<CComposableEntity*>(&entity);
  if (composable == nullptr || !composable->HasComponent(type)) {
    return nullptr;
  }
  return dynamic_cast<COMPONENT*>(&composable->GetComponent(type));
}

/** @return false if the entity has no position, such as a floor. */
bool TryGetPose(CEntity& entity, SPose& pose) {
  if (const auto* const body = FindComponent<CEmbodiedEntity>(entity, "body")) {
    pose = {body->GetOriginAnchor().Position, body->GetOriginAnchor().Orientation};
    return true;
  }
  if (const auto* const positional = dynamic_cast<CPositionalEntity*>(&entity)) {
    pose = {positional->GetPosition(), positional->GetOrientation()};
    return true;
  }
  return false;
}

SPose GetPose(CEntity& entity) {
  SPose pose;
  if (!TryGetPose(entity, pose)) {
    ThrowUnfit(entity, "has no position");
  }
  return pose;
}

bool IsFinite(const SPose& pose) {
  const CVector3& p = pose.Position;
  const CQuaternion& q = pose.Orientation;
  return std::isfinite(p.GetX() + p.GetY() + p.GetZ() + q.GetW() + q.GetX() + q.GetY() + q.GetZ());
}

/** Reads x, y, z [, yaw] or a vector3 [, quaternion]; the orientation defaults to that of now. */
SPose NextPose(CLuaArguments& arguments, const SPose& now) {
  SPose pose = now;
  if (arguments.IsNextNumber()) {
    const Real x = arguments.Next<Real>();
    const Real y = arguments.Next<Real>();
    pose.Position.Set(x, y, arguments.Next<Real>());
    if (arguments.HasNext()) {
      pose.Orientation = CQuaternion(arguments.Next<CRadians>(), CVector3::Z);
    }
  } else {
    pose.Position = arguments.Next<CVector3>();
    if (arguments.HasNext()) {
      pose.Orientation = arguments.Next<CQuaternion>();
    }
  }
  arguments.Finish();
  if (!IsFinite(pose)) {
    THROW_ARGOSEXCEPTION("positions and angles must be finite numbers");
  }
  return pose;
}

void PushEntity(lua_State* state, CEntity& entity) {
  lua_createtable(state, 0, 4);
  CLuaUtility::AddToTable(state, "id", entity.GetId());
  CLuaUtility::AddToTable(state, "type", entity.GetTypeDescription());
  SPose pose;
  if (TryGetPose(entity, pose)) {
    CLuaUtility::AddToTable(state, "position", pose.Position);
    CLuaUtility::AddToTable(state, "orientation", pose.Orientation);
  }
}

/** Pushes a list with the value that push() pushes for each root entity, or for those of the type
 * that an argument names. */
template <typename PUSH>
SLuaResults PushList(CSpace& space, CLuaArguments& arguments, PUSH push) {
  const bool all = arguments.IsNextNil();
  std::string type;
  if (all) {
    arguments.Skip();
  } else {
    type = arguments.Next<std::string>();
  }
  lua_State* const state = arguments.GetState();
  lua_newtable(state);
  lua_Integer count = 0;
  for (CEntity* const entity : space.GetRootEntityVector()) {
    if (all || entity->GetTypeDescription() == type) {
      push(state, *entity);
      lua_rawseti(state, -2, ++count);
    }
  }
  if (count == 0 && !all && !space.HasEntityType(type)) {
    THROW_ARGOSEXCEPTION("there is no type of entity \""
                         << type << '"' << DidYouMean(type, space.GetEntityTypes()));
  }
  return {1};
}

CLuaController& GetLuaController(CEntity& entity) {
  auto* const robot = FindComponent<CControllableEntity>(entity, "controller");
  auto* const controller =
      robot != nullptr ? dynamic_cast<CLuaController*>(&robot->GetController()) : nullptr;
  if (controller == nullptr || controller->GetLuaState() == nullptr) {
    ThrowUnfit(entity, "runs no Lua script");
  }
  return *controller;
}

/** Restores the height of a stack. */
class CStackGuard : private CNonCopyable {
 public:
  explicit CStackGuard(lua_State* state) : m_state(state), m_top(lua_gettop(state)) {}
  ~CStackGuard() { lua_settop(m_state, m_top); }

 private:
  lua_State* m_state;
  int m_top;
};

/** Copies the value on top of one state to the top of another; nil if it cannot be copied. */
void CopyValue(lua_State* from, lua_State* to) {
  lua_createtable(from, 1, 0);
  lua_insert(from, -2);
  lua_rawseti(from, -2, 1);
  CByteArray data;
  CLuaUtility::LuaSerializeTable(data, from);
  lua_pop(from, 1);
  if (!CLuaUtility::LuaDeserializeTable(data, to)) {
    lua_pushnil(to);
    return;
  }
  lua_rawgeti(to, -1, 1);
  lua_remove(to, -2);
}

CControllableEntity& GetRobot(CEntity& entity) {
  auto* const robot = FindComponent<CControllableEntity>(entity, "controller");
  if (robot == nullptr) {
    ThrowUnfit(entity, "is no robot");
  }
  return *robot;
}

void SetRobotEnabled(CControllableEntity& robot, bool isEnabled) {
  robot.SetEnabled(isEnabled);
  if (auto* const messages = FindComponent<CRABEquippedEntity>(robot.GetRootEntity(), "rab")) {
    messages->SetEnabled(isEnabled);
  }
}

CBatteryEquippedEntity& GetBatteryOf(CEntity& entity) {
  auto* const battery = FindComponent<CBatteryEquippedEntity>(entity, "battery");
  if (battery == nullptr) {
    ThrowUnfit(entity, "has no battery");
  }
  return *battery;
}

CLEDEquippedEntity& GetLEDs(CEntity& entity) {
  auto* const leds = FindComponent<CLEDEquippedEntity>(entity, "leds");
  if (leds == nullptr || leds->GetNumLEDs() == 0) {
    ThrowUnfit(entity, "has no LEDs");
  }
  return *leds;
}

CLightEntity& GetLight(CEntity& entity) {
  auto* const light = dynamic_cast<CLightEntity*>(&entity);
  if (light == nullptr) {
    THROW_ARGOSEXCEPTION("\"" << entity.GetId() << "\" is a <" << entity.GetTypeDescription()
                              << ">, no <light>");
  }
  return *light;
}

struct SPlaceOfPheromone {
  CPheromoneMedium& Medium;
  size_t Layer;
  CVector3 Point;  // m
};

/** Reads medium, layer, x, y. */
SPlaceOfPheromone NextPlaceOfPheromone(CLuaArguments& arguments, CSimulator& simulator) {
  auto& medium = simulator.GetMedium<CPheromoneMedium>(arguments.Next<std::string>());
  const size_t layer = medium.GetLayerNumber(arguments.Next<std::string>());
  const Real x = arguments.Next<Real>();
  return {medium, layer, CVector3(x, arguments.Next<Real>(), 0.0)};
}

}  // namespace

CLuaSimulation::CLuaSimulation(CLoopFunctions& loopFunctions)
    : m_loopFunctions(loopFunctions), m_simulator(loopFunctions.GetSimulator()), m_random(0) {}

CLuaSimulation::~CLuaSimulation() = default;

UInt64 CLuaSimulation::Seed(const char* phase) {
  CRandomStream seeds(m_simulator.GetRandomSeed(), "argos", "loop_functions",
                      std::string("Lua ") + phase);
  m_random.Seed(static_cast<UInt32>(seeds.Next()));
  return seeds.Next();
}

void CLuaSimulation::Register(lua_State* state, const TConfigurationNode& params) {
  lua_newtable(state);
  AddFunctions(state);
  AddConstants(state);
  CLuaParameters::Add(state, params);
  CLuaUtility::StartTable(state, "random");
  m_random.Register(state, "simulation.random.");
  CLuaUtility::EndTable(state);
  lua_setglobal(state, "simulation");
}

void CLuaSimulation::AddFunctions(lua_State* state) {
  AddMethod<&CLuaSimulation::GetClock>(state, "clock", *this);
  AddMethod<&CLuaSimulation::GetTime>(state, "time", *this);
  AddMethod<&CLuaSimulation::GetSeed>(state, "seed", *this);
  AddMethod<&CLuaSimulation::GetIds>(state, "ids", *this);
  AddMethod<&CLuaSimulation::GetEntities>(state, "entities", *this);
  AddMethod<&CLuaSimulation::GetEntity>(state, "entity", *this);
  AddMethod<&CLuaSimulation::GetPosition>(state, "position", *this);
  AddMethod<&CLuaSimulation::GetYaw>(state, "yaw", *this);
  AddMethod<&CLuaSimulation::Move>(state, "move", *this);
  AddMethod<&CLuaSimulation::IsFree>(state, "is_free", *this);
  AddMethod<&CLuaSimulation::Add>(state, "add", *this);
  AddMethod<&CLuaSimulation::Remove>(state, "remove", *this);
  AddMethod<&CLuaSimulation::Disable>(state, "disable", *this);
  AddMethod<&CLuaSimulation::Enable>(state, "enable", *this);
  AddMethod<&CLuaSimulation::IsEnabled>(state, "is_enabled", *this);
  AddMethod<&CLuaSimulation::GetBattery>(state, "battery", *this);
  AddMethod<&CLuaSimulation::SetBattery>(state, "set_battery", *this);
  AddMethod<&CLuaSimulation::SetLEDColor>(state, "set_led_color", *this);
  AddMethod<&CLuaSimulation::SetAllLEDColors>(state, "set_all_led_colors", *this);
  AddMethod<&CLuaSimulation::SetLightColor>(state, "set_light_color", *this);
  AddMethod<&CLuaSimulation::SetLightIntensity>(state, "set_light_intensity", *this);
  AddMethod<&CLuaSimulation::GetLightIntensity>(state, "light_intensity", *this);
  AddMethod<&CLuaSimulation::GetVariable>(state, "get_variable", *this);
  AddMethod<&CLuaSimulation::SetVariable>(state, "set_variable", *this);
  AddMethod<&CLuaSimulation::GetPheromone>(state, "pheromone", *this);
  AddMethod<&CLuaSimulation::GetTotalPheromone>(state, "total_pheromone", *this);
  AddMethod<&CLuaSimulation::LayPheromone>(state, "lay_pheromone", *this);
  AddMethod<&CLuaSimulation::SetMetric>(state, "metric", *this);
  AddMethod<&CLuaSimulation::FloorChanged>(state, "floor_changed", *this);
  AddMethod<&CLuaSimulation::Finish>(state, "finish", *this);
}

void CLuaSimulation::AddConstants(lua_State* state) const {
  const CSpace& space = m_loopFunctions.GetSpace();
  CLuaUtility::AddToTable(state, "tick_length", m_simulator.GetTickLength());
  CLuaUtility::AddToTable(state, "length",
                          m_simulator.GetMaxSimulationClock() * m_simulator.GetTickLength());
  CLuaUtility::StartTable(state, "arena");
  CLuaUtility::AddToTable(state, "size", space.GetArenaSize());
  CLuaUtility::AddToTable(state, "center", space.GetArenaCenter());
  CLuaUtility::AddToTable(state, "min", space.GetArenaLimits().GetMin());
  CLuaUtility::AddToTable(state, "max", space.GetArenaLimits().GetMax());
  CLuaUtility::EndTable(state);
}

CEntity& CLuaSimulation::GetRoot(const std::string& id) {
  CEntity& entity = m_loopFunctions.GetSpace().GetEntity(id);
  if (entity.HasParent()) {
    THROW_ARGOSEXCEPTION("\"" << id << "\" is a component; only whole entities can be used here");
  }
  return entity;
}

SLuaInteger CLuaSimulation::GetClock() {
  return {m_loopFunctions.GetSpace().GetSimulationClock()};
}

Real CLuaSimulation::GetTime() {
  return m_loopFunctions.GetSpace().GetSimulationClock() * m_simulator.GetTickLength();
}

SLuaInteger CLuaSimulation::GetSeed() {
  return {m_simulator.GetRandomSeed()};
}

SLuaResults CLuaSimulation::GetIds(CLuaArguments& arguments) {
  return PushList(m_loopFunctions.GetSpace(), arguments, [](lua_State* state, CEntity& entity) {
    CLuaValue::Push(state, entity.GetId());
  });
}

SLuaResults CLuaSimulation::GetEntities(CLuaArguments& arguments) {
  return PushList(m_loopFunctions.GetSpace(), arguments, &PushEntity);
}

SLuaResults CLuaSimulation::GetEntity(CLuaArguments& arguments) {
  const auto id = arguments.Next<std::string>();
  CEntity* entity = nullptr;
  try {
    entity = &m_loopFunctions.GetSpace().GetEntity(id);
  } catch (const CARGoSException&) {
    // scripts may ask whether there is such an entity
  }
  if (entity != nullptr && !entity->HasParent()) {
    PushEntity(arguments.GetState(), *entity);
  } else {
    lua_pushnil(arguments.GetState());
  }
  return {1};
}

SLuaResults CLuaSimulation::GetPosition(CLuaArguments& arguments) {
  const CVector3 position = GetPose(GetRoot(arguments.Next<std::string>())).Position;
  CLuaValue::Push(arguments.GetState(), position.GetX());
  CLuaValue::Push(arguments.GetState(), position.GetY());
  CLuaValue::Push(arguments.GetState(), position.GetZ());
  return {3};
}

Real CLuaSimulation::GetYaw(const std::string& id) {
  CRadians z;
  CRadians y;
  CRadians x;
  GetPose(GetRoot(id)).Orientation.ToEulerAngles(z, y, x);
  return z.GetValue();
}

bool CLuaSimulation::MoveOrCheck(CLuaArguments& arguments, bool checkOnly) {
  CEntity& entity = GetRoot(arguments.Next<std::string>());
  const SPose pose = NextPose(arguments, GetPose(entity));
  if (auto* const body = FindComponent<CEmbodiedEntity>(entity, "body")) {
    return m_loopFunctions.MoveEntity(*body, pose.Position, pose.Orientation, checkOnly);
  }
  if (!checkOnly) {
    m_loopFunctions.MoveEntity(dynamic_cast<CPositionalEntity&>(entity), pose.Position,
                               pose.Orientation);
  }
  return true;
}

bool CLuaSimulation::Move(CLuaArguments& arguments) {
  return MoveOrCheck(arguments, false);
}

bool CLuaSimulation::IsFree(CLuaArguments& arguments) {
  return MoveOrCheck(arguments, true);
}

SLuaResults CLuaSimulation::Add(CLuaArguments& arguments) {
  const auto xml = arguments.Next<std::string>();
  arguments.Finish();
  CConfigurationDocument document;
  document.Parse(xml, "simulation.add");
  CEntity& entity = m_loopFunctions.GetSpace().CreateEntity(document.GetRoot());
  const std::string id = entity.GetId();
  const std::vector<std::string> repeated = document.DescribeRepeated();
  if (!repeated.empty()) {
    m_loopFunctions.RemoveEntity(entity);
    THROW_ARGOSEXCEPTION(repeated.front());
  }
  for (const std::string& unread : document.DescribeUnread()) {
    LOGERR << "[WARNING] " << unread << std::endl;
  }
  const auto* const body = FindComponent<CEmbodiedEntity>(entity, "body");
  CLuaValue::Push(arguments.GetState(), id);
  CLuaValue::Push(arguments.GetState(), body == nullptr || !body->IsCollidingWithSomething());
  return {2};
}

void CLuaSimulation::Remove(const std::string& id) {
  m_loopFunctions.RemoveEntity(GetRoot(id));
}

void CLuaSimulation::Disable(const std::string& id) {
  CControllableEntity& robot = GetRobot(GetRoot(id));
  // the commands of the start: wheels stand still, LEDs and messages are off
  for (const auto& [tag, actuator] : robot.GetController().GetAllActuators()) {
    actuator->Reset();
  }
  robot.Act();
  SetRobotEnabled(robot, false);
}

void CLuaSimulation::Enable(const std::string& id) {
  SetRobotEnabled(GetRobot(GetRoot(id)), true);
}

bool CLuaSimulation::IsEnabled(const std::string& id) {
  const CControllableEntity& robot = GetRobot(GetRoot(id));
  return robot.IsEnabled() && !robot.IsStopped();
}

Real CLuaSimulation::GetBattery(const std::string& id) {
  return GetBatteryOf(GetRoot(id)).GetAvailableCharge();
}

void CLuaSimulation::SetBattery(const std::string& id, Real charge) {
  CBatteryEquippedEntity& battery = GetBatteryOf(GetRoot(id));
  if (!(charge >= 0.0) || charge > battery.GetFullCharge()) {
    THROW_ARGOSEXCEPTION("the charge must be from 0 to " << battery.GetFullCharge() << ", got "
                                                         << charge);
  }
  battery.SetAvailableCharge(charge);
}

void CLuaSimulation::SetLEDColor(CLuaArguments& arguments) {
  CLEDEquippedEntity& leds = GetLEDs(GetRoot(arguments.Next<std::string>()));
  const auto led = static_cast<UInt32>(arguments.NextIndex(leds.GetNumLEDs()));
  const auto color = arguments.Next<CColor>();
  arguments.Finish();
  leds.SetLEDColor(led, color);
}

void CLuaSimulation::SetAllLEDColors(const std::string& id, const CColor& color) {
  GetLEDs(GetRoot(id)).SetAllLEDsColors(color);
}

void CLuaSimulation::SetLightColor(const std::string& id, const CColor& color) {
  GetLight(GetRoot(id)).SetColor(color);
}

void CLuaSimulation::SetLightIntensity(const std::string& id, Real intensity) {
  GetLight(GetRoot(id)).SetIntensity(intensity);
}

Real CLuaSimulation::GetLightIntensity(const std::string& id) {
  return GetLight(GetRoot(id)).GetIntensity();
}

SLuaResults CLuaSimulation::GetVariable(CLuaArguments& arguments) {
  CLuaController& controller = GetLuaController(GetRoot(arguments.Next<std::string>()));
  const auto name = arguments.Next<std::string>();
  arguments.Finish();
  lua_State* const robot = controller.GetLuaState();
  const CStackGuard guard(robot);
  lua_pushglobaltable(robot);
  CLuaValue::Push(robot, name);
  lua_rawget(robot, -2);
  CopyValue(robot, arguments.GetState());
  return {1};
}

void CLuaSimulation::SetVariable(CLuaArguments& arguments) {
  CLuaController& controller = GetLuaController(GetRoot(arguments.Next<std::string>()));
  const auto name = arguments.Next<std::string>();
  lua_State* const script = arguments.GetState();
  if (arguments.GetCount() != 3) {
    THROW_ARGOSEXCEPTION("takes the id of a robot, the name of a variable and a value, got "
                         << arguments.GetCount() << " arguments");
  }
  arguments.Skip();
  lua_State* const robot = controller.GetLuaState();
  const CStackGuard guard(robot);
  lua_pushglobaltable(robot);
  CLuaValue::Push(robot, name);
  lua_pushvalue(script, 3);
  CopyValue(script, robot);
  lua_rawset(robot, -3);
}

Real CLuaSimulation::GetPheromone(CLuaArguments& arguments) {
  const SPlaceOfPheromone place = NextPlaceOfPheromone(arguments, m_simulator);
  arguments.Finish();
  return place.Medium.GetConcentration(place.Layer, place.Point);
}

Real CLuaSimulation::GetTotalPheromone(const std::string& medium, const std::string& layer) {
  auto& pheromone = m_simulator.GetMedium<CPheromoneMedium>(medium);
  return pheromone.GetField(pheromone.GetLayerNumber(layer)).ComputeTotal();
}

void CLuaSimulation::LayPheromone(CLuaArguments& arguments) {
  const SPlaceOfPheromone place = NextPlaceOfPheromone(arguments, m_simulator);
  const Real amount = arguments.Next<Real>();
  arguments.Finish();
  place.Medium.Deposit(place.Layer, place.Point, amount);
}

void CLuaSimulation::SetMetric(CLuaArguments& arguments) {
  const auto name = arguments.Next<std::string>();
  const auto value = arguments.Next<Real>();
  const auto unit = arguments.HasNext() ? arguments.Next<std::string>() : std::string();
  arguments.Finish();
  m_loopFunctions.SetMetric(name, value, unit);
}

void CLuaSimulation::FloorChanged() {
  m_loopFunctions.GetSpace().GetFloorEntity().SetChanged();
}

void CLuaSimulation::Finish() {
  m_simulator.Terminate();
}

}  // namespace argos
