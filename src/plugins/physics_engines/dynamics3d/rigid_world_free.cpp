// The part of CRigidWorld that selects free robots and upright bodies.

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_world.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace argos {

namespace {

// free robots that a thread moves together
constexpr size_t kRollGrain = 128;

}  // namespace

// Robots may be free on the highest floor, if gravity is vertical and no ceiling is near.
void CRigidWorld::SetGround() {
  SRollGround ground{-HUGE_VAL, 0.0, -m_gravity.GetZ()};
  bool isRoofed = false;
  for (const SRigidBody* plane : m_planes) {
    isRoofed = isRoofed || plane->IsCeiling();
    if (!plane->IsCeiling() && plane->High.GetZ() > ground.Height) {
      ground.Height = plane->High.GetZ();
      ground.Friction = plane->Friction;
    }
  }
  const bool isDownward =
      m_gravity.GetX() == 0.0 && m_gravity.GetY() == 0.0 && ground.Gravity > 0.0;
  if (m_settings.FreeRobots && isDownward && !isRoofed && ground.Height > -HUGE_VAL) {
    m_free.SetGround(ground);
  } else {
    m_free.SetGround(std::nullopt);
  }
}

void CRigidWorld::TakeFromActive(const SRigidBody& body) {
  m_contacts->MarkChanged();
  const UInt32 number = body.PartsNumber;
  m_active[number] = m_active.back();
  m_active[number]->PartsNumber = number;
  m_active.pop_back();
}

// It keeps pose and motion.
void CRigidWorld::Activate(SRigidBody& body) {
  ARGOS_ASSERT(body.IsFree, "a rigid body is activated that is active already");
  const SRigidPose pose = GetRigidPose(body);
  const SRigidMotion motion = GetRigidMotion(body);
  body.IsFree = false;
  if (!m_spares.Take(body)) {
    BuildRigidBody(body, pose, m_settings, m_world);
  }
  PlaceRigidBody(body, pose, motion);
  body.Asleep = false;
  body.QuietTime = 0.0;
  UpdateBounds(body);
  m_contacts->MarkChanged();
  body.PartsNumber = static_cast<UInt32>(m_active.size());
  m_active.push_back(&body);
  body.IsUpright = false;
  body.ActiveNumber = static_cast<UInt32>(m_loose.size());
  m_loose.push_back(&body);
}

// Its state as a free robot is set.
void CRigidWorld::Deactivate(SRigidBody& body) {
  TakeFromActive(body);
  m_spares.Return(body, m_active.size() + kFewSpareParts);
  body.IsFree = true;
  body.IsUpright = false;
  body.Asleep = false;
}

// The robots that touch nothing in the tick become free, those that may touch something active.
void CRigidWorld::SelectFree(CThreadPool* pool) {
  for (SRigidBody* body : m_active) {
    if (!body->Asleep) {
      UpdateBounds(*body);
    }
  }
  m_free.StartTick({m_movables, m_active, m_fixed, *m_grips, m_ghosts.Get()}, FindFastest(m_active),
                   m_settings.Tick, pool);
  // backwards, because the last one takes the place of a deactivated one
  for (size_t i = m_active.size(); i-- > 0;) {
    if (m_active[i]->HasDrive() && m_free.MayFree(*m_active[i])) {
      Deactivate(*m_active[i]);
    }
  }
  for (SRigidBody* body : m_movables) {
    if (body->IsFree && m_free.MustActivate(*body)) {
      Activate(*body);
    }
  }
  for (SRigidBody* body : m_active) {
    m_free.Claim(*body);
  }
}

// After SelectFree(), and grips have started.
void CRigidWorld::SelectUpright() {
  m_grips->ForEachGrip(
      [](SRigidBody& holder, SRigidBody& held) { holder.IsGripped = held.IsGripped = true; });
  for (SRigidBody* body : m_active) {
    body->TippingTime = std::max(0.0, body->TippingTime - m_settings.Tick);
  }
  m_upright.StartTick({m_active, m_fixed, m_ghosts.Get()}, m_free.GetGround(), m_free.GetReach());
  ListLoose();
}

// Lists the active bodies that are not upright.
void CRigidWorld::ListLoose() {
  m_listed.clear();
  for (SRigidBody* body : m_active) {
    if (!body->IsUpright) {
      body->ActiveNumber = static_cast<UInt32>(m_listed.size());
      m_listed.push_back(body);
    }
  }
  if (m_listed != m_loose) {
    std::swap(m_listed, m_loose);
    m_contacts->MarkChanged();
  }
}

// After a number of substeps: activates the free robots near bodies that move farther than
// expected.
void CRigidWorld::ActivateStruck(UInt32 substeps) {
  const Real rest = (m_numSubsteps - substeps) * m_substep;
  // those that are activated may be added to the list
  for (size_t i = 0; m_free.GetGround() && i < m_loose.size(); ++i) {
    m_struck.clear();
    if (m_loose[i]->Asleep || !m_free.ExtendClaim(*m_loose[i], m_substep, rest, m_struck)) {
      continue;
    }
    for (const UInt32 number : m_struck) {
      if (m_movables[number]->IsFree) {
        ActivateAt(*m_movables[number], substeps);
      }
    }
  }
}

// Activates a free robot within a tick.
void CRigidWorld::ActivateAt(SRigidBody& body, UInt32 substeps) {
  body.Roll = ::argos::Roll(body, body.Roll, body.Source.Drive.Read(), *m_free.GetGround(),
                            m_substep, substeps);
  Activate(body);
  m_free.Claim(body);
  StartRobotTick(body);
  if (body.HasWheels()) {
    TuneWheels(body, m_gravity.Length(), m_substep);
  }
}

// Moves the free robots by the tick.
void CRigidWorld::RollFree(CThreadPool* pool) {
  if (!m_free.GetGround()) {
    return;
  }
  const SRollGround& ground = *m_free.GetGround();
  const auto roll = [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      SRigidBody& body = *m_movables[i];
      if (body.IsFree) {
        const SDriveCommand command = body.Source.Drive.Read();
        body.Asleep = command == SDriveCommand() && body.Roll.Motion == SDriveCommand();
        if (!body.Asleep) {
          body.Roll = ::argos::Roll(body, body.Roll, command, ground, m_substep, m_numSubsteps);
        }
      }
    }
  };
  if (pool != nullptr) {
    pool->ParallelFor(m_movables.size(), kRollGrain, roll);
  } else {
    roll(0, m_movables.size(), 0);
  }
}

}  // namespace argos
