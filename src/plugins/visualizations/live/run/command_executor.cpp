#include <argos3/plugins/simulator/visualizations/live/run/command_executor.h>

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/view_drawing.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/simulator/differential_steering_default_actuator.h>
#include <argos3/plugins/simulator/visualizations/live/run/command_arguments.h>

#include <algorithm>
#include <utility>

namespace argos {

namespace {

constexpr Real kMaxMetres = 1e6;
constexpr Real kMaxDegrees = 1e6;
constexpr Real kMinSize = 1e-3;  // m, of things that are added
constexpr Real kMaxSize = 100.0;
constexpr Real kMinMass = 1e-3;  // kg
constexpr Real kMaxMass = 1e6;
constexpr Real kMaxRadians = 1e3;

CQuaternion Upright(Real yaw) {
  return CQuaternion(CRadians(yaw), CVector3::Z);
}

// @return the pose of the body, or of the entity; the origin if it has none
SBodyPose GetPose(CEntity& root) {
  if (const auto* const body = FindExisting<CEmbodiedEntity>(root)) {
    return {body->GetOriginAnchor().Position, body->GetOriginAnchor().Orientation};
  }
  if (const auto* const positional = dynamic_cast<CPositionalEntity*>(&root)) {
    return {positional->GetPosition(), positional->GetOrientation()};
  }
  return {};
}

bool IsThing(const std::string& type) {
  return type == "box" || type == "cylinder";
}

// calls take(element) for elements of entities, those of <distribute>, too
template <typename TAKE>
void ForEachEntityElement(TConfigurationNode& arena, TAKE&& take) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&arena); it != it.end(); ++it) {
    if (it->Value() != "distribute") {
      take(*it);
    } else if (NodeExists(*it, "entity")) {
      TConfigurationNodeIterator inner;
      inner = inner.begin(&GetNode(*it, "entity"));
      if (inner != inner.end()) {
        take(*inner);
      }
    }
  }
}

}  // namespace

CCommandExecutor::TAction CCommandExecutor::FindAction(const std::string& command) {
  constexpr std::pair<const char*, TAction> kActions[] = {
      {"move", &CCommandExecutor::Move},
      {"add", &CCommandExecutor::Add},
      {"remove", &CCommandExecutor::Remove},
      {"drive", &CCommandExecutor::SetDrive},
      {"user_select", &CCommandExecutor::Select},
      {"user_key", &CCommandExecutor::PressKey},
      {"script", &CCommandExecutor::ApplyScript},
      {"set_parameter", &CCommandExecutor::SetParameter}};
  for (const auto& [name, action] : kActions) {
    if (command == name) {
      return action;
    }
  }
  return nullptr;
}

bool CCommandExecutor::Knows(const std::string& command) {
  return FindAction(command) != nullptr;
}

TJson CCommandExecutor::Do(const std::string& command, const TJson& arguments) {
  if (m_simulator.IsReplay()) {
    THROW_ARGOSEXCEPTION("a replay shows what was recorded: nothing can be changed in it");
  }
  const TAction action = FindAction(command);
  if (action == nullptr) {
    THROW_ARGOSEXCEPTION("there is no command \"" << command << '"');
  }
  return (this->*action)(arguments);
}

CEntity& CCommandExecutor::GetRoot(const TJson& arguments) {
  const std::string id = ReadTextArgument(arguments, "entity");
  CEntity* const entity = m_simulator.GetSpace().TryGetEntity(id);
  if (entity == nullptr) {
    THROW_ARGOSEXCEPTION("there is no entity \"" << id << '"');
  }
  return entity->GetRootEntity();
}

// null if none is named
CEntity* CCommandExecutor::FindRoot(const TJson& arguments) {
  return arguments.contains("entity") && !arguments["entity"].is_null() ? &GetRoot(arguments)
                                                                        : nullptr;
}

