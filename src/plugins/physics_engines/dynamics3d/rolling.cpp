#include <argos3/plugins/simulator/physics_engines/dynamics3d/rolling.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

// half the distance between the wheels, m
Real GetArm(const SRigidBody& robot) {
  return 0.5 * robot.Source.Description->Drive->InterwheelDistance;
}

// the offset of the centre of mass from the origin, world frame, without its height, m
CVector3 GetCentreAcross(const SRigidBody& robot, const SPlanarPose& pose) {
  return Rotated(CVector3(robot.CentreOfMass.GetX(), robot.CentreOfMass.GetY(), 0.0),
                 CQuaternion(pose.HalfCos, 0.0, 0.0, pose.HalfSin));
}

// the wheels' share of the weight times the friction, N
Real ComputeGrip(const SRigidBody& robot, const SRollGround& ground) {
  return kWheelLoad * robot.Source.Description->Mass * ground.Gravity * robot.Friction *
         ground.Friction;
}

// The change of the speeds of both wheels (left, right) within the limits of their forces. The
// masses are those that wheels feel at their rims: of the robot's motion ahead, of its rotation,
// and of their own spin.
std::array<Real, 2> LimitChange(const SRigidBody& robot, const std::array<Real, 2>& wanted,
                                const SRollGround& ground, Real substep) {
  const SBodyDescription& description = *robot.Source.Description;
  const SDifferentialDriveDescription& drive = *description.Drive;
  const Real arm = GetArm(robot);
  const Real spin = 0.5 * kWheelMassShare * description.Mass;
  const Real ahead = 0.25 * description.Mass;
  const Real turn = 0.25 * description.GetPlanarInertia() / (arm * arm);
  const Real own = ahead + turn + spin;
  const Real other = ahead - turn;
  const Real motor = std::min(0.5 * drive.MaxForce, drive.MaxTorque / drive.InterwheelDistance);
  const Real most = std::min(motor, 0.5 * ComputeGrip(robot, ground)) * substep;  // N s
  std::array<Real, 2> impulse = {own * wanted[0] + other * wanted[1],
                                 own * wanted[1] + other * wanted[0]};
  if (std::max(std::abs(impulse[0]), std::abs(impulse[1])) <= most) {
    return wanted;
  }
  // the wheel that needs more has its greatest force; the other reaches its speed if it can
  const size_t worse = std::abs(impulse[0]) >= std::abs(impulse[1]) ? 0 : 1;
  const size_t better = 1 - worse;
  const Real determinant = own * own - other * other;
  impulse[worse] = std::clamp(impulse[worse], -most, most);
  impulse[better] =
      std::clamp((wanted[better] * determinant + other * impulse[worse]) / own, -most, most);
  return {(own * impulse[0] - other * impulse[1]) / determinant,
          (own * impulse[1] - other * impulse[0]) / determinant};
}

SDriveCommand AccelerateWheels(const SRigidBody& robot, const SDriveCommand& motion,
                               const SDriveCommand& command, const SRollGround& ground,
                               Real substep) {
  const Real arm = GetArm(robot);
  const std::array<Real, 2> now = {motion.Ahead - arm * motion.YawRate,
                                   motion.Ahead + arm * motion.YawRate};
  const std::array<Real, 2> wanted = {command.Ahead - arm * command.YawRate - now[0],
                                      command.Ahead + arm * command.YawRate - now[1]};
  const std::array<Real, 2> change = LimitChange(robot, wanted, ground, substep);
  if (change == wanted) {
    return command;
  }
  const Real left = now[0] + change[0];
  const Real right = now[1] + change[1];
  return {0.5 * (left + right), 0.0, 0.5 * (right - left) / arm};
}

SDriveCommand AcceleratePlanar(const SRigidBody& robot, const SDriveCommand& motion,
                               const SDriveCommand& command, Real substep) {
  const SBodyDescription& description = *robot.Source.Description;
  const SPlanarDriveDescription& drive = *description.PlanarDrive;
  const Real ahead = command.Ahead - motion.Ahead;
  const Real left = command.Left - motion.Left;
  const Real change = std::hypot(ahead, left);
  const Real most = drive.MaxForce / description.Mass * substep;
  const Real share = change > most ? most / change : 1.0;
  const Real turn = command.YawRate - motion.YawRate;
  const Real mostTurn = drive.MaxTorque / description.GetPlanarInertia() * substep;
  if (share == 1.0 && std::abs(turn) <= mostTurn) {
    return command;
  }
  return {motion.Ahead + share * ahead, motion.Left + share * left,
          motion.YawRate + std::clamp(turn, -mostTurn, mostTurn)};
}

}  // namespace

SRigidPose GetRollPose(const SRollState& state) {
  return {CVector3(state.Pose.X, state.Pose.Y, state.Height),
          CQuaternion(state.Pose.HalfCos, 0.0, 0.0, state.Pose.HalfSin)};
}

