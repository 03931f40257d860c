#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>

#include <cmath>

namespace argos {

namespace {

// @return the same direction in [0, 2 PI)
CRadians Normalize(CRadians angle) {
  angle.UnsignedNormalize();
  return angle < CRadians::TWO_PI ? angle : CRadians::ZERO;
}

}  // namespace

CFootBotDistanceScannerEquippedEntity::CFootBotDistanceScannerEquippedEntity(
    CComposableEntity* parent)
    : CFootBotDistanceScannerEquippedEntity(parent, std::string()) {}

CFootBotDistanceScannerEquippedEntity::CFootBotDistanceScannerEquippedEntity(
    CComposableEntity* parent, const std::string& id)
    : CEntity(parent, id), m_mount{footbot::kBodyRadius, footbot::kDistanceScannerElevation} {
  CEntity::SetEnabled(false);
}

void CFootBotDistanceScannerEquippedEntity::Reset() {
  CEntity::Reset();
  m_mode = MODE_OFF;
  m_rotation = m_current = m_previous = CRadians::ZERO;
  m_speed = 0.0;
  m_tick.Reset();
}

void CFootBotDistanceScannerEquippedEntity::Update() {
  if (!m_tick.IsNewTick()) {
    return;
  }
  if (m_mode == MODE_SPEED_CONTROL) {
    m_rotation = Normalize(m_rotation + CRadians(m_speed * m_tick.GetTickLength()));
  }
  m_previous = m_current;
  m_current = m_rotation;
}

void CFootBotDistanceScannerEquippedEntity::SetEnabled(bool enabled) {
  SetFollowerEnabled(*this, enabled);
}

void CFootBotDistanceScannerEquippedEntity::SetMode(UInt8 mode) {
  if (mode > MODE_SPEED_CONTROL) {
    THROW_ARGOSEXCEPTION("distance scanner \"" << GetContext() << GetId() << "\": there is no mode "
                                               << static_cast<int>(mode) << ", but modes 0 to 2");
  }
  m_mode = static_cast<EMode>(mode);
}

void CFootBotDistanceScannerEquippedEntity::SetRotation(const CRadians& rotation) {
  if (!std::isfinite(rotation.GetValue())) {
    THROW_ARGOSEXCEPTION("distance scanner \"" << GetContext() << GetId()
                                               << "\": the angle must be finite, got "
                                               << rotation.GetValue() << " rad");
  }
  m_rotation = Normalize(rotation);
}

void CFootBotDistanceScannerEquippedEntity::SetRotationSpeed(Real radiansPerSecond) {
  if (!std::isfinite(radiansPerSecond)) {
    THROW_ARGOSEXCEPTION("distance scanner \"" << GetContext() << GetId()
                                               << "\": the speed must be finite, got "
                                               << radiansPerSecond << " rad/s");
  }
  m_speed = radiansPerSecond;
}

void CFootBotDistanceScannerEquippedEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  digest.Add(static_cast<UInt32>(m_mode));
  digest.Add(m_rotation.GetValue());
  digest.Add(m_speed);
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CFootBotDistanceScannerEquippedEntity)

}  // namespace argos
