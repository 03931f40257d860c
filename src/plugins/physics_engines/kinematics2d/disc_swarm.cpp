// The arrays of the robots, and their planned steps; disc_steps.cpp handles obstacles.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/disc_swarm.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/memory/huge_pages.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/arc_block.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

// cells are wider than necessary by this factor, so that they remain wide enough at higher speeds
constexpr Real kEdgeSlack = 1.25;
// margin of the grid around the robots, as a share of their extent, and m
constexpr Real kAreaSlack = 0.05;
constexpr Real kMinAreaSlack = 0.5;
constexpr float kRoundUp = 1.0F + 4.0F * std::numeric_limits<float>::epsilon();

template <typename T>
void RaiseTo(std::atomic<T>& value, T least) {
  T old = value.load(std::memory_order_relaxed);
  while (old < least && !value.compare_exchange_weak(old, least, std::memory_order_relaxed)) {
  }
}

template <typename T>
void LowerTo(std::atomic<T>& value, T most) {
  T old = value.load(std::memory_order_relaxed);
  while (old > most && !value.compare_exchange_weak(old, most, std::memory_order_relaxed)) {
  }
}

template <typename T>
void TakeLast(std::vector<T>& values, UInt32 slot) {
  values[slot] = values.back();
  values.pop_back();
}

// The robots of a block that do not move along their headings: the chord of an arc makes the same
// angle with the heading half-way as the velocity with the heading.
class CSidewaysRobots {
 public:
  void Clear() { m_count = 0; }
  // Notes a robot if necessary. @return its speed along its path, m/s, negative backwards.
  Real Add(size_t number, const SDriveCommand& command) {
    if (command.Left == 0.0) {
      return command.Ahead;
    }
    const Real speed = command.ComputeSpeed();
    m_robots[m_count++] = {number, command.Ahead / speed, command.Left / speed};
    return speed;
  }
  void RotateChords(SArcBlock& block) const {
    for (size_t i = 0; i < m_count; ++i) {
      const auto& [number, cosine, sine] = m_robots[i];
      const Real x = block.StepX[number];
      const Real y = block.StepY[number];
      block.StepX[number] = cosine * x - sine * y;
      block.StepY[number] = sine * x + cosine * y;
    }
  }

 private:
  struct SRobot {
    size_t Number;
    Real Cos, Sin;
  };

  std::array<SRobot, SArcBlock::kSize> m_robots;
  size_t m_count = 0;
};

/** The robots of a block whose command has changed: their arcs until the new one takes effect. */
class CLateArcs {
 public:
  void Clear() {
    m_count = 0;
    m_sideways.Clear();
  }
  /** @param number  of the robot in the block. @param time  s. */
  void Add(size_t number, const SDriveCommand& last, Real halfCos, Real halfSin, Real time) {
    m_arcs.Path[m_count] = m_sideways.Add(m_count, last) * time;
    m_arcs.Quarter[m_count] = 0.25 * last.YawRate * time;
    m_arcs.HalfCos[m_count] = halfCos;
    m_arcs.HalfSin[m_count] = halfSin;
    m_numbers[m_count++] = number;
  }
  /** Follows the arcs; those of @p block start with the headings at their ends. */
  void DriveBefore(SArcBlock& block) {
    if (m_count == 0) {
      return;
    }
    m_arcs.Drive(m_count);
    m_sideways.RotateChords(m_arcs);
    for (size_t k = 0; k < m_count; ++k) {
      block.HalfCos[m_numbers[k]] = m_arcs.HalfCos[k];
      block.HalfSin[m_numbers[k]] = m_arcs.HalfSin[k];
    }
  }
  /** Adds the steps and the lengths of the arcs to those of @p block. */
  void AddSteps(SArcBlock& block) const {
    for (size_t k = 0; k < m_count; ++k) {
      const size_t i = m_numbers[k];
      block.StepX[i] += m_arcs.StepX[k];
      block.StepY[i] += m_arcs.StepY[k];
      block.Path[i] = std::abs(block.Path[i]) + std::abs(m_arcs.Path[k]);
    }
  }

 private:
  SArcBlock m_arcs;
  CSidewaysRobots m_sideways;
  std::array<size_t, SArcBlock::kSize> m_numbers;
  size_t m_count = 0;
};

}  // namespace

