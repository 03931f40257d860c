#include <argos3/core/simulator/geometry/body_index.h>

#include <argos3/core/utility/math/general.h>
#include <argos3/core/utility/memory/huge_pages.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <atomic>
#include <cmath>
#include <functional>

namespace argos {

namespace {

// bodies of one chunk of a thread: enough work to pay for waking a thread
constexpr size_t kGrain = 1024;
// how far ahead poses of bodies are prefetched, in entries
constexpr size_t kEntriesAhead = 16;
// the overlay is not sorted while it has fewer bodies than this
constexpr size_t kMinOverlay = 64;
// nor while its wide solids touch fewer cells than this
constexpr size_t kMinOverlayLinks = 1024;
// m; cells are not made smaller than this however crowded the arena is
constexpr Real kMinCell = 0.02;
constexpr Real kUprightTolerance = 1e-9;

bool StandsUpright(const SShapeDescription& solid) {
  return solid.Kind != SShapeDescription::EKind::Sphere && solid.Orientation.GetX() == 0.0 &&
         solid.Orientation.GetY() == 0.0;
}

// m, around the middle
Real BoundingSphereRadius(const SShapeDescription& solid) {
  return solid.Kind == SShapeDescription::EKind::Sphere
             ? solid.Radius
             : std::hypot(solid.Radius, 0.5 * solid.Size.GetZ());
}

Real Horizontal(const CVector3& v) {
  return std::hypot(v.GetX(), v.GetY());
}

template <typename FUNCTION>
void ForRange(CThreadPool* pool, size_t items, FUNCTION&& function) {
  if (pool != nullptr) {
    pool->ParallelFor(items, kGrain,
                      [&](size_t begin, size_t end, UInt32) { function(begin, end); });
  } else {
    function(size_t(0), items);
  }
}

// the result of several calls does not depend on their order
template <typename BETTER>
void ReplaceIf(std::atomic<Real>& value, Real candidate, BETTER isBetter) {
  Real old = value.load(std::memory_order_relaxed);
  while (isBetter(candidate, old) &&
         !value.compare_exchange_weak(old, candidate, std::memory_order_relaxed)) {
  }
}

}  // namespace

void CBodyIndex::SetArea(const CRange<CVector3>& limits, const SPeriodicity& period) {
  m_period = period;
  m_area = {limits.GetMin().GetX(), limits.GetMin().GetY(), limits.GetMax().GetX(),
            limits.GetMax().GetY()};
  m_cellsChosenFor = 0;
  Rebuild(nullptr);
}

CBodyIndex::SPose CBodyIndex::MakePose(const CVector3& position, const CQuaternion& orientation) {
  const Real w = orientation.GetW();
  const Real z = orientation.GetZ();
  return {
      position.GetX(),
      position.GetY(),
      position.GetZ(),
      w * w - z * z,
      2.0 * w * z,
      Abs(orientation.GetX()) < kUprightTolerance && Abs(orientation.GetY()) < kUprightTolerance};
}

UInt32 CBodyIndex::Add(CEmbodiedEntity& body, const SBodyPose& origin,
                       const SBodyDescription& description, bool movable, const SBodyPose* links) {
  UInt32 number = 0;
  if (m_free.empty()) {
    number = static_cast<UInt32>(m_bodies.size());
    if (m_bodies.size() == m_bodies.capacity() || m_released.capacity() < m_bodies.capacity()) {
      // all three or none, also without enough memory; and Remove() must never fail
      const size_t capacity = 2 * m_bodies.size() + 1;
      ReserveInHugePages(m_poses, capacity);
      m_released.reserve(capacity);
      m_free.reserve(capacity);
      ReserveInHugePages(m_bodies, capacity);
    }
    m_bodies.emplace_back();
    m_poses.emplace_back();
  } else {
    number = m_free.back();
    m_free.pop_back();
  }
  m_bodies[number] = {&body, &origin, &description, links, 0.0, 0.0, kNoBody, 0, movable, false};
  ++m_numAlive;
  try {
    Describe(number);
    ReadPose(number);
    PutInOverlay(number);
  } catch (...) {
    Remove(number);
    throw;
  }
  return number;
}

void CBodyIndex::Describe(UInt32 number) {
  SBody& body = m_bodies[number];
  body.Reach = body.TiltedReach = 0.0;
  for (const SShapeDescription& solid : body.Description->Shapes) {
    // bounds as Pack() computes them
    const CVector3 middle = solid.ComputeMiddle();
    const Real sphere = BoundingSphereRadius(solid);
    body.Reach =
        std::max(body.Reach, Horizontal(middle) + (StandsUpright(solid) ? solid.Radius : sphere));
    body.TiltedReach = std::max(body.TiltedReach, middle.Length() + sphere);
  }
  body.NumShapes = static_cast<UInt16>(body.Description->Shapes.size());
  // links may be anywhere: each is listed in the cells that it touches
  const bool small = body.Movable && body.Links == nullptr &&
                     body.Description->ComputeBoundingRadius() <= kMaxSmallRadius;
  m_poses[number].Small = small;
  if (small) {
    m_maxSmallReach = std::max(m_maxSmallReach, body.Reach);
    for (const SShapeDescription& solid : body.Description->Shapes) {
      m_hasSmallBoxes = m_hasSmallBoxes || solid.Kind == SShapeDescription::EKind::Box;
    }
  } else {
    m_wideDirty = true;
  }
}

void CBodyIndex::Forget(UInt32 number) {
  if (!m_poses[number].Small) {
    m_wideDirty = true;
  }
  m_poses[number].Small = false;
}

void CBodyIndex::Remove(UInt32 number) {
  CheckNumber(number);
  Forget(number);
  SBody& body = m_bodies[number];
  body.Entity = nullptr;
  // sorted solids may still have this number: it is used again only after the next sort
  if (!body.Stale) {
    body.Stale = true;
    ++m_numStale;
  }
  m_released.push_back(number);
  --m_numAlive;
}

void CBodyIndex::ReadPose(UInt32 number) {
  SPose& pose = m_poses[number];
  const bool small = pose.Small;
  const SBodyPose& origin = *m_bodies[number].Origin;
  pose = MakePose(origin.Position, origin.Orientation);
  pose.Small = small;
}

void CBodyIndex::RefreshNow(UInt32 number) {
  CheckNumber(number);
  ReadPose(number);
  SBody& body = m_bodies[number];
  if (!body.Stale) {
    PutInOverlay(number);
  } else if (m_poses[number].Small) {
    m_overlay.Remove(body.OverlayPlace, number);
    LinkIntoOverlay(number);
  } else {
    // its solids at the previous pose do not count
    for (UInt16 shape = 0; shape < body.NumShapes; ++shape) {
      m_overlayWide[body.OverlayPlace + shape].Shape.Body = kNoBody;
    }
    LinkWideIntoOverlay(number);
  }
}

void CBodyIndex::Redescribe(UInt32 number, const SBodyDescription& description, bool movable,
                            const SBodyPose* links) {
  CheckNumber(number);
  Forget(number);
  m_bodies[number].Description = &description;
  m_bodies[number].Movable = movable;
  m_bodies[number].Links = links;
  Describe(number);
  Rebuild(nullptr);
}

void CBodyIndex::PutInOverlay(UInt32 number) {
  SBody& body = m_bodies[number];
  body.Stale = true;
  ++m_numStale;
  if (m_numStale > kMinOverlay + m_shapes.size() + m_wide.size() || m_overlay.GetNumCells() == 0) {
    Rebuild(nullptr);
  } else if (m_poses[number].Small) {
    LinkIntoOverlay(number);
  } else {
    LinkWideIntoOverlay(number);
  }
}

void CBodyIndex::LinkWideIntoOverlay(UInt32 number) {
  m_wideDirty = true;
  // a sort costs as much as these links have cost
  const size_t numCells = m_grid.GetNumCells();
  if (m_overlayWideCells.GetNumLinks() >
      kMinOverlayLinks + numCells + m_wideCells.GetNumListings()) {
    Rebuild(nullptr);
    return;
  }
  if (m_overlayWideCells.GetNumCells() == 0) {
    m_overlayWideCells.Resize(numCells);
  }
  SBody& body = m_bodies[number];
  body.OverlayPlace = static_cast<UInt32>(m_overlayWide.size());
  for (UInt16 shape = 0; shape < body.NumShapes; ++shape) {
    const SIndexedShape packed = Pack(number, shape);
    const SCellRange cells = CellsOf(packed);
    const auto wide = static_cast<UInt32>(m_overlayWide.size());
    m_overlayWide.push_back({packed, cells.GetFirst()});
    IncludeWide(packed);
    m_grid.ForCells(cells, [this, wide](UInt32 cell) { m_overlayWideCells.Add(cell, wide); });
  }
}

void CBodyIndex::LinkIntoOverlay(UInt32 number) {
  SBody& body = m_bodies[number];
  const SPose& pose = m_poses[number];
  if (!pose.Upright) {
    m_tiltedReach = std::max(m_tiltedReach, body.TiltedReach);
  }
  body.OverlayPlace = m_grid.CellAt(pose.X, pose.Y);
  m_overlay.Add(body.OverlayPlace, number);
}

void CBodyIndex::ClearOverlay() {
  for (SBody& body : m_bodies) {
    body.Stale = false;
  }
  m_overlay.Clear();
  m_overlayWideCells.Clear();
  m_overlayWide.clear();
  m_free.insert(m_free.end(), m_released.begin(), m_released.end());
  m_released.clear();
  m_numStale = 0;
}

bool CBodyIndex::ChooseCells() {
  // hysteresis: cells are chosen again only when the numbers have changed by a factor of two
  const bool fits = m_overlay.GetNumCells() > 0 && m_numAlive <= 2 * m_cellsChosenFor &&
                    m_cellsChosenFor <= 2 * m_numAlive + 16 &&
                    m_cellsChosenReach == m_maxSmallReach;
  if (fits) {
    return false;
  }
  const Real width = std::max(m_area.MaxX - m_area.MinX, kMinCell);
  const Real depth = std::max(m_area.MaxY - m_area.MinY, kMinCell);
  const Real bodies = static_cast<Real>(std::max<size_t>(1, m_numAlive));
  // about one body a cell, but no cell smaller than the largest small body
  const Real edge = std::max({kMinCell, 2.0 * m_maxSmallReach, std::sqrt(width * depth / bodies)});
  const auto count = [inverse = 1.0 / edge](Real length) {
    return std::max(1, static_cast<SInt32>(std::ceil(length * inverse)));
  };
  m_grid.Lay({m_area.MinX, edge, count(width)}, {m_area.MinY, edge, count(depth)});
  m_cellsChosenFor = m_numAlive;
  m_cellsChosenReach = m_maxSmallReach;
  m_overlay.Resize(m_grid.GetNumCells());
  if (m_overlayWideCells.GetNumCells() > 0) {
    m_overlayWideCells.Resize(m_grid.GetNumCells());
  }
  return true;
}

void CBodyIndex::Rebuild(CThreadPool* pool) {
  if (m_numStale > 0) {
    ClearOverlay();
  }
  const bool newCells = ChooseCells();
  SortSmall(pool);
  // wide bodies that can move are few, and are listed again every tick
  if (newCells || m_wideDirty) {
    ListWide();
  }
}

void CBodyIndex::SortSmall(CThreadPool* pool) {
  const size_t numBodies = m_bodies.size();
  const bool isAlone = pool == nullptr || pool->GetNumThreads() == 1 || numBodies <= kGrain;
  if (m_grid.GetNumCells() > m_sort.GetKeyCapacity()) {
    m_sort.Reserve(numBodies, m_grid.GetNumCells());
    AdviseHugePages(m_sort.GetStartAddress(0), m_grid.GetNumCells() * sizeof(UInt32));
  }
  m_sort.Start(numBodies, m_grid.GetNumCells());
  std::atomic<bool> anyTilted{false};
  ForRange(pool, numBodies, [&](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      const SPose& pose = m_poses[b];
      if (!pose.Small) {
        m_sort.LeaveOut(b);
        continue;
      }
      ReadPose(static_cast<UInt32>(b));
      if (!pose.Upright) {
        anyTilted.store(true, std::memory_order_relaxed);
      }
      const UInt32 cell = m_grid.CellAt(pose.X, pose.Y);
      if (isAlone) {
        m_sort.SetKey(b, cell, m_bodies[b].NumShapes);
      } else {
        m_sort.SetKeyOnThread(b, cell, m_bodies[b].NumShapes);
      }
    }
  });