void CCommandExecutor::CheckPlace(const CVector3& position) const {
  const CRange<CVector3>& limits = m_simulator.GetSpace().GetArenaLimits();
  const CVector3& least = limits.GetMin();
  const CVector3& most = limits.GetMax();
  if (position.GetX() < least.GetX() || position.GetY() < least.GetY() ||
      position.GetX() > most.GetX() || position.GetY() > most.GetY()) {
    THROW_ARGOSEXCEPTION("(" << position << ") is outside of the arena");
  }
}

std::string CCommandExecutor::DescribeObstacle(const CEmbodiedEntity& body,
                                               const CVector3& position,
                                               const CQuaternion& orientation) const {
  const CBodyIndex& index = m_simulator.GetSpace().GetBodyIndex();
  if (body.GetBodyDescription() == nullptr) {
    return "another body";
  }
  const UInt32 obstacle =
      index.FindOverlap(*body.GetBodyDescription(), position, orientation, body.GetBodyNumber());
  return obstacle == CBodyIndex::kNoBody
             ? "another body, or nearly touch it"
             : '"' + index.GetBody(obstacle).GetRootEntity().GetId() + '"';
}

TJson CCommandExecutor::Move(const TJson& arguments) {
  CEntity& root = GetRoot(arguments);
  const SBodyPose before = GetPose(root);
  MoveRoot(root, arguments);
  const SBodyPose now = GetPose(root);
  m_drawing.ForEachFunctions(
      [&](CDrawingFunctions& functions) { functions.HandleMove(root, before, now); });
  return TJson::object();
}

void CCommandExecutor::MoveRoot(CEntity& root, const TJson& arguments) const {
  const auto position = ReadVectorArgument(arguments, "position", kMaxMetres);
  const auto yaw = ReadNumberArgument(arguments, "yaw", -kMaxRadians, kMaxRadians);
  if (auto* const body = FindExisting<CEmbodiedEntity>(root)) {
    const SAnchor& origin = body->GetOriginAnchor();
    const CVector3 place = position.value_or(origin.Position);
    const CQuaternion orientation = yaw ? Upright(*yaw) : origin.Orientation;
    CheckPlace(place);
    if (!body->MoveTo(place, orientation)) {
      THROW_ARGOSEXCEPTION('"' << root.GetId() << "\" would overlap "
                               << DescribeObstacle(*body, place, orientation) << " there");
    }
  } else if (auto* const positional = dynamic_cast<CPositionalEntity*>(&root)) {
    const CVector3 place = position.value_or(positional->GetPosition());
    CheckPlace(place);
    positional->MoveTo(place, yaw ? Upright(*yaw) : positional->GetOrientation());
  } else {
    THROW_ARGOSEXCEPTION('"' << root.GetId() << "\" has no place: it cannot be moved");
  }
}

// null if it is no robot with such an actuator, or not there any more
CCI_DifferentialSteeringActuator* CCommandExecutor::FindWheels(const std::string& id) {
  CEntity* const root = m_simulator.GetSpace().TryGetEntity(id);
  auto* const robot = root != nullptr ? FindExisting<CControllableEntity>(*root) : nullptr;
  if (robot == nullptr || !robot->HasController()) {
    return nullptr;
  }
  const CCI_Actuator::TMap& actuators = robot->GetController().GetAllActuators();
  const auto found = actuators.find("differential_steering");
  return found == actuators.end() ? nullptr
                                  : dynamic_cast<CCI_DifferentialSteeringActuator*>(found->second);
}

TJson CCommandExecutor::SetDrive(const TJson& arguments) {
  constexpr Real kMaxSpeed = 1e4;  // cm/s
  const std::string id = GetRoot(arguments).GetId();
  const auto left = ReadNumberArgument(arguments, "left", -kMaxSpeed, kMaxSpeed);
  const auto right = ReadNumberArgument(arguments, "right", -kMaxSpeed, kMaxSpeed);
  if (FindWheels(id) == nullptr) {
    THROW_ARGOSEXCEPTION('"' << id
                             << "\" has no actuator \"differential_steering\": it cannot be "
                                "driven");
  }
  if (left && right) {
    m_driven[id] = {*left, *right};
  } else if (m_driven.erase(id) > 0) {
    LetGo(id);
  }
  return TJson::object();
}