void CDiscSwarm::Reserve(size_t discs) {
  for (auto* values :
       {&m_x, &m_y, &m_halfCos, &m_halfSin, &m_allowance, &m_lastSpeed, &m_lastLeft, &m_lastYawRate,
        &m_radius, &m_stepX, &m_stepY, &m_nextX, &m_nextY, &m_nextHalfCos, &m_nextHalfSin}) {
    ReserveInHugePages(*values, discs);
  }
  m_drives.reserve(discs);
  ReserveInHugePages(m_owner, discs);
  m_generations.Reserve(discs);
  m_reach.reserve(discs);
  m_sort.Reserve(discs, CFramedGrid::MaxCells(discs));
  AdviseHugePages(m_sort.GetStartAddress(0), m_sort.GetKeyCapacity() * sizeof(UInt32));
  ReserveInHugePages(m_places, discs);
  m_targets.reserve(discs);
  m_done.reserve(discs);
  m_next.reserve(discs);
  for (std::vector<UInt8>& rounds : m_movedIn) {
    rounds.reserve(discs);
  }
  ReserveActive(discs);
}

// Their contents are lost.
void CDiscSwarm::ReserveActive(size_t discs) {
  if (discs > m_activeCapacity) {
    m_activeDiscs = std::make_unique_for_overwrite<SActiveDisc[]>(discs);
    m_activeCapacity = discs;
  }
}

void CDiscSwarm::Add(const SKinematicOwner& owner, const SBodyDescription& description,
                     const SPlanarPose& pose, const CDriveSource& drive) {
  const UInt32 slot = static_cast<UInt32>(m_x.size());
  *owner.Handle = {EKinematicKind::Disc, slot, m_generations.Add()};
  for (auto* values :
       {&m_x, &m_y, &m_halfCos, &m_halfSin, &m_allowance, &m_lastSpeed, &m_lastLeft, &m_lastYawRate,
        &m_stepX, &m_stepY, &m_nextX, &m_nextY, &m_nextHalfCos, &m_nextHalfSin}) {
    values->push_back(0.0);
  }
  m_reach.push_back(0.0F);
  m_drives.push_back(drive);
  m_radius.push_back(description.Shapes.front().Radius);
  m_owner.push_back(owner);
  m_maxRadius = std::max(m_maxRadius, m_radius.back());
  PutAt(slot, pose);
}

void CDiscSwarm::Remove(const SKinematicHandle& handle) {
  m_generations.Check(handle);
  const UInt32 slot = handle.Slot;
  for (auto* values :
       {&m_x, &m_y, &m_halfCos, &m_halfSin, &m_allowance, &m_lastSpeed, &m_lastLeft, &m_lastYawRate,
        &m_radius, &m_stepX, &m_stepY, &m_nextX, &m_nextY, &m_nextHalfCos, &m_nextHalfSin}) {
    TakeLast(*values, slot);
  }
  *m_owner[slot].Handle = SKinematicHandle();
  TakeLast(m_drives, slot);
  TakeLast(m_owner, slot);
  TakeLast(m_reach, slot);
  const UInt32 generation = m_generations.Remove(slot);
  if (slot < m_owner.size()) {
    m_owner[slot].Handle->Slot = slot;
    m_owner[slot].Handle->Generation = generation;
  }
}

// few discs push anything, so it is not stored for each
Real CDiscSwarm::GetMaxForce(UInt32 slot) const {
  return GetOwner(slot).Body->GetBodyDescription()->GetDriveLimits().MaxForce;
}

// It does not leave the circle in which others expect it, nor come near a robot of another engine.
Real CDiscSwarm::GetRoomBack(UInt32 slot) const {
  CheckPlaces();
  CheckSlot(slot);
  const SPlace& disc = m_places[m_sort.GetPlace(slot)];
  return m_ghostLines.Has(slot)
             ? 0.0
             : std::max(0.0, static_cast<Real>(disc.Reach) - m_radius[slot] - kMaxRounding);
}

void CDiscSwarm::PushBack(UInt32 slot, const SPlanarVector& step) {
  CheckPlaces();
  CheckSlot(slot);
  SPlace& disc = m_places[m_sort.GetPlace(slot)];
  disc.X = m_x[slot] = m_nextX[slot] = m_x[slot] + step.X;
  disc.Y = m_y[slot] = m_nextY[slot] = m_y[slot] + step.Y;
  disc.Reach = static_cast<float>(static_cast<Real>(disc.Reach) - std::hypot(step.X, step.Y));
  m_stepX[slot] = m_stepY[slot] = 0.0;
}

