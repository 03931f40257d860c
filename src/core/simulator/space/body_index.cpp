#include <argos3/core/simulator/space/body_index.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/shape_overlap.h>
#include <argos3/core/utility/math/general.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <atomic>
#include <cmath>
#include <utility>

namespace argos {

namespace {

// bodies of one parallel run: enough work to pay for waking a thread
constexpr size_t kGrain = 1024;
// below this many bodies in the overlay it is not worth sorting anew
constexpr size_t kMinOverlay = 64;
// nor below this many cells that wide solids of the overlay touch
constexpr size_t kMinOverlayLinks = 1024;
// m; cells are not made smaller than this however crowded the arena is
constexpr Real kMinCell = 0.02;
constexpr Real kUprightTolerance = 1e-9;

bool StandsUpright(const SShapeDescription& solid) {
  return solid.Kind != SShapeDescription::EKind::Sphere && solid.Orientation.GetX() == 0.0 &&
         solid.Orientation.GetY() == 0.0;
}

CVector3 CentroidInBody(const SShapeDescription& solid) {
  CVector3 centroid(0.0, 0.0, 0.5 * solid.Size.GetZ());
  centroid.Rotate(solid.Orientation);
  return centroid + solid.Offset;
}

// m, around the centroid
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

}  // namespace

void CBodyIndex::SetArea(const CRange<CVector3>& limits) {
  m_minX = limits.GetMin().GetX();
  m_minY = limits.GetMin().GetY();
  m_maxX = limits.GetMax().GetX();
  m_maxY = limits.GetMax().GetY();
  m_cellsChosenFor = 0;
  Rebuild(nullptr);
}

bool CBodyIndex::IsUpright(const CQuaternion& orientation) {
  return Abs(orientation.GetX()) < kUprightTolerance && Abs(orientation.GetY()) < kUprightTolerance;
}

CBodyIndex::SPose CBodyIndex::MakePose(const CVector3& position, const CQuaternion& orientation) {
  const Real w = orientation.GetW();
  const Real z = orientation.GetZ();
  return {position.GetX(), position.GetY(), position.GetZ(),
          w * w - z * z,   2.0 * w * z,     IsUpright(orientation)};
}

UInt32 CBodyIndex::Add(CEmbodiedEntity& body) {
  UInt32 number = 0;
  if (m_free.empty()) {
    number = static_cast<UInt32>(m_bodies.size());
    m_bodies.emplace_back();
  } else {
    number = m_free.back();
    m_free.pop_back();
  }
  m_bodies[number] = {&body, &body.GetOriginAnchor(), nullptr, 0.0, 0.0, kNoBody, kNoBody, 0, false,
                      false};
  ++m_numAlive;
  body.AttachToIndex(this, number);
  Describe(number);
  PutInOverlay(number);
  return number;
}

void CBodyIndex::Describe(UInt32 number) {
  SBody& body = m_bodies[number];
  body.Description = body.Entity->GetBodyDescription();
  body.Reach = body.TiltedReach = 0.0;
  for (const SShapeDescription& solid : body.Description->Shapes) {
    // as Pack() bounds them
    const CVector3 centroid = CentroidInBody(solid);
    const Real sphere = BoundingSphereRadius(solid);
    body.Reach =
        std::max(body.Reach, Horizontal(centroid) + (StandsUpright(solid) ? solid.Radius : sphere));
    body.TiltedReach = std::max(body.TiltedReach, centroid.Length() + sphere);
  }
  body.NumShapes = static_cast<UInt16>(body.Description->Shapes.size());
  body.Small =
      body.Entity->IsMovable() && body.Description->ComputeBoundingRadius() <= kMaxSmallRadius;
  if (body.Small) {
    m_maxSmallReach = std::max(m_maxSmallReach, body.Reach);
  } else {
    m_wideDirty = true;
  }
}

void CBodyIndex::Forget(UInt32 number) {
  if (!m_bodies[number].Small) {
    m_wideDirty = true;
  }
  m_bodies[number].Small = false;
}

void CBodyIndex::Remove(UInt32 number) {
  Forget(number);
  SBody& body = m_bodies[number];
  body.Entity->AttachToIndex(nullptr, kNoBody);
  body.Entity = nullptr;
  body.Origin = nullptr;
  // sorted solids may still name this number: it is used again only after they are sorted anew
  if (!body.Stale) {
    body.Stale = true;
    ++m_numStale;
  }
  m_released.push_back(number);
  --m_numAlive;
}

void CBodyIndex::RefreshNow(UInt32 number) {
  SBody& body = m_bodies[number];
  if (!body.Stale) {
    PutInOverlay(number);
  } else if (body.Small) {
    UInt32* link = &m_overlayHead[body.OverlayPlace];
    while (*link != number) {
      link = &m_bodies[*link].NextInCell;
    }
    *link = body.NextInCell;
    LinkIntoOverlay(number);
  } else {
    // where it was, it is not any more
    for (UInt16 shape = 0; shape < body.NumShapes; ++shape) {
      m_overlayWide[body.OverlayPlace + shape].Shape.Body = kNoBody;
    }
    LinkWideIntoOverlay(number);
  }
}

void CBodyIndex::Redescribe(UInt32 body) {
  Forget(body);
  Describe(body);
  Rebuild(nullptr);
}

void CBodyIndex::PutInOverlay(UInt32 number) {
  SBody& body = m_bodies[number];
  body.Stale = true;
  ++m_numStale;
  if (m_numStale > kMinOverlay + m_shapes.size() + m_wide.size() || m_overlayHead.empty()) {
    Rebuild(nullptr);
  } else if (body.Small) {
    LinkIntoOverlay(number);
  } else {
    LinkWideIntoOverlay(number);
  }
}

void CBodyIndex::LinkWideIntoOverlay(UInt32 number) {
  m_wideDirty = true;
  // sorting anew costs as much as these links have cost
  const size_t cells = m_overlayHead.size();
  if (m_overlayLinks.size() > kMinOverlayLinks + cells + m_wideItems.size()) {
    Rebuild(nullptr);
    return;
  }
  if (m_overlayWideHead.empty()) {
    m_overlayWideHead.assign(cells, kNoBody);
  }
  SBody& body = m_bodies[number];
  body.OverlayPlace = static_cast<UInt32>(m_overlayWide.size());
  for (UInt16 shape = 0; shape < body.NumShapes; ++shape) {
    const SIndexedShape packed = Pack(number, shape);
    const SCellRange touched = CellsOf(packed);
    const auto wide = static_cast<UInt32>(m_overlayWide.size());
    m_overlayWide.push_back({packed, touched.MinI, touched.MinJ});
    ForCells(touched, [this, wide](size_t cell) {
      UInt32& head = m_overlayWideHead[cell];
      if (head == kNoBody) {
        m_overlayWideCells.push_back(static_cast<UInt32>(cell));
      }
      m_overlayLinks.push_back({wide, head});
      head = static_cast<UInt32>(m_overlayLinks.size() - 1);
    });
  }
}

void CBodyIndex::LinkIntoOverlay(UInt32 number) {
  SBody& body = m_bodies[number];
  const UInt32 cell = CellOf(body.Origin->Position);
  if (m_overlayHead[cell] == kNoBody) {
    m_overlayCells.push_back(cell);
  }
  if (!IsUpright(body.Origin->Orientation)) {
    m_tiltedReach = std::max(m_tiltedReach, body.TiltedReach);
  }
  body.OverlayPlace = cell;
  body.NextInCell = m_overlayHead[cell];
  m_overlayHead[cell] = number;
}

void CBodyIndex::ClearOverlay() {
  for (SBody& body : m_bodies) {
    body.Stale = false;
  }
  for (const UInt32 cell : m_overlayCells) {
    m_overlayHead[cell] = kNoBody;
  }
  m_overlayCells.clear();
  for (const UInt32 cell : m_overlayWideCells) {
    m_overlayWideHead[cell] = kNoBody;
  }
  m_overlayWideCells.clear();
  m_overlayWide.clear();
  m_overlayLinks.clear();
  m_free.insert(m_free.end(), m_released.begin(), m_released.end());
  m_released.clear();
  m_numStale = 0;
}

bool CBodyIndex::ChooseCells() {
  // hysteresis: cells are chosen anew only when the numbers have changed by a factor of two
  const bool fits = !m_overlayHead.empty() && m_numAlive <= 2 * m_cellsChosenFor &&
                    m_cellsChosenFor <= 2 * m_numAlive + 16 &&
                    m_cellsChosenReach == m_maxSmallReach;
  if (fits) {
    return false;
  }
  const Real width = std::max(m_maxX - m_minX, kMinCell);
  const Real depth = std::max(m_maxY - m_minY, kMinCell);
  const Real bodies = static_cast<Real>(std::max<size_t>(1, m_numAlive));
  // about one body a cell, but no cell smaller than the largest small body
  m_cell = std::max({kMinCell, 2.0 * m_maxSmallReach, std::sqrt(width * depth / bodies)});
  m_inverseCell = 1.0 / m_cell;
  m_numI = std::max(1, static_cast<int>(std::ceil(width * m_inverseCell)));
  m_numJ = std::max(1, static_cast<int>(std::ceil(depth * m_inverseCell)));
  m_cellsChosenFor = m_numAlive;
  m_cellsChosenReach = m_maxSmallReach;
  const size_t cells = static_cast<size_t>(m_numI) * m_numJ;
  m_cellStart.assign(cells + 1, SCellStart());
  m_cursor.assign(cells, 0);
  m_overlayHead.assign(cells, kNoBody);
  if (!m_overlayWideHead.empty()) {
    m_overlayWideHead.assign(cells, kNoBody);
  }
  return true;
}

void CBodyIndex::Rebuild(CThreadPool* pool) {
  if (m_numStale > 0) {
    ClearOverlay();
  }
  const bool newCells = ChooseCells();
  SortSmall(pool);
  // wide bodies that can move are few, and listed anew every tick
  if (newCells || m_wideDirty) {
    ListWide();
  }
}

// Takes the length of each cell's list from m_cursor, and leaves there where it begins.
// @return the length of all.
UInt32 CBodyIndex::TurnCountsIntoStarts(UInt32 SCellStart::*list) {
  UInt32 sum = 0;
  for (size_t cell = 0; cell < m_cursor.size(); ++cell) {
    m_cellStart[cell].*list = sum;
    sum += std::exchange(m_cursor[cell], sum);
  }
  m_cellStart.back().*list = sum;
  return sum;
}

void CBodyIndex::SortSmall(CThreadPool* pool) {
  m_cellOfBody.resize(m_bodies.size());
  std::atomic<bool> anyTilted{false};
  ForRange(pool, m_bodies.size(), [this, &anyTilted](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      const SBody& body = m_bodies[b];
      if (body.Small && !IsUpright(body.Origin->Orientation)) {
        anyTilted.store(true, std::memory_order_relaxed);
      }
      m_cellOfBody[b] = body.Small ? CellOf(body.Origin->Position) : kNoBody;
    }
  });

