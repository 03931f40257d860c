#include <argos3/core/simulator/entity/controllable_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/utility/configuration/single_element.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/errors/signal_safe_text.h>
#include <argos3/core/utility/plugins/unknown_label.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <exception>

namespace argos {

namespace {

// bytes that most devices and controllers use in every tick, from their beginning; of a controller
// also from the end of its base
constexpr size_t kSensorBytes = 160;
constexpr size_t kActuatorBytes = 80;
constexpr size_t kControllerBytes = 96;
static_assert(kSensorBytes > sizeof(CSimulatedSensor) &&
                  kActuatorBytes > sizeof(CSimulatedActuator),
              "the members of derived classes are behind those of the base");

// a <sensors> or <actuators> section, or null: it may be left out
TConfigurationNode* FindSection(TConfigurationNode& controllerNode, const std::string& tag) {
  return NodeExists(controllerNode, tag) ? &GetNode(controllerNode, tag) : nullptr;
}

// the implementations of a device; empty if there is no such device
template <typename SIMULATED>
std::string ListImplementations(const std::string& tag) {
  const std::string before = tag + " (";
  std::string list;
  for (const std::string& label : CFactory<SIMULATED>::GetLabels()) {
    if (label.rfind(before, 0) == 0) {
      AppendQuoted(list, label.substr(before.size(), label.size() - before.size() - 1));
    }
  }
  return list;
}

template <typename SIMULATED>
std::string ReadImplementation(TConfigurationNode& node, const char* kind) {
  if (!NodeAttributeExists(node, "implementation")) {
    const std::string known = ListImplementations<SIMULATED>(node.Value());
    if (!known.empty()) {
      THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << node.Value()
                                              << ">: attribute \"implementation\" is missing; the "
                                              << kind << " has: " << known);
    }
  }
  std::string implementation;
  GetNodeAttribute(node, "implementation", implementation);
  return implementation;
}

// makes the device of one XML element, as its simulated side and as its interface
template <typename SIMULATED, typename INTERFACE>
std::pair<SIMULATED*, std::unique_ptr<INTERFACE>> CreateDevice(TConfigurationNode& node,
                                                               const char* kind) {
  LoadLibraryOf(node);
  const std::string label = node.Value() + " (" + ReadImplementation<SIMULATED>(node, kind) + ")";
  if (!CFactory<SIMULATED>::Exists(label)) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": there is no " << kind << " \"" << label << "\""
                         << DescribeUnknownLabel(label, CFactory<SIMULATED>::GetLabels()));
  }
  std::unique_ptr<SIMULATED> simulated(CFactory<SIMULATED>::New(label));
  auto* interface = dynamic_cast<INTERFACE*>(simulated.get());
  if (interface == nullptr) {
    THROW_ARGOSEXCEPTION(kind << " \"" << label
                              << "\" does not derive from a control interface: controllers cannot "
                                 "use it");
  }
  return {simulated.release(), std::unique_ptr<INTERFACE>(interface)};
}

// calls a device's function while a robot is set up; what it throws gets the element if it is not a
// std::exception, whose text usually has it
template <typename CALL>
void CallDevice(const TConfigurationNode& node, const char* kind, CALL&& call) {
  try {
    call();
  } catch (const std::exception&) {
    throw;
  } catch (...) {
    ThrowWithCause(node.GetLocation() + ": the " + kind + " <" + node.Value() +
                   "> cannot be initialised");
  }
}

// calls SetRobot() of a device
template <typename SIMULATED>
void AttachToRobot(SIMULATED& device, CComposableEntity& robot, const TConfigurationNode& node,
                   const char* kind) {
  try {
    device.SetRobot(robot);
  } catch (const CAlreadyReported&) {
    throw;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(node.GetLocation()
                                    << ": the " << kind << " <" << node.Value() << "> does not fit "
                                    << robot.GetTypeDescription() << " \"" << robot.GetId() << '"',
                                error);
  }
}

// makes a device and initialises it for a robot
template <typename SIMULATED, typename INTERFACE>
std::unique_ptr<INTERFACE> MakeDevice(TConfigurationNode& node, const char* kind,
                                      CComposableEntity& robot) {
  auto [simulated, interface] = CreateDevice<SIMULATED, INTERFACE>(node, kind);
  CallDevice(node, kind, [&, device = simulated, &face = interface] {
    AttachToRobot(*device, robot, node, kind);
    face->Init(node);
  });
  return std::move(interface);
}

