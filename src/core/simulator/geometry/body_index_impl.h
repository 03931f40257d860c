#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_INDEX_IMPL_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_INDEX_IMPL_H

#include <argos3/core/simulator/geometry/body_index.h>

// the queries of CBodyIndex, inline because their visitors are

namespace argos {

inline void CBodyIndex::CheckNumber([[maybe_unused]] UInt32 body) const {
  ARGOS_ASSERT(body < m_bodies.size() && m_bodies[body].Entity != nullptr,
               "there is no body " << body << " in the index: the number is stale");
}

template <typename VISIT>
void CBodyIndex::ForEachBody(VISIT&& visit) const {
  for (const SBody& body : m_bodies) {
    if (body.Entity != nullptr) {
      visit(*body.Entity);
    }
  }
}

inline SIndexedShape CBodyIndex::Unpack(size_t place) const {
  const SPackedShape& packed = m_shapes[place];
  SBoxSides sides{1.0, 0.0, packed.Radius, packed.Radius};
  if (packed.Kind == SIndexedShape::EKind::Box) {
    sides = m_sides[place];
  }
  return {packed.X,      packed.Y,    sides.Cos,   sides.Sin,   sides.HalfX,  sides.HalfY,
          packed.Radius, packed.ZMin, packed.ZMax, packed.Body, packed.Shape, packed.Kind};
}

inline SBodyPose CBodyIndex::PoseOf(const SBody& body, const SShapeDescription& solid) {
  return body.Links != nullptr ? Compose(*body.Origin, body.Links[solid.Link]) : *body.Origin;
}

inline SCellRange CBodyIndex::CellsAround(const SPlanarArea& area, Real margin) const {
  return m_grid.CellsAround(0.5 * (area.MinX + area.MaxX), 0.5 * (area.MinY + area.MaxY),
                            0.5 * (area.MaxX - area.MinX) + margin,
                            0.5 * (area.MaxY - area.MinY) + margin);
}

// a row of cells is one range of the sorted solids
template <typename COUNTS, typename VISIT>
void CBodyIndex::VisitSmall(const SCellRange& cells, COUNTS&& counts, VISIT&& visit) const {
  m_grid.ForRows(cells, [&](UInt32 first, UInt32 last) {
    const UInt32 end = m_sort.End(last);
    for (UInt32 place = m_sort.Begin(first); place < end; ++place) {
      if (counts(m_shapes[place]) && !IsStale(m_shapes[place].Body)) {
        visit(Unpack(place));
      }
    }
  });
}

template <typename VISIT>
void CBodyIndex::VisitBody(UInt32 body, VISIT&& visit) const {
  if (m_bodies[body].Entity == nullptr) {
    return;
  }
  for (UInt16 shape = 0; shape < m_bodies[body].NumShapes; ++shape) {
    visit(Pack(body, shape));
  }
}

template <typename VISIT>
void CBodyIndex::VisitOverlay(const SCellRange& small, const SCellRange& wide,
                              VISIT&& visit) const {
  if (!m_overlay.IsEmpty()) {
    m_grid.ForCells(small, [&](UInt32 cell) {
      m_overlay.ForItems(cell, [&](UInt32 body) { VisitBody(body, visit); });
    });
  }
  if (!m_overlayWide.empty()) {
    m_grid.ForCells(wide, [&](UInt32 cell) {
      m_overlayWideCells.ForItems(cell, [&](UInt32 number) {
        const SWideShape& shape = m_overlayWide[number];
        if (CountsInCell(cell, shape, wide) && shape.Shape.Body != kNoBody &&
            m_bodies[shape.Shape.Body].Entity != nullptr) {
          visit(shape.Shape);
        }
      });
    });
  }
}

template <typename VISIT>
void CBodyIndex::VisitWide(const SCellRange& cells, VISIT&& visit) const {
  m_grid.ForRows(cells, [&](UInt32 first, UInt32 last) {
    if (m_wideCells.Get(first, last).IsEmpty()) {
      return;
    }
    for (UInt32 cell = first; cell <= last; ++cell) {
      for (const UInt32 number : m_wideCells.Get(cell)) {
        const SWideShape& wide = m_wide[number];
        if (CountsInCell(cell, wide, cells) && !IsStale(wide.Shape.Body)) {
          visit(wide.Shape);
        }
      }
    }
  });
}

// does the same as VisitSmall(), but adds discs to a list
template <typename VISIT, typename TAKE_DISCS>
void CBodyIndex::ListSmall(const SCellRange& cells, const SDiscQuery& query, SDiscList& discs,
                           TAKE_DISCS&& takeDiscs, VISIT&& visit) const {
  const auto isDisc = [&query](const SPackedShape& shape) {
    // single ampersands make no branch
    return static_cast<size_t>(shape.Kind == SIndexedShape::EKind::Disc) &
           static_cast<size_t>(shape.ZMin <= query.MinZ) &
           static_cast<size_t>(shape.ZMax >= query.MaxZ);
  };
  m_grid.ForRows(cells, [&](UInt32 first, UInt32 last) {
    const UInt32 end = m_sort.End(last);
    for (UInt32 begin = m_sort.Begin(first); begin != end;) {
      if (discs.Size == SDiscList::kCapacity) {
        takeDiscs();
      }
      const UInt32 room = static_cast<UInt32>(SDiscList::kCapacity - discs.Size);
      const UInt32 chunkEnd = std::min(end, begin + room);
      size_t size = discs.Size;
      size_t numOthers = 0;
      // the loop has no branches, which could not be predicted
      for (UInt32 place = begin; place != chunkEnd; ++place) {
        const SPackedShape& shape = m_shapes[place];
        const Real dx = shape.X - query.X;
        const Real dy = shape.Y - query.Y;
        const Real far = query.Reach + shape.Radius;
        const auto isNear = static_cast<size_t>(dx * dx + dy * dy <= far * far);
        const auto counts = static_cast<size_t>(shape.Body != query.IgnoredBody);
        const size_t isListed = isDisc(shape);
        discs.X[size] = shape.X;
        discs.Y[size] = shape.Y;
        discs.Radius[size] = shape.Radius;
        discs.Body[size] = shape.Body;
        size += isListed & isNear & counts;
        numOthers += isListed ^ 1;
      }
      discs.Size = size;
      for (UInt32 place = begin; numOthers > 0; ++place) {
        if (isDisc(m_shapes[place]) == 0) {
          visit(Unpack(place));
          --numOthers;
        }
      }
      begin = chunkEnd;
    }
  });
}

// the solids in two ranges of cells: of those sorted by cell, and of those listed in cells
template <typename COUNTS, typename VISIT>
void CBodyIndex::VisitNear(const SCellRange& small, const SCellRange& wide,
                           const SHeightRange& heights, COUNTS&& counts, VISIT&& visit) const {
  if (!m_shapes.empty() && heights.Overlaps(m_smallHeights)) {
    VisitSmall(small, counts, visit);
  }
  VisitUnsorted(small, wide, [&](const SIndexedShape& shape) {
    if (counts(shape)) {
      visit(shape);
    }
  });
}

template <typename VISIT>
void CBodyIndex::VisitUnsorted(const SCellRange& small, const SCellRange& wide,
                               VISIT&& visit) const {
  VisitOverlay(small, wide, visit);
  if (!m_wide.empty()) {
    VisitWide(wide, visit);
  }
}

template <typename VISIT>
void CBodyIndex::ForShapesNear(Real x, Real y, Real reach, VISIT&& visit) const {
  if (m_period.IsOn()) {
    ForImagesNear(x, y, reach, visit);
  } else {
    ForShapesNearHere(x, y, reach, visit);
  }
}

template <typename VISIT>
void CBodyIndex::ForShapesNearHere(Real x, Real y, Real reach, VISIT&& visit) const {
  const auto isNear = [&](const auto& shape) {
    const Real dx = shape.X - x;
    const Real dy = shape.Y - y;
    const Real far = reach + shape.Radius;
    return dx * dx + dy * dy <= far * far;
  };
  VisitNear(m_grid.CellsAround(x, y, reach + SmallReach()), m_grid.CellsAround(x, y, reach),
            SHeightRange::All(), isNear, visit);
}

template <typename VISIT, typename TAKE_DISCS>
void CBodyIndex::ListDiscsNear(const SDiscQuery& query, SDiscList& discs, TAKE_DISCS&& takeDiscs,
                               VISIT&& visit) const {
  if (m_period.IsOn()) {
    ForImagesNear(query.X, query.Y, query.Reach, visit);
    return;
  }
  const SCellRange small = m_grid.CellsAround(query.X, query.Y, query.Reach + SmallReach());
  if (!m_shapes.empty()) {
    if (m_numStale > 0) {
      VisitSmall(small, CountAny, visit);
    } else {
      ListSmall(small, query, discs, takeDiscs, visit);
    }
  }
  VisitUnsorted(small, m_grid.CellsAround(query.X, query.Y, query.Reach), visit);
}

template <typename VISIT>
void CBodyIndex::ForShapesInArea(const SPlanarArea& area, VISIT&& visit,
                                 const SHeightRange& heights) const {
  if (m_period.IsOn()) {
    ForImagesInArea(area, heights, visit);
  } else {
    ForShapesInAreaHere(area, heights, visit);
  }
}

template <typename VISIT>
void CBodyIndex::ForShapesInAreaHere(const SPlanarArea& area, const SHeightRange& heights,
                                     VISIT&& visit) const {
  // more by a rounding, so that a touched border counts
  const Real rounded = 1e-9;
  const auto isIn = [&](const auto& shape) {
    const Real radius = shape.Radius + rounded;
    return shape.X + radius >= area.MinX && shape.X - radius <= area.MaxX &&
           shape.Y + radius >= area.MinY && shape.Y - radius <= area.MaxY &&
           heights.Overlaps({shape.ZMin, shape.ZMax});
  };
  VisitNear(CellsAround(area, SmallReach() + rounded), CellsAround(area, rounded), heights, isIn,
            visit);
}

template <typename RAYS, typename VISIT, typename DONE>
void CBodyIndex::ForShapesAlongRays(const RAYS& rays, const SRayReach& reach, VISIT&& visit,
                                    DONE&& isDone) const {
  if (!m_period.IsOn()) {
    ForShapesAlongRaysHere(rays, reach, visit, isDone);
    return;
  }
  for (const CRay3& ray : rays) {
    ForImagesAlongRay(ray, reach, visit, isDone);
  }
}

template <typename RAYS, typename VISIT, typename DONE>
void CBodyIndex::ForShapesAlongRaysHere(const RAYS& rays, const SRayReach& reach, VISIT&& visit,
                                        DONE&& isDone) const {
  // parts of rays at some heights that are at most so many cells long share a rectangle of cells
  const auto forCells = [&](const SHeightRange& heights, Real radius, int numCells,
                            auto&& visitCells) {
    // more than the reach by a rounding, so that a touched border counts
    const Real margin = radius + reach.Across + 1e-9;
    SPlanarArea shared = SPlanarArea::Empty();
    for (const CRay3& ray : rays) {
      const SRaySpan part = heights.FindPart(ray, reach.Vertical);
      if (part.IsEmpty()) {
        continue;
      }
      const CVector3 way = ray.GetEnd() - ray.GetStart();
      const CVector3 first = ray.GetStart() + part.First * way;
      const CVector3 last = ray.GetStart() + part.Last * way;
      const Real dx = last.GetX() - first.GetX();
      const Real dy = last.GetY() - first.GetY();
      if (std::max(std::abs(dx), std::abs(dy)) > numCells * m_grid.GetX().Edge) {
        m_grid.ForRowsAlongSegment(first.GetX(), first.GetY(), dx, dy, margin, visitCells, isDone);
      } else {
        shared.Include(first.GetX(), first.GetY());
        shared.Include(last.GetX(), last.GetY());
      }
    }
    if (shared.MinX <= shared.MaxX) {
      visitCells(CellsAround(shared, margin));
    }
  };
  forCells(m_smallHeights, SmallReach(), 2,
           [&](const SCellRange& cells) { VisitSmall(cells, CountAny, visit); });
  if (HasMovedBodies()) {
    forCells(SHeightRange::All(), SmallReach(), 2,
             [&](const SCellRange& cells) { VisitOverlay(cells, cells, visit); });
  }
  // there are wide solids in few rows of cells
  forCells(m_wideHeights, 0.0, 8, [&](const SCellRange& cells) { VisitWide(cells, visit); });
}

}  // namespace argos

#endif