  m_tiltedReach = 0.0;
  if (anyTilted) {
    for (size_t b = 0; b < m_bodies.size(); ++b) {
      if (m_cellOfBody[b] != kNoBody && !IsUpright(m_bodies[b].Origin->Orientation)) {
        m_tiltedReach = std::max(m_tiltedReach, m_bodies[b].TiltedReach);
      }
    }
  }

  // counting sort by cell; within a cell by body number, whatever the number of threads
  std::fill(m_cursor.begin(), m_cursor.end(), 0);
  for (size_t b = 0; b < m_bodies.size(); ++b) {
    if (m_cellOfBody[b] != kNoBody) {
      m_cursor[m_cellOfBody[b]] += m_bodies[b].NumShapes;
    }
  }
  const UInt32 numShapes = TurnCountsIntoStarts(&SCellStart::Small);
  m_placeOfBody.resize(m_bodies.size());
  m_shapes.resize(numShapes);
  for (size_t b = 0; b < m_bodies.size(); ++b) {
    if (m_cellOfBody[b] != kNoBody) {
      UInt32& cursor = m_cursor[m_cellOfBody[b]];
      m_placeOfBody[b] = cursor;
      cursor += m_bodies[b].NumShapes;
    }
  }
  // reads bodies in their order, and writes to the places that they are sorted to
  ForRange(pool, m_bodies.size(), [this](size_t begin, size_t end) {
    for (size_t b = begin; b < end; ++b) {
      if (m_cellOfBody[b] == kNoBody) {
        continue;
      }
      for (UInt16 shape = 0; shape < m_bodies[b].NumShapes; ++shape) {
        m_shapes[m_placeOfBody[b] + shape] = Pack(static_cast<UInt32>(b), shape);
      }
    }
  });
}