// makes the devices that a controller's element lists; kind: "sensor" for those in <sensors>
template <typename SIMULATED, typename INTERFACE, typename ADD>
void MakeDevices(TConfigurationNode& controllerNode, const std::string& kind,
                 CComposableEntity& robot, CLoadErrors& errors, ADD&& add) {
  TConfigurationNode* const section = FindSection(controllerNode, (kind + "s").c_str());
  if (section == nullptr) {
    return;
  }
  TConfigurationNodeIterator it;
  for (it = it.begin(section); it != it.end(); ++it) {
    const auto make = [&] { return MakeDevice<SIMULATED, INTERFACE>(*it, kind.c_str(), robot); };
    const auto addNew = [&] {
      CheckIsSingle(*it);
      add(it->Value(), make());
    };
    if (!errors.Try("", addNew)) {
      errors.FindFurther(make);
    }
  }
}

}  // namespace

CControllableEntity::CControllableEntity(CComposableEntity* parent)
    : CControllableEntity(parent, "controller_0") {}

CControllableEntity::CControllableEntity(CComposableEntity* parent, const std::string& id)
    : CEntity(parent, id), m_context(CurrentContext()) {}

CControllableEntity::~CControllableEntity() = default;

CSpace& CControllableEntity::GetSpace() const {
  return *m_context.Space;
}

CSimulator& CControllableEntity::GetSimulator() const {
  return m_context.Simulator;
}

void CControllableEntity::Init(TConfigurationNode& tree) {
  CEntity::Init(tree);
  std::string controllerId;
  GetNodeAttribute(tree, "config", controllerId);
  if (controllerId.empty()) {
    THROW_ARGOSEXCEPTION(
        tree.GetLocation()
        << ": <" << tree.Value()
        << ">: attribute \"config\" is empty; it must be the \"id\" of a controller "
           "in <controllers>");
  }
  if (NodeExists(tree, "params")) {
    SetController(controllerId, GetNode(tree, "params"));
  } else {
    SetController(controllerId);
  }
}

// errors of users' code

void CControllableEntity::Describe(const void* robot, CSignalSafeText& text) {
  const auto& self = *static_cast<const CControllableEntity*>(robot);
  text.Append("robot \"").Append(self.GetRootEntity().GetId()).Append("\"");
  if (self.m_setup != nullptr) {
    text.Append(", controller \"").Append(self.m_setup->Id).Append("\"");
  }
}

std::string CControllableEntity::DescribeForErrors() const {
  return "robot \"" + GetRootEntity().GetId() + '"' +
         (m_setup != nullptr ? ", controller \"" + m_setup->Id + '"' : std::string());
}

void CControllableEntity::Stop(bool byDevice, const std::string& context,
                               const std::string& cause) {
  m_isStopped = true;
  m_haveDevicesFailed = m_haveDevicesFailed || byDevice;
  m_context.RobotFailures.Note(GetRootEntity().GetId(), *m_context.Clock, context, cause);
}

// calls Reset() or Destroy() of the controller or of a device
template <typename CALL>
void CControllableEntity::CallUser(const char* call, CALL&& function) {
  const CRunningCodeScope running({call, &CControllableEntity::Describe, this, nullptr});
  try {
    function();
  } catch (...) {
    const std::string context = DescribeForErrors() + ": " + call + " threw";
    if (m_onError == EOnError::EndRun) {
      ThrowWithCause(context);
    }
    Stop(false, context, DescribeCurrentException());
  }
}

void CControllableEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  if (m_isStopped) {
    digest.Add(m_isStopped);
    digest.Add(m_isQuarantined);
  }
}

// start, reset, end

void CControllableEntity::MarkStart() {
  CEntity::MarkStart();
  if (m_pcController != nullptr) {
    for (const auto& entry : m_pcController->GetAllSensors()) {
      entry.second->MarkStart();
    }
  }
}

void CControllableEntity::ReturnToStart() {
  CEntity::ReturnToStart();
  if (m_pcController != nullptr) {
    for (const auto& entry : m_pcController->GetAllSensors()) {
      entry.second->ReturnToStart();
    }
  }
}

void CControllableEntity::Reset() {
  CEntity::Reset();
  m_vecCheckedRays.clear();
  m_vecIntersectionPoints.clear();
  m_isStopped = false;
  m_haveDevicesFailed = false;
  if (m_pcController == nullptr) {
    return;
  }
  m_pcController->ForgetRecordedValues();
  const CRandom::COwner::CScope scope(&m_randomOwner, GetBirth());
  CallUser("Reset() of a sensor", [this] {
    for (const auto& entry : m_pcController->GetAllSensors()) {
      entry.second->Reset();
    }
  });
  CallUser("Reset() of an actuator", [this] {
    for (const auto& entry : m_pcController->GetAllActuators()) {
      entry.second->Reset();
    }
  });
  CallUser("Reset()", [this] { m_pcController->Reset(); });
}