  m_tiltedReach = 0.0;
  if (anyTilted) {
    for (size_t b = 0; b < numBodies; ++b) {
      if (m_poses[b].Small && !m_poses[b].Upright) {
        m_tiltedReach = std::max(m_tiltedReach, m_bodies[b].TiltedReach);
      }
    }
  }

  // within a cell by body number, for any number of threads
  ListSorted(pool, m_sort.Finish());
  if (!isAlone) {
    m_sort.SortRanges(*pool, m_entries, [](const SEntry& entry) {
      return (static_cast<UInt64>(entry.Body) << 16) | entry.Shape;
    });
  }
  PackSmall(pool);
}

// The solids in the order of their cells, within a cell in any order.
void CBodyIndex::ListSorted(CThreadPool* pool, UInt32 numShapes) {
  m_entries.resize(numShapes);
  ReserveInHugePages(m_shapes, numShapes);
  m_shapes.resize(numShapes);
  if (m_hasSmallBoxes) {
    ReserveInHugePages(m_sides, numShapes);
    m_sides.resize(numShapes);
  }
  ForRange(pool, m_bodies.size(), [this](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      if (m_sort.IsLeftOut(b)) {
        continue;
      }
      SEntry* entry = m_entries.data() + m_sort.GetPlace(b);
      for (UInt16 shape = 0; shape < m_bodies[b].NumShapes; ++shape, ++entry) {
        *entry = {static_cast<UInt32>(b), shape};
      }
    }
  });
}

