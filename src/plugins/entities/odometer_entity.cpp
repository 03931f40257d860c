#include <argos3/plugins/simulator/entities/odometer_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <algorithm>
#include <cmath>

namespace argos {

COdometerEntity::COdometerEntity(CComposableEntity* parent, const std::string& id)
    : CEntity(parent, id),
      m_wheels(&parent->GetComponent<CWheeledEntity>("wheels")),
      m_distances(m_wheels->GetNumWheels(), 0.0) {
  m_motion.SetBody(parent->GetComponent<CEmbodiedEntity>("body"));
  CEntity::SetEnabled(false);
}

void COdometerEntity::Reset() {
  CEntity::Reset();
  std::fill(m_distances.begin(), m_distances.end(), 0.0);
  m_motion.RememberStart();
  m_tick.Reset();
}

void COdometerEntity::Update() {
  if (m_tick.IsNewTick()) {
    Measure();
  }
  m_motion.Remember();
}

void COdometerEntity::SetEnabled(bool enabled) {
  SetFollowerEnabled(*this, enabled);
}

// A body that turns by the angle a at constant speeds moves its origin along a chord, in the
// direction of its heading half-way; the chord is sin(a/2) / (a/2) times as long as the path.
void COdometerEntity::Measure() {
  const CVector3 step = m_motion.ComputeStep();
  const CQuaternion turn = m_motion.ComputeTurn();
  const Real halfAngle =
      0.5 * std::remainder(2.0 * std::atan2(turn.GetZ(), turn.GetW()), 2.0 * ARGOS_PI);
  const Real sine = std::sin(halfAngle);
  const Real chord = step.GetX() * std::cos(halfAngle) + step.GetY() * sine;
  const Real way = halfAngle == 0.0 ? chord : chord * halfAngle / sine;
  const CVector3* const wheels = m_wheels->GetWheelPositions();
  for (size_t i = 0; i < m_distances.size(); ++i) {
    m_distances[i] = way - 2.0 * halfAngle * wheels[i].GetY();
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(COdometerEntity)

}  // namespace argos
