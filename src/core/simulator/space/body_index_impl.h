#ifndef ARGOS3_CORE_SIMULATOR_SPACE_BODY_INDEX_IMPL_H
#define ARGOS3_CORE_SIMULATOR_SPACE_BODY_INDEX_IMPL_H

#include <argos3/core/simulator/space/body_index.h>

// the queries of CBodyIndex, inline because their visitors are

namespace argos {

// a row of cells is one run of the sorted solids
template <typename VISIT>
void CBodyIndex::VisitSmallRow(int j, int minI, int maxI, VISIT&& visit) const {
  const size_t row = static_cast<size_t>(j) * m_numI;
  const SIndexedShape* shape = m_shapes.data() + m_cellStart[row + minI].Small;
  const SIndexedShape* const end = m_shapes.data() + m_cellStart[row + maxI + 1].Small;
  for (; shape != end; ++shape) {
    if (!IsStale(shape->Body)) {
      visit(*shape);
    }
  }
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
void CBodyIndex::VisitOverlayRow(int j, int minI, int maxI, VISIT&& visit) const {
  const size_t row = static_cast<size_t>(j) * m_numI;
  for (int i = minI; i <= maxI; ++i) {
    for (UInt32 body = m_overlayHead[row + i]; body != kNoBody; body = m_bodies[body].NextInCell) {
      VisitBody(body, visit);
    }
  }
}

template <typename VISIT>
void CBodyIndex::VisitOverlayWide(const SCellRange& cells, VISIT&& visit) const {
  for (int j = cells.MinJ; j <= cells.MaxJ; ++j) {
    const size_t row = static_cast<size_t>(j) * m_numI;
    for (int i = cells.MinI; i <= cells.MaxI; ++i) {
      UInt32 next = m_overlayWideHead[row + i];
      while (next != kNoBody) {
        const SWideShape& wide = m_overlayWide[m_overlayLinks[next].Wide];
        next = m_overlayLinks[next].Next;
        const bool counts = IsFirst(i, j, wide, cells) && wide.Shape.Body != kNoBody &&
                            m_bodies[wide.Shape.Body].Entity != nullptr;
        if (counts) {
          visit(wide.Shape);
        }
      }
    }
  }
}

template <typename VISIT>
void CBodyIndex::VisitWide(const SCellRange& cells, VISIT&& visit) const {
  for (int j = cells.MinJ; j <= cells.MaxJ; ++j) {
    const size_t row = static_cast<size_t>(j) * m_numI;
    for (int i = cells.MinI; i <= cells.MaxI; ++i) {
      for (UInt32 k = m_cellStart[row + i].Wide; k < m_cellStart[row + i + 1].Wide; ++k) {
        const SWideShape& wide = m_wide[m_wideItems[k]];
        if (IsFirst(i, j, wide, cells) && !IsStale(wide.Shape.Body)) {
          visit(wide.Shape);
        }
      }
    }
  }
}

template <typename VISIT>
void CBodyIndex::ForShapesNear(Real x, Real y, Real reach, VISIT&& visit) const {
  const auto visitIfNear = [&](const SIndexedShape& shape) {
    const Real dx = shape.X - x;
    const Real dy = shape.Y - y;
    const Real far = reach + shape.Radius;
    if (dx * dx + dy * dy <= far * far) {
      visit(shape);
    }
  };
  const SCellRange cells = CellsAround(x, y, reach + SmallReach());
  if (!m_shapes.empty()) {
    for (int j = cells.MinJ; j <= cells.MaxJ; ++j) {
      VisitSmallRow(j, cells.MinI, cells.MaxI, visitIfNear);
    }
  }
  if (!m_overlayCells.empty()) {
    for (int j = cells.MinJ; j <= cells.MaxJ; ++j) {
      VisitOverlayRow(j, cells.MinI, cells.MaxI, visitIfNear);
    }
  }
  if (!m_overlayWide.empty()) {
    VisitOverlayWide(CellsAround(x, y, reach), visitIfNear);
  }
  if (!m_wide.empty()) {
    VisitWide(CellsAround(x, y, reach), visitIfNear);
  }
}

template <typename VISIT, typename DONE>
void CBodyIndex::ForShapesAlongRay(const CRay3& ray, Real reach, VISIT&& visit,
                                   DONE&& isDone) const {
  const Real x0 = ray.GetStart().GetX();
  const Real y0 = ray.GetStart().GetY();
  const Real dx = ray.GetEnd().GetX() - x0;
  const Real dy = ray.GetEnd().GetY() - y0;
  const auto forRows = [&](Real margin, auto&& visitRow) {
    const int minJ = CellJ(std::min(y0, y0 + dy) - margin);
    const int maxJ = CellJ(std::max(y0, y0 + dy) + margin);
    for (int j = minJ; j <= maxJ && !isDone(); ++j) {
      // the part of the ray over this row, widened by the margin; border rows have no outer edge
      Real t0 = 0.0;
      Real t1 = 1.0;
      if (dy != 0.0) {
        const Real low = j == 0 ? -HUGE_VAL : m_minY + j * m_cell - margin;
        const Real high = j == m_numJ - 1 ? HUGE_VAL : m_minY + (j + 1) * m_cell + margin;
        const Real ta = (low - y0) / dy;
        const Real tb = (high - y0) / dy;
        t0 = std::max(t0, std::min(ta, tb));
        t1 = std::min(t1, std::max(ta, tb));
      }
      if (t0 > t1) {
        continue;
      }
      const Real xa = x0 + t0 * dx;
      const Real xb = x0 + t1 * dx;
      visitRow(j, CellI(std::min(xa, xb) - margin), CellI(std::max(xa, xb) + margin));
    }
  };
  // a rounding more than the radius, so that a touched border counts
  const Real rounded = reach + 1e-9;
  const Real margin = SmallReach() + rounded;
  if (!m_shapes.empty()) {
    forRows(margin, [&](int j, int minI, int maxI) { VisitSmallRow(j, minI, maxI, visit); });
  }
  if (!m_overlayCells.empty()) {
    forRows(margin, [&](int j, int minI, int maxI) { VisitOverlayRow(j, minI, maxI, visit); });
  }
  if (!m_overlayWide.empty()) {
    forRows(rounded, [&](int j, int minI, int maxI) {
      VisitOverlayWide({minI, maxI, j, j}, visit);
    });
  }
  if (!m_wide.empty()) {
    forRows(rounded, [&](int j, int minI, int maxI) { VisitWide({minI, maxI, j, j}, visit); });
  }
}

}  // namespace argos

#endif
