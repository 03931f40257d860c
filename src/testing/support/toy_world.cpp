#include <argos3/testing/support/toy_world.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/math/random_stream.h>

#include <optional>

namespace argos {

namespace {

template <typename COMPONENT, typename... ARGUMENTS>
COMPONENT* NewComponent(CComposableEntity& parent, ARGUMENTS&&... arguments) {
  auto component = std::make_unique<COMPONENT>(&parent, std::forward<ARGUMENTS>(arguments)...);
  COMPONENT* const borrowed = component.get();
  parent.AddComponent(*component.release());
  return borrowed;
}

void RecordIn(CSimulator& simulator, const std::string& event) {
  if (auto* functions = dynamic_cast<CToyLoopFunctions*>(&simulator.GetLoopFunctions())) {
    functions->Record(event);
  }
}

}  // namespace

// entities

void CToyMotorEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(Velocity.GetX());
  digest.Add(Velocity.GetY());
  digest.Add(Velocity.GetZ());
}

CToyRobotEntity::CToyRobotEntity() : CComposableEntity(nullptr) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0");
  m_motor = NewComponent<CToyMotorEntity>(*this);
  m_controller = NewComponent<CControllableEntity>(*this, "controller_0");
  Describe();
}

CToyRobotEntity::CToyRobotEntity(const std::string& id, const std::string& controllerId,
                                 const CVector3& position, const CQuaternion& orientation)
    : CComposableEntity(nullptr, id) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0", position, orientation);
  m_motor = NewComponent<CToyMotorEntity>(*this);
  m_controller = NewComponent<CControllableEntity>(*this, "controller_0");
  Describe();
  m_controller->SetController(controllerId);
}

void CToyRobotEntity::Init(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  m_body->Init(GetNode(tree, "body"));
  m_controller->Init(GetNode(tree, "controller"));
}

void CToyRobotEntity::Describe() {
  static const std::shared_ptr<const SBodyDescription> description = [] {
    auto made = std::make_shared<SBodyDescription>();
    made->Shapes.push_back(SShapeDescription::Cylinder(kRadius, kHeight));
    made->Mass = 1.0;
    return made;
  }();
  m_body->SetBodyDescription(description);
  m_body->AddAnchor("top", CVector3(0.0, 0.0, kHeight));
}

CToyBlockEntity::CToyBlockEntity() : CComposableEntity(nullptr) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0");
}

CToyBlockEntity::CToyBlockEntity(const std::string& id, const CVector3& position,
                                 const CVector3& size, bool movable)
    : CComposableEntity(nullptr, id) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0", position, CQuaternion(), movable);
  Describe(size);
}

void CToyBlockEntity::Init(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  CVector3 size;
  bool movable = false;
  GetNodeAttribute(tree, "size", size);
  GetNodeAttribute(tree, "movable", movable);
  m_body->Init(GetNode(tree, "body"));
  m_body->SetMovable(movable);
  Describe(size);
}

void CToyBlockEntity::Describe(const CVector3& size) {
  auto description = std::make_shared<SBodyDescription>();
  description->Shapes.push_back(SShapeDescription::Box(size));
  description->Mass = 1.0;
  m_body->SetBodyDescription(std::move(description));
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CToyMotorEntity)
REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CToyLampEntity)
REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CToyRobotEntity)
REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CToyBlockEntity)
REGISTER_ENTITY(CToyRobotEntity, "toy-robot", "", "", "A robot for tests.", "", "")
REGISTER_ENTITY(CToyBlockEntity, "toy-block", "", "", "A box for tests.", "", "")
REGISTER_ENTITY(CToyLampEntity, "toy-lamp", "", "", "A place for tests.", "", "")

// devices

class CToyDriveActuator : public CSimulatedActuator, public CCI_ToyDriveActuator {
 public:
  void SetRobot(CComposableEntity& robot) override {
    m_motor = &robot.GetComponent<CToyMotorEntity>("toy_motor");
  }
  void SetVelocity(const CVector3& velocity) override { m_velocity = velocity; }
  void Update() override { m_motor->Velocity = m_velocity; }
  void Reset() override { m_velocity = CVector3(); }

 private:
  CToyMotorEntity* m_motor = nullptr;
  CVector3 m_velocity;
};

