#include <argos3/plugins/simulator/entities/odometer_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <algorithm>

namespace argos {

COdometerEntity::COdometerEntity(CComposableEntity* parent, const std::string& id)
    : CEntity(parent, id),
      m_wheels(&parent->GetComponent<CWheeledEntity>("wheels")),
      m_distances(m_wheels->GetNumWheels(), 0.0),
      m_lastGround(m_wheels->GetNumWheels(), 0.0),
      m_lastOrdered(m_wheels->GetNumWheels(), 0.0) {
  m_motion.SetBody(parent->GetComponent<CEmbodiedEntity>("body"));
  CEntity::SetEnabled(false);
}

void COdometerEntity::Reset() {
  CEntity::Reset();
  std::fill(m_distances.begin(), m_distances.end(), 0.0);
  std::fill(m_lastGround.begin(), m_lastGround.end(), 0.0);
  std::fill(m_lastOrdered.begin(), m_lastOrdered.end(), 0.0);
  m_motion.RememberStart();
  m_tick.Reset();
  m_lastCommand = SDriveCommand();
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

SDriveCommand COdometerEntity::ReadCommand() const {
  const Real* const speeds = m_wheels->GetWheelVelocities();
  const CVector3* const wheels = m_wheels->GetWheelPositions();
  if (m_wheels->GetNumWheels() != 2 || !(wheels[0].GetY() > wheels[1].GetY())) {
    return {};
  }
  return {0.5 * (speeds[0] + speeds[1]), 0.0,
          (speeds[1] - speeds[0]) / (wheels[0].GetY() - wheels[1].GetY())};
}

// ComputeArcLength() applies to the difference between the body's step and that of the arcs that
// its drive commands.
void COdometerEntity::Measure() {
  const SDriveCommand command = ReadCommand();
  const CEmbodiedEntity& body = m_motion.GetBody();
  const Real lag = body.GetPhysicsModelsNum() > 0
                       ? body.GetPhysicsModel(size_t(0)).GetEngine().GetVelocityLag()
                       : 0.0;
  const Real tick = m_tick.GetTickLength();
  const SArc arcs = FollowArcs(SPlanarPose(), m_lastCommand, command, tick, lag);
  const Real commandedWay = (command.Ahead + lag * (m_lastCommand.Ahead - command.Ahead)) * tick;
  m_lastCommand = command;

  const CVector3 step = m_motion.ComputeStep();
  const Real halfAngle = ComputeHalfAngle(m_motion.ComputeTurn());
  const Real way =
      commandedWay + ComputeArcLength(step.GetX() - arcs.DX, step.GetY() - arcs.DY, halfAngle);
  const CVector3* const wheels = m_wheels->GetWheelPositions();
  for (size_t i = 0; i < m_distances.size(); ++i) {
    m_distances[i] = way - 2.0 * halfAngle * wheels[i].GetY();
  }
  if (m_wheels->CanDrift()) {
    SubtractDrift(lag);
  }
}

// a velocity lag leaves a part of the last tick's speeds in this one
void COdometerEntity::SubtractDrift(Real lag) {
  const Real* const ground = m_wheels->GetWheelVelocities();
  const Real* const ordered = m_wheels->GetOrderedVelocities();
  for (size_t i = 0; i < m_distances.size(); ++i) {
    const Real rolled = (ground[i] + lag * (m_lastGround[i] - ground[i])) * m_tick.GetTickLength();
    const Real turned =
        (ordered[i] + lag * (m_lastOrdered[i] - ordered[i])) * m_tick.GetTickLength();
    m_lastGround[i] = ground[i];
    m_lastOrdered[i] = ordered[i];
    if (rolled != 0.0) {
      m_distances[i] -= (rolled - turned) * std::clamp(m_distances[i] / rolled, 0.0, 1.0);
    }
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(COdometerEntity)

}  // namespace argos