SRigidMotion GetRollMotion(const SRigidBody& robot) {
  const SRollState& state = robot.Roll;
  SRigidMotion motion;
  motion.AngularVelocity.SetZ(state.Motion.YawRate);
  motion.Velocity = Rotated(CVector3(state.Motion.Ahead, state.Motion.Left, 0.0),
                            CQuaternion(state.Pose.HalfCos, 0.0, 0.0, state.Pose.HalfSin)) +
                    Cross(motion.AngularVelocity, GetCentreAcross(robot, state.Pose));
  if (robot.HasWheels()) {
    const Real turn = GetArm(robot) * state.Motion.YawRate;
    motion.WheelSpins = {(state.Motion.Ahead - turn) / robot.WheelRadius,
                         (state.Motion.Ahead + turn) / robot.WheelRadius};
  }
  return motion;
}

SRollState ReadRollState(const SRigidBody& robot) {
  const SRigidPose pose = GetRigidPose(robot);
  SRollState state;
  state.Pose = MakePlanarPose(pose.Position, pose.Orientation);
  state.Height = pose.Position.GetZ();
  state.Motion.YawRate = dBodyGetAngularVel(robot.Body)[2];
  const CVector3 velocity =
      FromODE(dBodyGetLinearVel(robot.Body)) -
      Cross(CVector3(0.0, 0.0, state.Motion.YawRate), GetCentreAcross(robot, state.Pose));
  const SPlanarPose& at = state.Pose;
  const Real cosine = at.HalfCos * at.HalfCos - at.HalfSin * at.HalfSin;
  const Real sine = 2.0 * at.HalfCos * at.HalfSin;
  state.Motion.Ahead = cosine * velocity.GetX() + sine * velocity.GetY();
  // wheels do not slide sideways
  state.Motion.Left = robot.HasWheels() ? 0.0 : cosine * velocity.GetY() - sine * velocity.GetX();
  return state;
}

bool RollsFreely(const SRigidBody& robot, const SRollState& state, const SRollGround& ground) {
  if (std::abs(state.Height - ground.Height) > kFreeHeight) {
    return false;
  }
  // the sine of half the lean
  const dReal* const orientation = dBodyGetQuaternion(robot.Body);
  if (std::hypot(orientation[1], orientation[2]) > 0.5 * kFreeLean) {
    return false;
  }
  // pushed between ticks
  if (FromODE(dBodyGetForce(robot.Body)) != CVector3() ||
      FromODE(dBodyGetTorque(robot.Body)) != CVector3()) {
    return false;
  }
  const dReal* const turn = dBodyGetAngularVel(robot.Body);
  if (std::hypot(turn[0], turn[1]) > kFreeTurn) {
    return false;
  }
  const SPlanarPose& at = state.Pose;
  const CVector3 expected =
      Rotated(CVector3(state.Motion.Ahead, state.Motion.Left, 0.0),
              CQuaternion(at.HalfCos, 0.0, 0.0, at.HalfSin)) +
      Cross(CVector3(0.0, 0.0, state.Motion.YawRate), GetCentreAcross(robot, at));
  if ((FromODE(dBodyGetLinearVel(robot.Body)) - expected).Length() > kFreeSpeed) {
    return false;
  }
  for (size_t i = 0; robot.HasWheels() && i < robot.Wheels.size(); ++i) {
    const Real turns = (i == 0 ? -1.0 : 1.0) * GetArm(robot) * state.Motion.YawRate;
    const Real rim = dJointGetHingeAngleRate(robot.Axles[i]) * robot.WheelRadius;
    if (std::abs(rim - state.Motion.Ahead - turns) > kFreeSpeed) {
      return false;
    }
  }
  return true;
}

bool HoldsArc(const SRigidBody& robot, const SDriveCommand& command, const SRollGround& ground) {
  const SBodyDescription& description = *robot.Source.Description;
  const Real limit =
      robot.HasWheels() ? ComputeGrip(robot, ground) : description.PlanarDrive->MaxForce;
  const Real turn = std::abs(command.YawRate);
  const Real offset = std::hypot(robot.CentreOfMass.GetX(), robot.CentreOfMass.GetY());
  const Real speed = command.ComputeSpeed() + offset * turn;
  return limit > 0.0 && speed * turn * description.Mass <= kFreeGrip * limit;
}

SRollState Roll(const SRigidBody& robot, SRollState state, const SDriveCommand& command,
                const SRollGround& ground, Real substep, UInt32 substeps) {
  UInt32 done = 0;
  for (; done < substeps && !(state.Motion == command); ++done) {
    state.Motion = robot.HasWheels()
                       ? AccelerateWheels(robot, state.Motion, command, ground, substep)
                       : AcceleratePlanar(robot, state.Motion, command, substep);
    if (state.Motion == command) {
      break;
    }
    state.Pose = FollowArc(state.Pose, state.Motion, substep).End;
  }
  if (done < substeps) {
    state.Pose = FollowArc(state.Pose, command, substep * (substeps - done)).End;
  }
  return state;
}

}  // namespace argos