class CToyRangeSensor : public CSimulatedSensor, public CCI_ToyRangeSensor {
 public:
  void SetRobot(CComposableEntity& robot) override {
    m_body = &robot.GetComponent<CEmbodiedEntity>("body");
    m_robot = &robot.GetComponent<CControllableEntity>("controller");
  }
  void Init(TConfigurationNode& tree) override {
    CCI_ToyRangeSensor::Init(tree);
    GetNodeAttributeOrDefault(tree, "noise", m_noise, m_noise);
    Seed();
    Enable();
  }
  void Update() override {
    const SAnchor& origin = m_body->GetOriginAnchor();
    CVector3 rim(CToyRobotEntity::kRadius, 0.0, 0.5 * CToyRobotEntity::kHeight);
    CVector3 ahead(CVector3::X);
    rim.Rotate(origin.Orientation);
    ahead.Rotate(origin.Orientation);
    const CRay3 ray(origin.Position + rim, origin.Position + rim + ahead);
    SEmbodiedEntityIntersectionItem item;
    const CBodyIndex& index = m_robot->GetSpace().GetBodyIndex();
    m_range = index.FindClosestHit(item, ray, m_body) ? item.TOnRay : 1.0;
    m_range += m_noise > 0.0 ? m_stream->Uniform(-m_noise, m_noise) : 0.0;
  }
  void Reset() override {
    m_range = 1.0;
    Seed();
  }

 private:
  void Seed() {
    m_stream.emplace(m_robot->GetSimulator().GetRandomSeed(), "argos",
                     m_robot->GetRootEntity().GetId(), "toy_range noise");
  }
  CEmbodiedEntity* m_body = nullptr;
  CControllableEntity* m_robot = nullptr;
  Real m_noise = 0.0;
  std::optional<CRandomStream> m_stream;
};

REGISTER_ACTUATOR(CToyDriveActuator, "toy_drive", "default", "", "", "", "", "")
REGISTER_SENSOR(CToyRangeSensor, "toy_range", "default", "", "", "", "", "")

// controller and loop functions

std::atomic<int> CToyController::NumInits{0};
std::atomic<int> CToyController::NumAlive{0};

CToyController::CToyController() {
  ++NumAlive;
}

CToyController::~CToyController() {
  --NumAlive;
}

void CToyController::Init(TConfigurationNode& params) {
  ++NumInits;
  GetNodeAttributeOrDefault(params, "velocity", Velocity, Velocity);
  bool fails = false;
  GetNodeAttributeOrDefault(params, "fails", fails, fails);
  if (fails) {
    THROW_ARGOSEXCEPTION("told to fail");
  }
  if (HasActuator("toy_drive")) {
    m_drive = GetActuator<CCI_ToyDriveActuator>("toy_drive");
  }
  if (HasSensor("toy_range")) {
    m_range = GetSensor<CCI_ToyRangeSensor>("toy_range");
  }
  Record("init");
}

void CToyController::ControlStep() {
  ++Steps;
  Record("control");
  if (m_range != nullptr) {
    LastRange = m_range->GetRange();
  }
  if (OnStep) {
    OnStep(*this);
  }
  if (m_drive != nullptr) {
    m_drive->SetVelocity(Velocity);
  }
}

void CToyController::Reset() {
  Steps = 0;
  Record("controller reset");
}

void CToyController::Destroy() {
  Record("controller destroy");
  if (ThrowsInDestroy) {
    THROW_ARGOSEXCEPTION("the controller of " << GetId() << " cannot be destroyed");
  }
}

void CToyController::Record(const std::string& event) {
  RecordIn(CSimulator::GetInstance(), event + " " + GetId());
}

REGISTER_CONTROLLER(CToyController, "toy_controller")

void CToyLoopFunctions::Init(TConfigurationNode& node) {
  GetNodeAttributeOrDefault(node, "record", IsRecording, IsRecording);
  bool fails = false;
  GetNodeAttributeOrDefault(node, "fails", fails, fails);
  if (fails) {
    THROW_ARGOSEXCEPTION("told to fail");
  }
  Record("loop functions init");
}

void CToyLoopFunctions::PreStep() {
  Record("pre step");
  if (OnPreStep) {
    OnPreStep();
  }
}

void CToyLoopFunctions::PostStep() {
  Record("post step");
  if (OnPostStep) {
    OnPostStep();
  }
}