void CDiscSwarm::SetPose(const SKinematicHandle& handle, const SPlanarPose& pose) {
  m_generations.Check(handle);
  PutAt(handle.Slot, pose);
}

void CDiscSwarm::PutAt(UInt32 slot, const SPlanarPose& pose) {
  m_x[slot] = m_nextX[slot] = pose.X;
  m_y[slot] = m_nextY[slot] = pose.Y;
  m_halfCos[slot] = m_nextHalfCos[slot] = pose.HalfCos;
  m_halfSin[slot] = m_nextHalfSin[slot] = pose.HalfSin;
  m_lastSpeed[slot] = m_lastLeft[slot] = m_lastYawRate[slot] = 0.0;
  // the new pose may overlap other bodies
  m_allowance[slot] = m_radius[slot];
}

void CDiscSwarm::SetLastCommand(const SKinematicHandle& handle, const SDriveCommand& command) {
  m_generations.Check(handle);
  m_lastSpeed[handle.Slot] = command.Ahead;
  m_lastLeft[handle.Slot] = command.Left;
  m_lastYawRate[handle.Slot] = command.YawRate;
}

SDriveCommand CDiscSwarm::GetLastCommand(const SKinematicHandle& handle) const {
  m_generations.Check(handle);
  return ReadLastCommand(handle.Slot);
}

void CDiscSwarm::Plan(CThreadPool& pool, const SSubstep& substep) {
  const size_t size = GetSize();
  if (size == 0) {
    m_places.clear();
    return;
  }
  if (++m_ticksOfGrid > kTicksOfGrid || m_discsOfGrid > 2 * size || size > 2 * m_discsOfGrid) {
    m_ticksOfGrid = 0;
    if (IsGridBad()) {
      BuildGrid();
    }
  }
  m_sort.Start(size, m_grid.GetNumCells());
  m_maxReach.store(0.0F, std::memory_order_relaxed);
  m_firstBad.store(std::numeric_limits<UInt32>::max(), std::memory_order_relaxed);
  const bool alone = pool.GetNumThreads() == 1;
  pool.ParallelFor(size, kDiscGrain, [&](size_t begin, size_t end, UInt32) {
    PlanChunk(begin, end, substep);
    Bin(begin, end, alone);
  });
  const UInt32 bad = m_firstBad.load(std::memory_order_relaxed);
  if (bad < size) {
    throw SBadDriveCommand{m_owner[bad].Body, m_drives[bad]};
  }
  const Real reach = static_cast<Real>(m_maxReach.load(std::memory_order_relaxed));
  if (2.0 * reach > m_grid.GetX().Edge) {
    BuildGrid();
    m_sort.Start(size, m_grid.GetNumCells());
    pool.ParallelFor(size, kDiscGrain,
                     [&](size_t begin, size_t end, UInt32) { Bin(begin, end, alone); });
  }
  Sort(pool);
}

// Plans the steps of robots [begin, end).
void CDiscSwarm::PlanChunk(size_t begin, size_t end, const SSubstep& substep) {
  const Real lateTime = substep.LateShare * substep.Duration;
  CLateArcs late;
  SArcBlock block;
  CSidewaysRobots sideways;
  float maxReach = 0.0F;
  for (size_t first = begin; first < end; first += SArcBlock::kSize) {
    const size_t count = std::min(SArcBlock::kSize, end - first);
    late.Clear();
    sideways.Clear();
    for (size_t i = 0; i < count; ++i) {
      const size_t slot = first + i;
      const SDriveCommand ordered = m_drives[slot].Read();
      if (!ordered.IsFinite()) {
        LowerTo(m_firstBad, static_cast<UInt32>(slot));
      }
      const SDriveCommand command = ordered.Limited(kMaxStep * m_radius[slot] / substep.Duration);
      const SDriveCommand last = ReadLastCommand(slot);
      Real time = substep.Duration;
      if (lateTime > 0.0 && !(command == last)) {
        time -= lateTime;
        late.Add(i, last, m_halfCos[slot], m_halfSin[slot], lateTime);
      }
      if (substep.IsLast) {
        m_lastSpeed[slot] = command.Ahead;
        m_lastYawRate[slot] = command.YawRate;
        if (!m_drives[slot].HasWheels()) {
          m_lastLeft[slot] = command.Left;
        }
      }
      block.Path[i] = sideways.Add(i, command) * time;
      block.Quarter[i] = 0.25 * command.YawRate * time;
      block.HalfCos[i] = m_halfCos[slot];
      block.HalfSin[i] = m_halfSin[slot];
    }
    late.DriveBefore(block);
    block.Drive(count);
    sideways.RotateChords(block);
    late.AddSteps(block);
    maxReach = std::max(maxReach, TakeSteps(block, first, count));
  }
  RaiseTo(m_maxReach, maxReach);
}