void CControllableEntity::Destroy() {
  if (m_pcController == nullptr) {
    return;
  }
  const CRandom::COwner::CScope scope(&m_randomOwner, GetBirth());
  // an exception must not keep the other parts from being destroyed
  std::exception_ptr failure;
  const auto destroy = [&](const char* call, auto& part) {
    try {
      CallUser(call, [&part] { part.Destroy(); });
    } catch (...) {
      failure = failure == nullptr ? std::current_exception() : failure;
    }
  };
  destroy("Destroy()", *m_pcController);
  for (const auto& entry : m_pcController->GetAllSensors()) {
    destroy("Destroy() of a sensor", *entry.second);
  }
  for (const auto& entry : m_pcController->GetAllActuators()) {
    destroy("Destroy() of an actuator", *entry.second);
  }
  if (failure != nullptr) {
    std::rethrow_exception(failure);
  }
}

const CCI_Controller& CControllableEntity::GetController() const {
  if (m_pcController == nullptr) {
    THROW_ARGOSEXCEPTION("robot \"" << GetContext() << GetId() << "\" has no controller");
  }
  return *m_pcController;
}

CCI_Controller& CControllableEntity::GetController() {
  return const_cast<CCI_Controller&>(
      static_cast<const CControllableEntity*>(this)->GetController());
}

void CControllableEntity::SetController(const std::string& controllerId) {
  if (m_context.Run.IsInPhase()) {
    if (GetIndex() >= 0) {
      m_context.Run.CheckIsNotInPhase("SetController()",
                                      "it is possible in PreStep() and PostStep()");
    }
    // users' random generators and the configuration must not be changed by several threads
    m_context.Loading.GetSetup(controllerId);
    m_lateController = std::make_unique<SLateController>(SLateController{controllerId, nullptr});
    return;
  }
  TConfigurationNode& node = m_context.Loading.GetController(controllerId);
  if (!NodeExists(node, "params")) {
    // adds an empty element: controllers may keep a reference to their parameters
    TConfigurationNode none("params");
    AddChildNode(node, none);
  }
  SetController(controllerId, GetNode(node, "params"));
}

void CControllableEntity::SetController(const std::string& controllerId,
                                        TConfigurationNode& params) {
  const SControllerSetup& setup = m_context.Loading.GetSetup(controllerId);
  if (m_context.Loading.IsProbing()) {
    return;
  }
  setup.IsUsed = true;
  if (m_context.Run.IsInPhase()) {
    SetController(controllerId);
    m_lateController->Params = &params;
    return;
  }
  Destroy();
  DropController();
  CreateController(setup, params);
}

void CControllableEntity::SetLateController() {
  if (m_lateController == nullptr) {
    return;
  }
  const std::unique_ptr<SLateController> late = std::move(m_lateController);
  if (late->Params != nullptr) {
    SetController(late->Id, *late->Params);
  } else {
    SetController(late->Id);
  }
}

void CControllableEntity::CreateController(const SControllerSetup& setup,
                                           TConfigurationNode& params) {
  const std::string robot = GetRootEntity().GetId();
  TConfigurationNode& node = *setup.Node;
  m_randomOwner.SetId(
      [](const void* owner) {
        const auto& entity = *static_cast<const CControllableEntity*>(owner);
        return entity.GetContext() + entity.GetId();
      },
      this);
  const CRandom::COwner::CScope scope(&m_randomOwner, GetBirth());
  m_setup = &setup;
  const CRunningCodeScope running({"Init()", &CControllableEntity::Describe, this, nullptr});
  const CSetup setUp;
  try {
    m_controller.reset(CFactory<CCI_Controller>::New(node.Value()));
    m_pcController = m_controller.get();
    m_pcController->SetId(robot);
    CLoadErrors errors;
    CreateActuators(node, errors);
    CreateSensors(node, errors);
    errors.ThrowIfFailed("errors in its devices");
    m_pcController->Init(params);
    m_onError = m_pcController->ChooseOnError(setup.OnError);
    // afterwards, because controllers may add devices of their own, or replace some
    ListDevices();
    if (GetIndex() >= 0) {
      GetRootEntity().MarkStart();
    }
  } catch (const CAlreadyReported&) {
    throw;
  } catch (...) {
    m_context.Loading.MarkBroken(setup.Id);
    DropController();
    ThrowWithCause("robot \"" + robot + "\": its controller \"" + setup.Id + "\" (" +
                   node.GetLocation() + ": <" + node.Value() + ">) cannot be set up");
  }
}

// no function of a controller that was replaced, or whose Init() failed, is called any more
void CControllableEntity::DropController() {
  ++m_numControllers;
  m_actuators.clear();
  m_sensors.clear();
  m_mapActuators.clear();
  m_mapSensors.clear();
  m_pcController = nullptr;
  m_controller.reset();
  m_randomOwner.DestroyGenerators();
  m_setup = nullptr;
  m_isStopped = false;
  m_haveDevicesFailed = false;
}