void CToyLoopFunctions::Record(const std::string& event) {
  if (IsRecording) {
    Events.push_back(event);
  }
}

REGISTER_LOOP_FUNCTIONS(CToyLoopFunctions, "toy_loop_functions")

// engine and medium

class CToyEngine::CModel : public CPhysicsModel {
 public:
  CModel(CToyEngine& engine, CEmbodiedEntity& body, CToyMotorEntity* motor)
      : CPhysicsModel(engine, body), m_motor(motor) {
    CModel::CalculateBoundingBox();
    CalculateAnchors();
  }

  void UpdateFromEntityStatus() override {}
  void Step(Real seconds) {
    if (m_motor != nullptr) {
      SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
      m_cEmbodiedEntity.SetOriginPose(origin.Position + m_motor->Velocity * seconds,
                                      origin.Orientation);
    }
  }
  void MoveTo(const CVector3& position, const CQuaternion& orientation) override {
    m_cEmbodiedEntity.SetOriginPose(position, orientation);
    CalculateAnchors();
    CalculateBoundingBox();
  }
  void CalculateBoundingBox() override {
    const CVector3& position = m_cEmbodiedEntity.GetOriginAnchor().Position;
    const Real radius = m_cEmbodiedEntity.GetBodyDescription()->ComputeBoundingRadius();
    const CVector3 half(radius, radius, 0.0);
    m_sBoundingBox.MinCorner = position - half;
    m_sBoundingBox.MaxCorner =
        position + half +
        CVector3(0.0, 0.0, m_cEmbodiedEntity.GetBodyDescription()->Shapes.front().Size.GetZ());
  }
  bool IsCollidingWithSomething() const override {
    const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
    return m_cEngine.GetSpace().GetBodyIndex().FindOverlap(
               *m_cEmbodiedEntity.GetBodyDescription(), origin.Position, origin.Orientation,
               m_cEmbodiedEntity.GetBodyNumber()) != CBodyIndex::kNoBody;
  }

 private:
  CToyMotorEntity* m_motor;
};

CToyEngine::CToyEngine() = default;

CToyEngine::~CToyEngine() = default;

void CToyEngine::Init(TConfigurationNode& tree) {
  CPhysicsEngine::Init(tree);
  GetNodeAttributeOrDefault(tree, "refuses", m_refuses, m_refuses);
}

void CToyEngine::Reset() {
  for (const auto& model : m_models) {
    const SAnchor& origin = model->GetEmbodiedEntity().GetOriginAnchor();
    model->MoveTo(origin.Position, origin.Orientation);
  }
}

void CToyEngine::Update() {
  RecordIn(m_cSimulator, "physics " + GetId());
  for (const auto& model : m_models) {
    for (UInt32 i = 0; i < GetIterations(); ++i) {
      model->Step(GetPhysicsClockTick());
    }
    model->UpdateEntityStatus();
  }
}

size_t CToyEngine::GetNumPhysicsModels() {
  return m_models.size();
}

bool CToyEngine::AddEntity(CEntity& entity) {
  if (entity.GetTypeDescription() == m_refuses) {
    return false;
  }
  auto& root = dynamic_cast<CComposableEntity&>(entity);
  CToyMotorEntity* const motor =
      root.HasComponent("toy_motor") ? &root.GetComponent<CToyMotorEntity>("toy_motor") : nullptr;
  auto& body = root.GetComponent<CEmbodiedEntity>("body");
  m_models.push_back(std::make_unique<CModel>(*this, body, motor));
  body.AddPhysicsModel(GetId(), *m_models.back());
  return true;
}

bool CToyEngine::RemoveEntity(CEntity& entity) {
  for (auto model = m_models.begin(); model != m_models.end(); ++model) {
    if (&(*model)->GetEmbodiedEntity().GetRootEntity() == &entity) {
      (*model)->GetEmbodiedEntity().RemovePhysicsModel(GetId());
      m_models.erase(model);
      return true;
    }
  }
  return false;
}

void CToyMedium::Update() {
  RecordIn(m_cSimulator, "medium " + GetId());
}

REGISTER_PHYSICS_ENGINE(CToyEngine, "toy_engine", "", "", "An engine for tests.", "", "")
REGISTER_MEDIUM(CToyMedium, "toy_medium", "", "", "A medium for tests.", "", "")

}  // namespace argos
