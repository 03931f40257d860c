#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_measures.h>

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

void CPiPuckDifferentialDriveEntity::Update() {
  if (m_tick.IsNewTick()) {
    const CVector3 step = m_motion.ComputeStep();
    const Real halfAngle = ComputeHalfAngle(m_motion.ComputeTurn());
    const Real way = ComputeArcLength(step.GetX(), step.GetY(), halfAngle);
    const Real difference = halfAngle * pipuck::kInterwheelDistance;
    const Real tick = m_tick.GetTickLength();
    m_velocities[LEFT] = (way - difference) / tick;
    m_velocities[RIGHT] = (way + difference) / tick;
  }
  m_motion.Remember();
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CPiPuckDifferentialDriveEntity)

}  // namespace argos