void CBodyIndex::PackSmall(CThreadPool* pool) {
  std::atomic<Real> lowest{HUGE_VAL};
  std::atomic<Real> highest{-HUGE_VAL};
  ForRange(pool, m_entries.size(), [&](size_t begin, size_t end) {
    SHeightRange heights;
    for (size_t k = begin; k < end; ++k) {
      if (k + kEntriesAhead < end) {
        const UInt32 later = m_entries[k + kEntriesAhead].Body;
        LoadAhead(m_poses[later]);
        LoadAhead(m_bodies[later]);
      }
      const SIndexedShape shape = Pack(m_entries[k].Body, m_entries[k].Shape);
      m_shapes[k] = {shape.X,    shape.Y,    shape.Radius, shape.ZMin,
                     shape.ZMax, shape.Body, shape.Shape,  shape.Kind};
      if (shape.Kind == SIndexedShape::EKind::Box) {
        m_sides[k] = {shape.Cos, shape.Sin, shape.HalfX, shape.HalfY};
      }
      heights.Include(shape.ZMin, shape.ZMax);
    }
    ReplaceIf(lowest, heights.Min, std::less<>());
    ReplaceIf(highest, heights.Max, std::greater<>());
  });
  m_smallHeights = {lowest, highest};
}

void CBodyIndex::ListWide() {
  m_wide.clear();
  m_wideHeights = SHeightRange();
  m_wideOutreach = 0.0;
  bool anyMovable = false;
  for (size_t b = 0; b < m_bodies.size(); ++b) {
    const SBody& body = m_bodies[b];
    if (body.Entity == nullptr || m_poses[b].Small) {
      continue;
    }
    ReadPose(static_cast<UInt32>(b));
    anyMovable = anyMovable || body.Movable;
    for (UInt16 shape = 0; shape < body.NumShapes; ++shape) {
      const SIndexedShape packed = Pack(static_cast<UInt32>(b), shape);
      m_wide.push_back({packed, CellsOf(packed).GetFirst()});
      m_wideHeights.Include(packed.ZMin, packed.ZMax);
      IncludeWide(packed);
    }
  }
  m_wideCells.List(m_wide.size(), m_grid.GetNumCells(), [this](UInt32 wide, auto&& list) {
    m_grid.ForCells(CellsOf(m_wide[wide].Shape), list);
  });
  m_wideDirty = anyMovable;
}

