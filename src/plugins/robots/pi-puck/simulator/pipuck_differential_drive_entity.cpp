#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_measures.h>

#include <cmath>

namespace argos {

CPiPuckDifferentialDriveEntity::CPiPuckDifferentialDriveEntity(CComposableEntity* parent)
    : CPiPuckDifferentialDriveEntity(parent, "differential_drive_0") {}

CPiPuckDifferentialDriveEntity::CPiPuckDifferentialDriveEntity(CComposableEntity* parent,
                                                               const std::string& id)
    : CWheeledEntity(parent, id, NUM_WHEELS) {
  const Real y = 0.5 * pipuck::kInterwheelDistance;
  SetWheel(LEFT, CVector3(0.0, y, 0.0), pipuck::kWheelRadius);
  SetWheel(RIGHT, CVector3(0.0, -y, 0.0), pipuck::kWheelRadius);
  m_motion.SetBody(parent->GetComponent<CEmbodiedEntity>("body"));
}

void CPiPuckDifferentialDriveEntity::Reset() {
  CWheeledEntity::Reset();
  m_velocities[LEFT] = 0.0;
  m_velocities[RIGHT] = 0.0;
  m_motion.RememberStart();
  m_tick.Reset();
}

void CPiPuckDifferentialDriveEntity::SetTarget(EWheel wheel, Real velocity) {
  Real velocities[] = {GetTargetVelocityLeft(), GetTargetVelocityRight()};
  velocities[wheel] = velocity;
  SetVelocities(velocities);
}

// A body that turns by the angle a at constant speeds moves along a chord in the direction of its
// heading half-way; the chord is sin(a/2) / (a/2) times as long as the path.
void CPiPuckDifferentialDriveEntity::Update() {
  if (m_tick.IsNewTick()) {
    const CVector3 step = m_motion.ComputeStep();
    const CQuaternion turn = m_motion.ComputeTurn();
    const Real halfAngle =
        0.5 * std::remainder(2.0 * std::atan2(turn.GetZ(), turn.GetW()), 2.0 * ARGOS_PI);
    const Real sine = std::sin(halfAngle);
    const Real chord = step.GetX() * std::cos(halfAngle) + step.GetY() * sine;
    const Real way = halfAngle == 0.0 ? chord : chord * halfAngle / sine;
    const Real difference = halfAngle * pipuck::kInterwheelDistance;
    const Real tick = m_tick.GetTickLength();
    m_velocities[LEFT] = (way - difference) / tick;
    m_velocities[RIGHT] = (way + difference) / tick;
  }
  m_motion.Remember();
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CPiPuckDifferentialDriveEntity)

}  // namespace argos
