#include <argos3/plugins/simulator/physics_engines/pointmass3d/flyers.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/memory/room.h>
#include <argos3/plugins/simulator/entities/quadrotor_entity.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/flight_loop.h>

#include <algorithm>
#include <limits>

namespace argos {

namespace {

constexpr size_t kYaw = 3;
constexpr Real kTurn = 2.0 * ARGOS_PI;

// an angle in [0, 2 pi)
Real WrapTurn(Real angle) {
  const Real wrapped = CRadians(angle).UnsignedNormalize().GetValue();
  return wrapped < kTurn ? wrapped : 0.0;
}

// of a difference of two such angles, the same in (-pi, pi]
Real WrapDifference(Real angle) {
  const Real upper = angle > ARGOS_PI ? angle - kTurn : angle;
  return upper <= -ARGOS_PI ? upper + kTurn : upper;
}

}  // namespace

SPointMassHandle CFlyers::Add(const SSettings& settings, const SFlightPose& pose) {
  const UInt32 number = static_cast<UInt32>(m_robots.size());
  ReserveOneMore(m_blocks);
  ReserveOneMore(m_robots);
  const SPointMassHandle handle = {number, m_generations.Add()};
  if (number % kLanes == 0) {
    m_blocks.emplace_back();
  }
  const SBodyDescription& body = *settings.Body;
  const SPropellersDescription& propellers = *body.Propellers;
  const Real yawInertia = body.GetPlanarInertia();

  SRobot& robot = m_robots.emplace_back();
  robot.Owner = settings.Owner;
  robot.Quadrotor = settings.Quadrotor;
  robot.Position = propellers.Position;
  robot.Yaw = propellers.Yaw;
  robot.Velocity = propellers.Velocity;
  robot.YawRate = propellers.YawRate;
  robot.Mass = body.Mass;
  robot.YawInertia = yawInertia;
  robot.MaxSubstep = ComputeMaxFlightSubstep(body);

  const size_t lane = number % kLanes;
  for (size_t i = 0; i < kYaw; ++i) {
    SAxis& axis = GetAxis(number, i);
    axis.Lowest[lane] = settings.Lowest[i];
    axis.Highest[lane] = settings.Highest[i];
    axis.PerInertia[lane] = 1.0 / body.Mass;
    axis.MaxThrust[lane] = propellers.MaxForce;
    axis.Weight[lane] = i == 2 ? body.Mass * settings.Gravity : 0.0;
  }
  SAxis& yaw = GetAxis(number, kYaw);
  yaw.PerInertia[lane] = 1.0 / yawInertia;
  yaw.MaxThrust[lane] = propellers.MaxTorque;
  yaw.Weight[lane] = 0.0;
  Place(number, pose);
  return handle;
}

CPointMass3DBody* CFlyers::Remove(const SPointMassHandle& handle) {
  const UInt32 number = GetNumber(handle);
  const UInt32 last = static_cast<UInt32>(m_robots.size() - 1);
  CPointMass3DBody* moved = nullptr;
  if (number != last) {
    Copy(last, number);
    moved = m_robots[number].Owner;
  }
  m_generations.Remove(number);
  // unused lanes are computed, too, but never read
  m_robots.pop_back();
  if (last % kLanes == 0) {
    m_blocks.pop_back();
  }
  return moved;
}

void CFlyers::Copy(UInt32 from, UInt32 to) {
  m_robots[to] = m_robots[from];
  for (size_t i = 0; i <= kYaw; ++i) {
    const SAxis& source = GetAxis(from, i);
    SAxis& target = GetAxis(to, i);
    for (const auto lanes :
         {&SAxis::Place, &SAxis::Speed, &SAxis::Thrust, &SAxis::LastError, &SAxis::Lowest,
          &SAxis::Highest, &SAxis::PerInertia, &SAxis::MaxThrust, &SAxis::Weight}) {
      (target.*lanes)[to % kLanes] = (source.*lanes)[from % kLanes];
    }
  }
}

void CFlyers::Clear() {
  m_blocks.clear();
  m_robots.clear();
  m_generations.Clear();
}

void CFlyers::Place(UInt32 number, const SFlightPose& pose) {
  SFlightState state;
  for (size_t i = 0; i < kYaw; ++i) {
    state[i].Place = pose.Position[i];
  }
  state[kYaw].Place = WrapTurn(pose.Yaw);
  SetState(number, state);
}

SFlightPose CFlyers::GetPose(UInt32 number) const {
  const size_t lane = number % kLanes;
  const auto& axes = m_blocks[Checked(number) / kLanes].Axes;
  return {CVector3(axes[0].Place[lane], axes[1].Place[lane], axes[2].Place[lane]),
          axes[kYaw].Place[lane]};
}

SFlightState CFlyers::GetState(UInt32 number) const {
  const size_t lane = number % kLanes;
  SFlightState state;
  for (size_t i = 0; i <= kYaw; ++i) {
    const SAxis& axis = GetAxis(number, i);
    state[i] = {axis.Place[lane], axis.Speed[lane], axis.Thrust[lane], axis.LastError[lane]};
  }
  return state;
}

void CFlyers::SetState(UInt32 number, const SFlightState& state) {
  const size_t lane = number % kLanes;
  for (size_t i = 0; i <= kYaw; ++i) {
    SAxis& axis = GetAxis(number, i);
    axis.Place[lane] = state[i].Place;
    axis.Speed[lane] = state[i].Speed;
    axis.Thrust[lane] = state[i].Thrust;
    axis.LastError[lane] = state[i].LastError;
  }
}

Real CFlyers::ComputeMaxSubstep() const {
  Real longest = std::numeric_limits<Real>::infinity();
  for (const SRobot& robot : m_robots) {
    longest = std::min(longest, robot.MaxSubstep);
  }
  return longest;
}

// Reads the command of the robot for this tick.
template <EFlightLaw LAW>
void CFlyers::ReadCommand(UInt32 number, Real substep) {
  const SRobot& robot = m_robots[number];
  const size_t lane = number % kLanes;
  const auto order = [&](size_t i, Real target, bool onPlace, const SControlGains& gains) {
    SAxis& axis = GetAxis(number, i);
    axis.Target[lane] = target;
    axis.IsOnPlace[lane] = onPlace ? 1.0 : 0.0;
    if constexpr (LAW == EFlightLaw::Argos3) {
      axis.PerError[lane] = gains.Proportional;
      axis.PerChange[lane] = gains.Derivative * (1.0 / substep);
    } else {
      const Real inertia = i == kYaw ? robot.YawInertia : robot.Mass;
      const SSubstepGains chosen = onPlace ? ComputePositionGains(gains, inertia, substep)
                                           : ComputeSpeedGains(gains, inertia, substep);
      axis.PerError[lane] = chosen.Error;
      axis.PerChange[lane] = chosen.Speed;
    }
  };
  if (robot.Quadrotor->GetControlMethod() == CQuadRotorEntity::POSITION_CONTROL) {
    const auto& data = robot.Quadrotor->GetPositionControlData();
    for (size_t i = 0; i < kYaw; ++i) {
      order(i, data.Position[i] - m_origin[i], true, robot.Position);
    }
    order(kYaw, WrapTurn(data.Yaw.GetValue()), true, robot.Yaw);
  } else {
    const auto& data = robot.Quadrotor->GetSpeedControlData();
    for (size_t i = 0; i < kYaw; ++i) {
      order(i, data.Velocity[i], false, robot.Velocity);
    }
    order(kYaw, data.RotSpeed.GetValue(), false, robot.YawRate);
  }
}

void CFlyers::Advance(Real substep, UInt32 substeps) {
  if (m_law == EFlightLaw::Argos3) {
    AdvanceAll<EFlightLaw::Argos3>(substep, substeps);
  } else {
    AdvanceAll<EFlightLaw::Stable>(substep, substeps);
  }
}

template <EFlightLaw LAW>
void CFlyers::AdvanceAll(Real substep, UInt32 substeps) {
  const UInt32 count = static_cast<UInt32>(m_robots.size());
  for (UInt32 first = 0; first < count; first += kLanes) {
    const UInt32 end = std::min<UInt32>(first + kLanes, count);
    std::array<SFlightPose, kLanes> held;  // of the attached ones
    bool isAnyHeld = false;
    for (UInt32 number = first; number < end; ++number) {
      ReadCommand<LAW>(number, substep);
      if (m_robots[number].Quadrotor->IsAttached()) {
        held[number - first] = GetPose(number);
        isAnyHeld = true;
      }
    }
    SBlock& block = m_blocks[first / kLanes];
    for (size_t i = 0; i < kYaw; ++i) {
      AdvanceAxis<LAW, false>(block.Axes[i], substep, substeps);
    }
    AdvanceAxis<LAW, true>(block.Axes[kYaw], substep, substeps);
    for (UInt32 number = first; isAnyHeld && number < end; ++number) {
      if (m_robots[number].Quadrotor->IsAttached()) {
        Place(number, held[number - first]);
      }
    }
  }
}

template <EFlightLaw LAW, bool IS_ANGLE>
void CFlyers::AdvanceAxis(SAxis& axis, Real substep, UInt32 substeps) {
  for (UInt32 i = 0; i < substeps; ++i) {
    if constexpr (LAW == EFlightLaw::Argos3) {
      AdvanceAsArgos3<IS_ANGLE>(axis, substep);
    } else {
      AdvanceStably<IS_ANGLE>(axis, substep);
    }
  }
}

// A substep under a constant force.
template <bool IS_ANGLE>
void CFlyers::AdvanceStably(SAxis& axis, Real substep) {
  for (size_t lane = 0; lane < kLanes; ++lane) {
    const Real speed = axis.Speed[lane];
    const bool onPlace = axis.IsOnPlace[lane] != 0.0;
    Real error = axis.Target[lane] - (onPlace ? axis.Place[lane] : speed);
    if constexpr (IS_ANGLE) {
      error = onPlace ? WrapDifference(error) : error;
    }
    const Real weight = axis.Weight[lane];
    const Real force = ComputeThrust(axis.PerError[lane] * error - axis.PerChange[lane] * speed,
                                     weight, axis.MaxThrust[lane]) +
                       weight;
    Real newSpeed = speed + force * substep * axis.PerInertia[lane];
    Real place = axis.Place[lane] + 0.5 * (speed + newSpeed) * substep;
    if constexpr (!IS_ANGLE) {
      // a wall stops the motion into it
      const Real held = std::min(std::max(place, axis.Lowest[lane]), axis.Highest[lane]);
      newSpeed = held == place ? newSpeed : 0.0;
      place = held;
    }
    axis.Place[lane] = place;
    axis.Speed[lane] = newSpeed;
  }
  if constexpr (IS_ANGLE) {
    WrapPlaces(axis);
  }
}

// The speed changes the position, the thrust of the previous substep changes the speed, and the
// controller computes the thrust of the next one from the result.
template <bool IS_ANGLE>
void CFlyers::AdvanceAsArgos3(SAxis& axis, Real substep) {
  for (size_t lane = 0; lane < kLanes; ++lane) {
    Real place = axis.Place[lane] + axis.Speed[lane] * substep;
    if constexpr (!IS_ANGLE) {
      place = std::min(std::max(place, axis.Lowest[lane]), axis.Highest[lane]);
    }
    axis.Place[lane] = place;
    axis.Speed[lane] += axis.Thrust[lane] * substep * axis.PerInertia[lane];
  }
  if constexpr (IS_ANGLE) {
    WrapPlaces(axis);
  }
  for (size_t lane = 0; lane < kLanes; ++lane) {
    const bool onPlace = axis.IsOnPlace[lane] != 0.0;
    Real error = axis.Target[lane] - (onPlace ? axis.Place[lane] : axis.Speed[lane]);
    if constexpr (IS_ANGLE) {
      error = onPlace ? WrapDifference(error) : error;
    }
    const Real change = error - axis.LastError[lane];
    const Real weight = axis.Weight[lane];
    axis.Thrust[lane] = ComputeThrust(axis.PerError[lane] * error + axis.PerChange[lane] * change,
                                      weight, axis.MaxThrust[lane]) +
                        weight;
    axis.LastError[lane] = error;
  }
}

void CFlyers::WrapPlaces(SAxis& axis) {
  for (Real& place : axis.Place) {
    if (!(place >= 0.0 && place < kTurn)) {
      place = WrapTurn(place);
    }
  }
}

}  // namespace argos