// An implementation of users' own goes on at these speeds until its controller sets others.
void CCommandExecutor::LetGo(const std::string& id) {
  if (auto* const wheels = dynamic_cast<CDifferentialSteeringDefaultActuator*>(FindWheels(id))) {
    wheels->EndOverride();
  }
}

void CCommandExecutor::ForgetDrivers() {
  for (const auto& [id, speeds] : std::exchange(m_driven, {})) {
    LetGo(id);
  }
}

// Call it after the controllers' step, whose speeds it replaces, and before wheels get them.
void CCommandExecutor::Drive() {
  for (auto robot = m_driven.begin(); robot != m_driven.end();) {
    CCI_DifferentialSteeringActuator* const wheels = FindWheels(robot->first);
    if (wheels == nullptr) {
      robot = m_driven.erase(robot);
      continue;
    }
    const auto [left, right] = robot->second;
    if (auto* const ours = dynamic_cast<CDifferentialSteeringDefaultActuator*>(wheels)) {
      ours->Override(left, right);
    } else {
      wheels->SetLinearVelocity(left, right);
    }
    ++robot;
  }
}

TJson CCommandExecutor::OpenScript(const TJson& arguments) {
  return m_scripts.Open(GetRoot(arguments));
}

TJson CCommandExecutor::ListParameters(const TJson& arguments) {
  return {{"parameters", m_parameters.List(FindRoot(arguments))}};
}

TJson CCommandExecutor::ApplyScript(const TJson& arguments) {
  CEntity& root = GetRoot(arguments);
  TJson answer = m_scripts.Apply(root, ReadTextArgument(arguments, "text"));
  if (!answer.contains("error")) {
    // the robot that is asked for may not be there after a reset, where others are
    TJson command = arguments;
    command["entity"] = answer["first"];
    Keep(command, "script " + answer["file"].get<std::string>());
  }
  return answer;
}

TJson CCommandExecutor::SetParameter(const TJson& arguments) {
  CEntity* const root = FindRoot(arguments);
  TJson answer = m_parameters.Set(root, arguments);
  TJson key = {root != nullptr ? root->GetId() : "", arguments["name"],
               ReadFlagArgument(arguments, "all").value_or(false)};
  Keep(arguments, "parameter " + ToText(key));
  return answer;
}

void CCommandExecutor::Keep(const TJson& command, const std::string& key) {
  m_kept.erase(std::remove_if(m_kept.begin(), m_kept.end(),
                              [&](const auto& kept) { return kept.first == key; }),
               m_kept.end());
  m_kept.emplace_back(key, command);
}

CCommandExecutor::SRestart CCommandExecutor::Restore() {
  m_scripts.Restore();
  m_parameters.Restore();
  CSpace& space = m_simulator.GetSpace();
  for (const std::string& id : std::exchange(m_added, {})) {
    if (CEntity* const root = space.TryGetEntity(id)) {
      space.Remove(*root);
    }
  }
  CheckSelection();
  SRestart restart{m_removals, {}};
  for (auto& [key, command] : std::exchange(m_kept, {})) {
    restart.ToDo.push_back(std::move(command));
  }
  return restart;
}

TJson CCommandExecutor::Select(const TJson& arguments) {
  CEntity* const root = FindRoot(arguments);
  m_selected = root != nullptr ? root->GetId() : std::string();
  m_selectedIndex = root != nullptr ? root->GetIndex() : -1;
  m_drawing.ForEachFunctions(
      [root](CDrawingFunctions& functions) { functions.HandleSelection(root); });
  return TJson::object();
}

