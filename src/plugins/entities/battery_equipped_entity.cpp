#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

CBatteryEquippedEntity::CBatteryEquippedEntity(CComposableEntity* parent)
    : CBatteryEquippedEntity(parent, std::string()) {}

CBatteryEquippedEntity::CBatteryEquippedEntity(CComposableEntity* parent, const std::string& id,
                                               CBatteryDischargeModel* model, Real startCharge,
                                               Real fullCharge)
    : CEntity(parent, id), m_model(model) {
  SetFullCharge(fullCharge);
  SetAvailableCharge(startCharge);
  m_startCharge = startCharge;
  if (parent != nullptr && parent->HasComponent("body")) {
    m_motion.SetBody(parent->GetComponent<CEmbodiedEntity>("body"));
  }
  if (m_model != nullptr) {
    m_model->SetBattery(this);
  }
  CEntity::SetEnabled(false);
}

CBatteryEquippedEntity::CBatteryEquippedEntity(CComposableEntity* parent, const std::string& id,
                                               const std::string& model, Real startCharge,
                                               Real fullCharge)
    : CBatteryEquippedEntity(parent, id, nullptr, startCharge, fullCharge) {
  SetDischargeModel(model);
}

CBatteryEquippedEntity::~CBatteryEquippedEntity() = default;

void CBatteryEquippedEntity::Init(TConfigurationNode& tree) {
  CEntity::Init(tree);
  Configure(tree);
}

void CBatteryEquippedEntity::Configure(TConfigurationNode& battery) {
  CRobotsCode::CheckOwn(*this, "Configure()");
  const std::string owner = OwnerOf(battery);
  GetNodeAttributeOrDefault(battery, "start_charge", m_startCharge, m_startCharge);
  GetNodeAttributeOrDefault(battery, "full_charge", m_fullCharge, m_fullCharge);
  RequirePositive(m_fullCharge, owner, "full_charge");
  RequireNotNegative(m_startCharge, owner, "start_charge");
  if (m_startCharge > m_fullCharge) {
    THROW_ARGOSEXCEPTION(owner << ": start_charge must be at most full_charge (" << m_fullCharge
                               << "), got " << m_startCharge);
  }
  m_availableCharge = m_startCharge;
  std::string model = "time";
  GetNodeAttributeOrDefault(battery, "discharge_model", model, model);
  try {
    SetDischargeModel(model);
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(owner << ": invalid \"discharge_model\"", error);
  }
  if (m_model != nullptr) {
    m_model->Init(battery);
  }
}

void CBatteryEquippedEntity::Reset() {
  CEntity::Reset();
  m_availableCharge = m_startCharge;
  m_tick.Reset();
  if (m_motion.HasBody()) {
    m_motion.RememberStart();
  }
  if (m_model != nullptr) {
    m_model->Reset();
  }
}

void CBatteryEquippedEntity::SetEnabled(bool enabled) {
  SetFollowerEnabled(*this, enabled);
}

void CBatteryEquippedEntity::Update() {
  if (m_tick.IsNewTick() && m_model != nullptr) {
    (*m_model)();
  }
  if (m_motion.HasBody()) {
    m_motion.Remember();
  }
}

void CBatteryEquippedEntity::SetFullCharge(Real charge) {
  CRobotsCode::CheckOwn(*this, "SetFullCharge()");
  RequirePositive(charge, "battery \"" + GetContext() + GetId() + "\"", "full charge");
  KeepForReset(m_fullCharge);
  m_fullCharge = charge;
}

void CBatteryEquippedEntity::SetAvailableCharge(Real charge) {
  CRobotsCode::CheckOwn(*this, "SetAvailableCharge()");
  m_availableCharge =
      RequireNotNegative(charge, "battery \"" + GetContext() + GetId() + "\"", "charge");
}

void CBatteryEquippedEntity::Discharge(Real amount) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, "Discharge()");
  }
  m_availableCharge = std::max(0.0, m_availableCharge - amount);
}

void CBatteryEquippedEntity::SetDischargeModel(CBatteryDischargeModel* model) {
  CRobotsCode::CheckOwn(*this, "SetDischargeModel()");
  ReplaceModel(std::unique_ptr<CBatteryDischargeModel>(model));
  if (m_model != nullptr) {
    m_model->SetBattery(this);
  }
}

// the model of the start is kept for a reset
void CBatteryEquippedEntity::ReplaceModel(std::unique_ptr<CBatteryDischargeModel> model) {
  if (MustKeep(&m_model)) {
    // shared, because a std::function can be copied
    const auto start = std::make_shared<std::unique_ptr<CBatteryDischargeModel>>();
    KeepForReset(&m_model, [this, start] { m_model = std::move(*start); });
    *start = std::move(m_model);
  }
  m_model = std::move(model);
}

void CBatteryEquippedEntity::SetDischargeModel(const std::string& label) {
  CRobotsCode::CheckOwn(*this, "SetDischargeModel()");
  if (label.empty()) {
    ReplaceModel(nullptr);
    return;
  }
  if (!CFactory<CBatteryDischargeModel>::Exists(label)) {
    THROW_ARGOSEXCEPTION("there is no battery discharge model \""
                         << label << "\""
                         << DidYouMean(label, CFactory<CBatteryDischargeModel>::GetLabels()));
  }
  std::unique_ptr<CBatteryDischargeModel> model(CFactory<CBatteryDischargeModel>::New(label));
  SetDischargeModel(model.release());
}

void CBatteryEquippedEntity::RequireBody() const {
  if (!m_motion.HasBody()) {
    THROW_ARGOSEXCEPTION("battery \"" << GetContext() << GetId()
                                      << "\": its discharge model needs a robot with a body");
  }
}

Real CBatteryEquippedEntity::ComputeDistanceMoved() const {
  RequireBody();
  return m_motion.ComputeDistance();
}

CRadians CBatteryEquippedEntity::ComputeAngleTurned() const {
  RequireBody();
  const CQuaternion turn = m_motion.ComputeTurn();
  const Real sine = std::hypot(turn.GetX(), turn.GetY(), turn.GetZ());
  return CRadians(2.0 * std::atan2(sine, std::abs(turn.GetW())));
}

void CBatteryEquippedEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(m_availableCharge);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CBatteryEquippedEntity)

}  // namespace argos
