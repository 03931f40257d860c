#ifndef ARGOS3_PLUGINS_MEDIA_ENTITY_POINTS_H
#define ARGOS3_PLUGINS_MEDIA_ENTITY_POINTS_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/core/utility/spatial/planar_grid.h>
#include <argos3/plugins/simulator/media/view_volume.h>

#include <vector>

namespace argos {

/**
 * Positions of the entities of a medium in packed arrays, sorted by cells of the ground plane: a
 * camera rejects most entities near it without reading them, which are scattered in memory.
 *
 * Queries may run on several threads at once; no other function may.
 */
template <class ENTITY>
class CEntityPoints {
 public:
  struct SPoint {
    ENTITY* Entity; /**< is not owned */
    const CEntity* Root; /**< its root entity */
    ssize_t Index; /**< its CEntity::GetIndex() */
  };

  /** Removes all points, and allocates for a number of them. */
  void Start(size_t maxPoints) {
    m_isComplete = false;
    m_unsorted.clear();
    m_positions.clear();
    if (m_unsorted.capacity() < maxPoints) {
      const size_t capacity = maxPoints + maxPoints / 2;
      m_unsorted.reserve(capacity);
      m_positions.reserve(capacity);
      m_points.reserve(capacity);
      for (std::vector<Real>* coordinates : {&m_x, &m_y, &m_z}) {
        coordinates->reserve(capacity + CViewVolume::kBlock);
      }
      m_sort.Reserve(capacity, CPlanarGrid<>::MaxCells(capacity));
    }
  }
  void Add(ENTITY& entity) {
    m_unsorted.push_back({&entity, &entity.GetRootEntity(), entity.GetIndex()});
    m_positions.push_back(entity.GetPosition());
  }
  /** Sorts the points. */
  void Finish() {
    SPlanarArea area = SPlanarArea::Empty();
    for (const CVector3& position : m_positions) {
      area.Include(position.GetX(), position.GetY());
    }
    if (m_positions.empty()) {
      area = SPlanarArea();
    }
    m_grid.Cover(area, kMinEdge, CPlanarGrid<>::AimedCells(m_positions.size() / kPointsPerCell));
    m_sort.Start(m_positions.size(), m_grid.GetNumCells());
    for (size_t i = 0; i < m_positions.size(); ++i) {
      m_sort.SetKey(i, m_grid.CellAt(m_positions[i].GetX(), m_positions[i].GetY()));
    }
    m_points.resize(m_sort.Finish());
    for (std::vector<Real>* coordinates : {&m_x, &m_y, &m_z}) {
      coordinates->resize(m_points.size() + CViewVolume::kBlock);
    }
    for (size_t i = 0; i < m_positions.size(); ++i) {
      const size_t place = m_sort.GetPlace(i);
      m_points[place] = m_unsorted[i];
      m_x[place] = m_positions[i].GetX();
      m_y[place] = m_positions[i].GetY();
      m_z[place] = m_positions[i].GetZ();
    }
    m_isComplete = true;
  }
  /** Makes the points unusable until they are started and finished again. */
  void Invalidate() { m_isComplete = false; }
  /** @return true if the points are those of the medium's last update. */
  bool IsComplete() const { return m_isComplete; }

  /** Calls visit(const SPoint&) for every point whose position, when it was added, is inside. */
  template <typename VISIT>
  void ForPointsInside(const CViewVolume& volume, VISIT&& visit) const {
    const CVector3& min = volume.GetBox().MinCorner;
    const CVector3& max = volume.GetBox().MaxCorner;
    const SCellRange cells = {m_grid.GetX().CellOf(min.GetX()), m_grid.GetX().CellOf(max.GetX()),
                              m_grid.GetY().CellOf(min.GetY()), m_grid.GetY().CellOf(max.GetY())};
    m_grid.ForRows(cells, [&](UInt32 first, UInt32 last) {
      const UInt32 end = m_sort.End(last);
      for (UInt32 place = m_sort.Begin(first); place < end; place += CViewVolume::kBlock) {
        UInt64 inside = volume.FindInside(&m_x[place], &m_y[place], &m_z[place]);
        if (end - place < CViewVolume::kBlock) {
          // the rest are points of other rows
          inside &= (UInt64(1) << (end - place)) - 1;
        }
        for (; inside != 0; inside &= inside - 1) {
          visit(m_points[place + static_cast<UInt32>(__builtin_ctzll(inside))]);
        }
      }
    });
  }

 private:
  static constexpr Real kMinEdge = 0.05;  // m
  static constexpr size_t kPointsPerCell = 4;

  bool m_isComplete = false;
  // have the order of Add()
  std::vector<SPoint> m_unsorted;
  std::vector<CVector3> m_positions;  // m, world frame
  // have the order of the cells
  std::vector<SPoint> m_points;
  std::vector<Real> m_x, m_y, m_z;  // m, world frame; as many unused elements follow as are tested
                                    // at once
  CPlanarGrid<> m_grid;
  CCountingSort m_sort;
};

}  // namespace argos

#endif