void CCommandExecutor::CheckSelection() {
  if (m_selected.empty()) {
    return;
  }
  const CEntity* const root = m_simulator.GetSpace().TryGetEntity(m_selected);
  if (root == nullptr || root->GetIndex() != m_selectedIndex) {
    m_selected.clear();
    m_drawing.ForEachFunctions([](CDrawingFunctions& functions) { functions.ForgetSelection(); });
  }
}

TJson CCommandExecutor::PressKey(const TJson& arguments) {
  constexpr size_t kMaxKeyBytes = 32;
  constexpr size_t kMaxPressed = 64;
  SViewKey key;
  key.Name = ReadTextArgument(arguments, "key");
  key.IsDown = ReadFlagArgument(arguments, "down").value_or(true);
  key.HasShift = ReadFlagArgument(arguments, "shift").value_or(false);
  key.HasControl = ReadFlagArgument(arguments, "control").value_or(false);
  key.HasAlt = ReadFlagArgument(arguments, "alt").value_or(false);
  key.HasMeta = ReadFlagArgument(arguments, "meta").value_or(false);
  if (key.Name.size() > kMaxKeyBytes) {
    THROW_ARGOSEXCEPTION("\"key\" is the name of a key, such as \"a\" or \"ArrowUp\"");
  }
  // released with the viewer's control, also if a function throws
  if (!key.IsDown) {
    m_pressed.erase(key.Name);
  } else if (m_pressed.size() < kMaxPressed) {
    m_pressed.insert(key.Name);
  }
  bool isHandled = false;
  m_drawing.ForEachFunctions(
      [&](CDrawingFunctions& functions) { isHandled = functions.HandleKey(key) || isHandled; });
  return {{"handled", isHandled}};
}

std::vector<TJson> CCommandExecutor::ListReleases() {
  std::vector<TJson> commands;
  for (const std::string& key : m_pressed) {
    commands.push_back({{"do", "user_key"}, {"key", key}, {"down", false}});
  }
  if (!m_selected.empty()) {
    commands.push_back({{"do", "user_select"}});
  }
  for (const auto& [id, speeds] : m_driven) {
    if (FindWheels(id) != nullptr) {
      commands.push_back({{"do", "drive"}, {"entity", id}});
    }
  }
  return commands;
}

TJson CCommandExecutor::Remove(const TJson& arguments) {
  CEntity& root = GetRoot(arguments);
  if (dynamic_cast<CFloorEntity*>(&root) != nullptr) {
    THROW_ARGOSEXCEPTION("the floor cannot be removed");
  }
  if (root.GetId() == m_selected) {
    Select(TJson::object());
  }
  if (m_added.erase(root.GetId()) == 0) {
    m_removals.push_back({{"do", "remove"}, {"entity", root.GetId()}});
  }
  m_simulator.GetSpace().Remove(root);
  return TJson::object();
}

std::vector<std::string> CCommandExecutor::ListTypesToAdd() {
  std::vector<std::string> types;
  if (m_simulator.IsReplay()) {
    return types;
  }
  const auto add = [&](const std::string& type) {
    if (type != "floor" && m_simulator.GetSpace().HasEntityType(type) &&
        std::find(types.begin(), types.end(), type) == types.end()) {
      types.push_back(type);
    }
  };
  ForEachEntityElement(GetNode(m_simulator.GetConfigurationRoot(), "arena"),
                       [&](TConfigurationNode& element) { add(element.Value()); });
  add("box");
  add("cylinder");
  return types;
}

// the first one of the file; null if it has none
TConfigurationNode* CCommandExecutor::FindTemplate(const std::string& type) {
  TConfigurationNode* found = nullptr;
  ForEachEntityElement(GetNode(m_simulator.GetConfigurationRoot(), "arena"),
                       [&](TConfigurationNode& element) {
                         found = found == nullptr && element.Value() == type ? &element : found;
                       });
  return found;
}