// Sets the planned steps of robots from slot @p first on. @return their greatest reach, m.
float CDiscSwarm::TakeSteps(const SArcBlock& block, size_t first, size_t count) {
  float maxReach = 0.0F;
  for (size_t i = 0; i < count; ++i) {
    const size_t slot = first + i;
    m_stepX[slot] = block.StepX[i];
    m_stepY[slot] = block.StepY[i];
    m_nextX[slot] = m_x[slot] + block.StepX[i];
    m_nextY[slot] = m_y[slot] + block.StepY[i];
    m_nextHalfCos[slot] = block.HalfCos[i];
    m_nextHalfSin[slot] = block.HalfSin[i];
    m_reach[slot] = static_cast<float>(m_radius[slot] + std::abs(block.Path[i]) +
                                       m_allowance[slot] + kMaxRounding) *
                    kRoundUp;
    m_allowance[slot] = 0.0;
    maxReach = std::max(maxReach, m_reach[slot]);
  }
  return maxReach;
}

// Sets the cells of robots [begin, end).
void CDiscSwarm::Bin(size_t begin, size_t end, bool alone) {
  for (size_t slot = begin; slot < end; ++slot) {
    const UInt32 cell = m_grid.CellAt(m_x[slot], m_y[slot]);
    if (alone) {
      m_sort.SetKey(slot, cell);
    } else {
      m_sort.SetKeyOnThread(slot, cell);
    }
  }
}

void CDiscSwarm::Sort(CThreadPool& pool) {
  m_places.resize(m_sort.Finish());
  pool.ParallelFor(GetSize(), kDiscGrain, [this](size_t begin, size_t end, UInt32) {
    for (size_t slot = begin; slot < end; ++slot) {
      m_places[m_sort.GetPlace(slot)] = {m_x[slot], m_y[slot], m_reach[slot],
                                         static_cast<UInt32>(slot)};
    }
  });
}

// @return true if the grid is much larger or coarser than the swarm needs, or too small.
bool CDiscSwarm::IsGridBad() const {
  if (m_discsOfGrid > 2 * GetSize() || GetSize() > 2 * m_discsOfGrid) {
    return true;
  }
  const SPlanarArea& area = m_areaOfGrid;
  const auto [minX, maxX] = std::minmax_element(m_x.begin(), m_x.end());
  const auto [minY, maxY] = std::minmax_element(m_y.begin(), m_y.end());
  const Real width = area.MaxX - area.MinX;
  const Real height = area.MaxY - area.MinY;
  const bool outside = *minX < area.MinX - 0.25 * width || *maxX > area.MaxX + 0.25 * width ||
                       *minY < area.MinY - 0.25 * height || *maxY > area.MaxY + 0.25 * height;
  const bool sparse =
      (*maxX - *minX + 2.0 * kMinAreaSlack) * (*maxY - *minY + 2.0 * kMinAreaSlack) <
      0.5 * width * height;
  return outside || sparse || m_reachOfGrid > 4.0 * GetGreatestReach();
}

void CDiscSwarm::BuildGrid() {
  SPlanarArea area;
  if (GetSize() > 0) {
    const auto [minX, maxX] = std::minmax_element(m_x.begin(), m_x.end());
    const auto [minY, maxY] = std::minmax_element(m_y.begin(), m_y.end());
    const Real slackX = kMinAreaSlack + kAreaSlack * (*maxX - *minX);
    const Real slackY = kMinAreaSlack + kAreaSlack * (*maxY - *minY);
    area = {*minX - slackX, *minY - slackY, *maxX + slackX, *maxY + slackY};
  }
  m_reachOfGrid = GetGreatestReach();
  m_areaOfGrid = area;
  m_grid.Cover(area, std::max(2.0 * kEdgeSlack * m_reachOfGrid, 1e-6),
               CFramedGrid::AimedCells(GetSize()));
  m_discsOfGrid = GetSize();
  m_ticksOfGrid = 0;
}

}  // namespace argos
