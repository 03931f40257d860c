#include <argos3/core/simulator/entity/controllable_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <exception>

namespace argos {

namespace {

// a <sensors> or <actuators> section, or null: it may be left out
TConfigurationNode* FindSection(TConfigurationNode& controllerNode, const std::string& tag) {
  return NodeExists(controllerNode, tag) ? &GetNode(controllerNode, tag) : nullptr;
}

// makes the device of one XML element, as its simulated side and as its interface
template <typename SIMULATED, typename INTERFACE>
std::pair<SIMULATED*, std::unique_ptr<INTERFACE>> CreateDevice(TConfigurationNode& node,
                                                               const char* kind) {
  std::string implementation;
  GetNodeAttribute(node, "implementation", implementation);
  const std::string label = node.Value() + " (" + implementation + ")";
  if (!CFactory<SIMULATED>::Exists(label)) {
    THROW_ARGOSEXCEPTION(node.GetLocation() << ": there is no " << kind << " \"" << label << "\""
                                            << DidYouMean(label, CFactory<SIMULATED>::GetLabels()));
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

[[noreturn]] void ThrowFromDestroy(const std::string& id, const std::exception_ptr& failure) {
  const std::string robot = "robot \"" + id + '"';
  try {
    std::rethrow_exception(failure);
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(robot << ": Destroy() of its controller or a device threw", error);
  } catch (...) {
    THROW_ARGOSEXCEPTION(robot << ": Destroy() of its controller or a device threw an exception "
                                  "that is not a std::exception");
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
  if (m_pcController == nullptr) {
    return;
  }
  const CRandom::COwner::CScope scope(&m_randomOwner, GetBirth());
  for (const auto& entry : m_pcController->GetAllSensors()) {
    entry.second->Reset();
  }
  for (const auto& entry : m_pcController->GetAllActuators()) {
    entry.second->Reset();
  }
  m_pcController->Reset();
}

void CControllableEntity::Destroy() {
  if (m_pcController == nullptr) {
    return;
  }
  const CRandom::COwner::CScope scope(&m_randomOwner, GetBirth());
  std::exception_ptr failure;
  const auto destroy = [&failure](auto& part) {
    try {
      part.Destroy();
    } catch (...) {
      failure = failure == nullptr ? std::current_exception() : failure;
    }
  };
  destroy(*m_pcController);
  for (const auto& entry : m_pcController->GetAllSensors()) {
    destroy(*entry.second);
  }
  for (const auto& entry : m_pcController->GetAllActuators()) {
    destroy(*entry.second);
  }
  if (failure != nullptr) {
    ThrowFromDestroy(GetRootEntity().GetId(), failure);
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
  TConfigurationNode& node = m_context.Loading.GetController(controllerId);
  if (m_context.Loading.IsProbing()) {
    return;
  }
  const std::string robot = GetRootEntity().GetId();
  Destroy();
  DropController();
  m_randomOwner.SetId(GetContext() + GetId());
  const CRandom::COwner::CScope scope(&m_randomOwner, GetBirth());
  try {
    m_controller.reset(CFactory<CCI_Controller>::New(node.Value()));
    m_pcController = m_controller.get();
    m_pcController->SetId(robot);
    CLoadErrors errors;
    CreateActuators(node, errors);
    CreateSensors(node, errors);
    errors.ThrowIfFailed("errors in its devices");
    m_pcController->Init(params);
    // afterwards, because controllers may add devices of their own, or replace some
    ListDevices();
    if (GetIndex() >= 0) {
      GetRootEntity().MarkStart();
    }
  } catch (const CAlreadyReported&) {
    throw;
  } catch (std::exception& error) {
    m_context.Loading.MarkBroken(controllerId);
    DropController();
    THROW_ARGOSEXCEPTION_NESTED("robot \"" << robot << "\": its controller \"" << controllerId
                                           << "\" (" << node.GetLocation() << ": <" << node.Value()
                                           << ">) cannot be set up",
                                error);
  }
}

// no function of a controller that was replaced, or whose Init() failed, is called any more
void CControllableEntity::DropController() {
  m_actuators.clear();
  m_sensors.clear();
  m_mapActuators.clear();
  m_mapSensors.clear();
  m_pcController = nullptr;
  m_controller.reset();
  m_randomOwner.DestroyGenerators();
}

// of the random generators that are created now
UInt64 CControllableEntity::GetBirth() const {
  return m_context.Loading.IsLoading() ? CRandom::COwner::CScope::kLoading : m_context.GetClock();
}

void CControllableEntity::CreateActuators(TConfigurationNode& controllerNode, CLoadErrors& errors) {
  TConfigurationNode* section = FindSection(controllerNode, "actuators");
  if (section == nullptr) {
    return;
  }
  TConfigurationNodeIterator it;
  for (it = it.begin(section); it != it.end(); ++it) {
    errors.Try("", [&] {
      auto [simulated, interface] = CreateDevice<CSimulatedActuator, CCI_Actuator>(*it, "actuator");
      AttachToRobot(*simulated, GetParent(), *it, "actuator");
      interface->Init(*it);
      m_pcController->AddActuator(it->Value(), interface.release());
    });
  }
}

void CControllableEntity::CreateSensors(TConfigurationNode& controllerNode, CLoadErrors& errors) {
  TConfigurationNode* section = FindSection(controllerNode, "sensors");
  if (section == nullptr) {
    return;
  }
  TConfigurationNodeIterator it;
  for (it = it.begin(section); it != it.end(); ++it) {
    errors.Try("", [&] {
      auto [simulated, interface] = CreateDevice<CSimulatedSensor, CCI_Sensor>(*it, "sensor");
      AttachToRobot(*simulated, GetParent(), *it, "sensor");
      interface->Init(*it);
      m_pcController->AddSensor(it->Value(), interface.release());
    });
  }
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
  for (CSimulatedActuator* actuator : m_actuators) {
    actuator->Update();
  }
}

void CControllableEntity::Sense() {
  m_vecCheckedRays.clear();
  m_vecIntersectionPoints.clear();
  for (const SSensorEntry& sensor : m_sensors) {
    if (sensor.Interface->IsSwitchedOn()) {
      sensor.Simulated->Update();
    }
  }
}

void CControllableEntity::ControlStep() {
  if (m_pcController != nullptr) {
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

}  // namespace argos