void CBodyIndex::ListWide() {
  m_wide.clear();
  bool anyMovable = false;
  for (size_t b = 0; b < m_bodies.size(); ++b) {
    const SBody& body = m_bodies[b];
    if (body.Entity == nullptr || body.Small) {
      continue;
    }
    anyMovable = anyMovable || body.Entity->IsMovable();
    for (UInt16 shape = 0; shape < body.NumShapes; ++shape) {
      const SIndexedShape packed = Pack(static_cast<UInt32>(b), shape);
      const SCellRange cells = CellsOf(packed);
      m_wide.push_back({packed, cells.MinI, cells.MinJ});
    }
  }
  std::fill(m_cursor.begin(), m_cursor.end(), 0);
  for (const SWideShape& wide : m_wide) {
    ForCells(CellsOf(wide.Shape), [this](size_t cell) { ++m_cursor[cell]; });
  }
  m_wideItems.resize(TurnCountsIntoStarts(&SCellStart::Wide));
  for (size_t w = 0; w < m_wide.size(); ++w) {
    ForCells(CellsOf(m_wide[w].Shape),
             [this, w](size_t cell) { m_wideItems[m_cursor[cell]++] = static_cast<UInt32>(w); });
  }
  m_wideDirty = anyMovable;
}

CBodyIndex::SCellRange CBodyIndex::CellsOf(const SIndexedShape& shape) const {
  Real reachX = shape.HalfX;
  Real reachY = shape.HalfX;
  if (shape.Kind == SIndexedShape::EKind::Box) {
    reachX = Abs(shape.Cos) * shape.HalfX + Abs(shape.Sin) * shape.HalfY;
    reachY = Abs(shape.Sin) * shape.HalfX + Abs(shape.Cos) * shape.HalfY;
  }
  return {CellI(shape.X - reachX), CellI(shape.X + reachX), CellJ(shape.Y - reachY),
          CellJ(shape.Y + reachY)};
}