void CBodyIndex::IncludeWide(const SIndexedShape& shape) {
  const SPlanarVector half = ComputeHalfBounds(shape);
  m_wideOutreach =
      std::max({m_wideOutreach, shape.X + half.X - m_area.MaxX, shape.Y + half.Y - m_area.MaxY,
                m_area.MinX - (shape.X - half.X), m_area.MinY - (shape.Y - half.Y)});
}

SCellRange CBodyIndex::CellsOf(const SIndexedShape& shape) const {
  const SPlanarVector half = ComputeHalfBounds(shape);
  return m_grid.CellsAround(shape.X, shape.Y, half.X, half.Y);
}

SIndexedShape CBodyIndex::Pack(UInt32 body, UInt16 shape) const {
  const SBody& owner = m_bodies[body];
  const SShapeDescription& solid = owner.Description->Shapes[shape];
  if (owner.Links != nullptr) {
    const SBodyPose moved = PoseOf(owner, solid);
    return Pack(solid, MakePose(moved.Position, moved.Orientation), moved.Orientation, body, shape);
  }
  const SPose& pose = m_poses[body];
  // the entity, which is elsewhere in memory, is not read for upright solids
  const bool upright = pose.Upright && StandsUpright(solid);
  return Pack(solid, pose, upright ? CQuaternion() : owner.Origin->Orientation, body, shape);
}