TConfigurationNode CCommandExecutor::MakeElement(const std::string& type, const TJson& arguments) {
  const std::vector<std::string> types = ListTypesToAdd();
  if (std::find(types.begin(), types.end(), type) == types.end()) {
    THROW_ARGOSEXCEPTION("the experiment has no \"" << type
                                                    << "\" that could be the model of another one"
                                                    << DidYouMean(type, types));
  }
  TConfigurationNode* const model = IsThing(type) ? nullptr : FindTemplate(type);
  TConfigurationNode element = model != nullptr ? *model->Clone() : TConfigurationNode(type);
  if (IsThing(type)) {
    element.SetAttribute("movable",
                         ReadFlagArgument(arguments, "movable").value_or(true) ? "true" : "false");
    element.SetAttribute("mass",
                         ReadNumberArgument(arguments, "mass", kMinMass, kMaxMass).value_or(0.1));
  }
  if (type == "box") {
    const CVector3 size =
        ReadVectorArgument(arguments, "size", kMaxSize).value_or(CVector3(0.1, 0.1, 0.1));
    if (size.GetX() < kMinSize || size.GetY() < kMinSize || size.GetZ() < kMinSize) {
      THROW_ARGOSEXCEPTION("\"size\" is at least " << kMinSize << " m along each side");
    }
    element.SetAttribute("size", size);
  } else if (type == "cylinder") {
    element.SetAttribute(
        "radius", ReadNumberArgument(arguments, "radius", kMinSize, kMaxSize).value_or(0.05));
    element.SetAttribute("height",
                         ReadNumberArgument(arguments, "height", kMinSize, kMaxSize).value_or(0.1));
  }
  return element;
}

std::string CCommandExecutor::MakeId(const std::string& type) const {
  for (UInt32 number = 1;; ++number) {
    std::string id = type + "_added_" + std::to_string(number);
    if (m_simulator.GetSpace().TryGetEntity(id) == nullptr) {
      return id;
    }
  }
}

TJson CCommandExecutor::Add(const TJson& arguments) {
  CSpace& space = m_simulator.GetSpace();
  const std::string type = ReadTextArgument(arguments, "type");
  const auto position = ReadVectorArgument(arguments, "position", kMaxMetres);
  const Real yaw = ReadNumberArgument(arguments, "yaw", -kMaxRadians, kMaxRadians).value_or(0.0);
  if (!position) {
    THROW_ARGOSEXCEPTION("\"position\" is missing");
  }
  CheckPlace(*position);
  TConfigurationNode element = MakeElement(type, arguments);
  const std::string id = MakeId(type);
  element.SetAttribute("id", id);
  // an entity without a body has its pose in attributes of its own element
  TConfigurationNode* pose = &element;
  if (dynamic_cast<CPositionalEntity*>(space.MakeEntity(type).get()) == nullptr) {
    if (!NodeExists(element, "body")) {
      TConfigurationNode body("body");
      AddChildNode(element, body);
    }
    pose = &GetNode(element, "body");
  }
  pose->SetAttribute("position", *position);
  pose->SetAttribute("orientation", CVector3(yaw * CRadians::RADIANS_TO_DEGREES, 0.0, 0.0));
  CEntity& entity = space.CreateEntity(element);
  const auto* const body = FindExisting<CEmbodiedEntity>(entity);
  if (body != nullptr && body->IsCollidingWithSomething()) {
    const std::string obstacle = DescribeObstacle(*body, body->GetOriginAnchor().Position,
                                                  body->GetOriginAnchor().Orientation);
    space.Remove(entity);
    THROW_ARGOSEXCEPTION("it would overlap " << obstacle << " there");
  }
  m_added.insert(id);
  m_scripts.ApplyToAdded(entity);
  return {{"entity", id}};
}

}  // namespace argos