SIndexedShape CBodyIndex::Pack(UInt32 body, UInt16 shape) const {
  const SBody& owner = m_bodies[body];
  const SShapeDescription& solid = owner.Description->Shapes[shape];
  const SPose pose = MakePose(owner.Origin->Position, owner.Origin->Orientation);
  SIndexedShape packed = Pack(solid, pose, owner.Origin->Orientation);
  packed.Body = body;
  packed.Shape = shape;
  return packed;
}

SIndexedShape CBodyIndex::Pack(const SShapeDescription& shape, const SPose& pose,
                               const CQuaternion& orientation) {
  SIndexedShape packed{};
  packed.Body = kNoBody;
  if (!pose.Upright || !StandsUpright(shape)) {
    // bounded by a sphere around the centroid
    CVector3 centroid = CentroidInBody(shape);
    centroid.Rotate(orientation);
    packed.Radius = BoundingSphereRadius(shape);
    packed.X = pose.X + centroid.GetX();
    packed.Y = pose.Y + centroid.GetY();
    packed.Cos = 1.0;
    packed.HalfX = packed.HalfY = packed.Radius;
    packed.ZMin = pose.Z + centroid.GetZ() - packed.Radius;
    packed.ZMax = pose.Z + centroid.GetZ() + packed.Radius;
    packed.Kind = SIndexedShape::EKind::Tilted;
    return packed;
  }
  packed.X = pose.X + pose.Cos * shape.Offset.GetX() - pose.Sin * shape.Offset.GetY();
  packed.Y = pose.Y + pose.Sin * shape.Offset.GetX() + pose.Cos * shape.Offset.GetY();
  packed.ZMin = pose.Z + shape.Offset.GetZ();
  packed.ZMax = packed.ZMin + shape.Size.GetZ();
  packed.Radius = shape.Radius;
  if (shape.Kind == SShapeDescription::EKind::Cylinder) {
    packed.Cos = 1.0;
    packed.HalfX = packed.HalfY = shape.Radius;
    packed.Kind = SIndexedShape::EKind::Disc;
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