SIndexedShape CBodyIndex::Pack(const SShapeDescription& shape, const SPose& pose,
                               const CQuaternion& orientation, UInt32 body, UInt16 number) {
  SIndexedShape packed{};
  packed.Body = body;
  packed.Shape = number;
  if (!pose.Upright || !StandsUpright(shape)) {
    // bounded by a sphere around the middle
    CVector3 middle = shape.ComputeMiddle();
    middle.Rotate(orientation);
    packed.Radius = BoundingSphereRadius(shape);
    packed.X = pose.X + middle.GetX();
    packed.Y = pose.Y + middle.GetY();
    packed.Cos = 1.0;
    packed.HalfX = packed.HalfY = packed.Radius;
    packed.ZMin = pose.Z + middle.GetZ() - packed.Radius;
    packed.ZMax = pose.Z + middle.GetZ() + packed.Radius;
    packed.Kind = SIndexedShape::EKind::Bounds;
    return packed;
  }
  packed.X = pose.X + pose.Cos * shape.Offset.GetX() - pose.Sin * shape.Offset.GetY();
  packed.Y = pose.Y + pose.Sin * shape.Offset.GetX() + pose.Cos * shape.Offset.GetY();
  packed.ZMin = pose.Z + shape.Offset.GetZ();
  packed.ZMax = packed.ZMin + shape.Size.GetZ();
  packed.Radius = shape.Radius;
  if (shape.Kind != SShapeDescription::EKind::Box) {
    packed.Cos = 1.0;
    packed.HalfX = packed.HalfY = shape.Radius;
    packed.Kind = shape.Kind == SShapeDescription::EKind::Cylinder ? SIndexedShape::EKind::Disc
                                                                   : SIndexedShape::EKind::Bounds;
  } else {
    const Real w = shape.Orientation.GetW();
    const Real z = shape.Orientation.GetZ();
    const Real cosine = w * w - z * z;
    const Real sine = 2.0 * w * z;
    packed.Cos = pose.Cos * cosine - pose.Sin * sine;
    packed.Sin = pose.Sin * cosine + pose.Cos * sine;
    packed.HalfX = 0.5 * shape.Size.GetX();
    packed.HalfY = 0.5 * shape.Size.GetY();
    packed.Kind = SIndexedShape::EKind::Box;
  }
  return packed;
}

}  // namespace argos