// birth of the random generators that are created now
UInt64 CControllableEntity::GetBirth() const {
  return m_context.Loading.IsLoading() ? CRandom::COwner::CScope::kLoading : m_context.GetClock();
}

void CControllableEntity::CreateActuators(TConfigurationNode& controllerNode, CLoadErrors& errors) {
  MakeDevices<CSimulatedActuator, CCI_Actuator>(
      controllerNode, "actuator", GetParent(), errors,
      [this](const std::string& tag, std::unique_ptr<CCI_Actuator> device) {
        m_pcController->AddActuator(tag, device.release());
      });
}

void CControllableEntity::CreateSensors(TConfigurationNode& controllerNode, CLoadErrors& errors) {
  MakeDevices<CSimulatedSensor, CCI_Sensor>(
      controllerNode, "sensor", GetParent(), errors,
      [this](const std::string& tag, std::unique_ptr<CCI_Sensor> device) {
        m_pcController->AddSensor(tag, device.release());
      });
}

// the lists have the order of the controller's maps, by tag; devices that the controller added
// itself are left out if they are not simulated
void CControllableEntity::ListDevices() {
  m_actuators.reserve(m_pcController->GetAllActuators().size());
  for (const auto& entry : m_pcController->GetAllActuators()) {
    if (auto* simulated = dynamic_cast<CSimulatedActuator*>(entry.second)) {
      m_actuators.push_back(simulated);
    }
  }
  m_sensors.reserve(m_pcController->GetAllSensors().size());
  for (const auto& entry : m_pcController->GetAllSensors()) {
    if (auto* simulated = dynamic_cast<CSimulatedSensor*>(entry.second)) {
      m_sensors.push_back({simulated, entry.second});
    }
  }
}

const std::map<std::string, CSimulatedActuator*>& CControllableEntity::GetActuators() const {
  if (m_mapActuators.empty() && m_pcController != nullptr) {
    for (const auto& entry : m_pcController->GetAllActuators()) {
      if (auto* simulated = dynamic_cast<CSimulatedActuator*>(entry.second)) {
        m_mapActuators[entry.first] = simulated;
      }
    }
  }
  return m_mapActuators;
}

const std::map<std::string, CSimulatedSensor*>& CControllableEntity::GetSensors() const {
  if (m_mapSensors.empty() && m_pcController != nullptr) {
    for (const auto& entry : m_pcController->GetAllSensors()) {
      if (auto* simulated = dynamic_cast<CSimulatedSensor*>(entry.second)) {
        m_mapSensors[entry.first] = simulated;
      }
    }
  }
  return m_mapSensors;
}

void CControllableEntity::Act() {
  if (m_haveDevicesFailed) {
    return;
  }
  for (CSimulatedActuator* actuator : m_actuators) {
    actuator->Update();
  }
}

void CControllableEntity::Sense() {
  m_vecCheckedRays.clear();
  m_vecIntersectionPoints.clear();
  if (m_haveDevicesFailed) {
    return;
  }
  for (const SSensorEntry& sensor : m_sensors) {
    if (sensor.Interface->IsSwitchedOn()) {
      sensor.Simulated->Update();
    }
  }
}

void CControllableEntity::ControlStep() {
  if (m_pcController != nullptr && !m_isStopped) {
    m_pcController->ControlStep();
  }
}

void CControllableEntity::AddCheckedRay(bool obstructed, const CRay3& ray) {
  m_vecCheckedRays.emplace_back(obstructed, ray);
}

void CControllableEntity::AddIntersectionPoint(const CRay3& ray, Real tOnRay) {
  CVector3 point;
  ray.GetPoint(point, tOnRay);
  m_vecIntersectionPoints.push_back(point);
}

void CControllableEntity::LoadEntityAhead() const {
  LoadAhead(this, 1);  // the pointer to its virtual functions
  const auto* const begin = reinterpret_cast<const char*>(&m_pcController);
  LoadAhead(begin, reinterpret_cast<const char*>(&m_vecIntersectionPoints + 1) - begin);
}

void CControllableEntity::LoadActuatorsAhead() const {
  for (const CSimulatedActuator* actuator : m_actuators) {
    LoadAhead(actuator, kActuatorBytes);
  }
}

void CControllableEntity::LoadSensorsAhead() const {
  for (const SSensorEntry& sensor : m_sensors) {
    LoadAhead(sensor.Simulated, kSensorBytes);
  }
}

void CControllableEntity::LoadControllerAhead() const {
  if (m_pcController != nullptr) {
    LoadAhead(m_pcController, 1);
    LoadAhead(m_pcController + 1, kControllerBytes);
  }
}

void CControllableEntity::ListMemory(std::vector<SMemory>& memory) const {
  for (const SSensorEntry& sensor : m_sensors) {
    sensor.Simulated->ListMemory(memory);
  }
}

}  // namespace argos
