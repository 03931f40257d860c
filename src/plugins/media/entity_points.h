#ifndef ARGOS3_PLUGINS_MEDIA_ENTITY_POINTS_H
#define ARGOS3_PLUGINS_MEDIA_ENTITY_POINTS_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/core/utility/spatial/planar_grid.h>

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
    CVector3 Position; /**< m, world frame, when it was added */
    ENTITY* Entity; /**< is not owned */
    const CEntity* Root; /**< its root entity */
    ssize_t Index; /**< its CEntity::GetIndex() */
  };

  /** Removes all points, and allocates for a number of them. */
  void Start(size_t maxPoints) {
    m_isComplete = false;
    m_unsorted.clear();
    if (m_unsorted.capacity() < maxPoints) {
      const size_t capacity = maxPoints + maxPoints / 2;
      m_unsorted.reserve(capacity);
      m_points.reserve(capacity);
      m_sort.Reserve(capacity, CPlanarGrid<>::MaxCells(capacity));
    }
  }
  void Add(ENTITY& entity) {
    m_unsorted.push_back(
        {entity.GetPosition(), &entity, &entity.GetRootEntity(), entity.GetIndex()});
  }
  /** Sorts the points. */
  void Finish() {
    SPlanarArea area = SPlanarArea::Empty();
    for (const SPoint& point : m_unsorted) {
      area.Include(point.Position.GetX(), point.Position.GetY());
    }
    if (m_unsorted.empty()) {
      area = SPlanarArea();
    }
    m_grid.Cover(area, kMinEdge, CPlanarGrid<>::AimedCells(m_unsorted.size() / kPointsPerCell));
    m_sort.Start(m_unsorted.size(), m_grid.GetNumCells());
    for (size_t i = 0; i < m_unsorted.size(); ++i) {
      const CVector3& position = m_unsorted[i].Position;
      m_sort.SetKey(i, m_grid.CellAt(position.GetX(), position.GetY()));
    }
    m_points.resize(m_sort.Finish());
    for (size_t i = 0; i < m_unsorted.size(); ++i) {
      m_points[m_sort.GetPlace(i)] = m_unsorted[i];
    }
    m_isComplete = true;
  }
  /** Makes the points unusable until they are started and finished again. */
  void Invalidate() { m_isComplete = false; }
  /** @return true if the points are those of the medium's last update. */
  bool IsComplete() const { return m_isComplete; }

  /** Calls visit(const SPoint&) for every point in a box, m, and for others. Each point once. */
  template <typename VISIT>
  void ForPointsNear(const SBoundingBox& box, VISIT&& visit) const {
    const SCellRange cells = {
        m_grid.GetX().CellOf(box.MinCorner.GetX()), m_grid.GetX().CellOf(box.MaxCorner.GetX()),
        m_grid.GetY().CellOf(box.MinCorner.GetY()), m_grid.GetY().CellOf(box.MaxCorner.GetY())};
    m_grid.ForRows(cells, [&](UInt32 first, UInt32 last) {
      const UInt32 end = m_sort.End(last);
      for (UInt32 place = m_sort.Begin(first); place < end; ++place) {
        visit(m_points[place]);
      }
    });
  }

 private:
  static constexpr Real kMinEdge = 0.05;  // m
  static constexpr size_t kPointsPerCell = 4;

  bool m_isComplete = false;
  std::vector<SPoint> m_unsorted;  // have the order of Add()
  std::vector<SPoint> m_points;  // have the order of the cells
  CPlanarGrid<> m_grid;
  CCountingSort m_sort;
};

}  // namespace argos

#endif
