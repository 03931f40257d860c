#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_HASH_INDEX_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_HASH_INDEX_H

#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#include <argos3/core/simulator/space/positional_indices/space_hash.h>

#include <cmath>

namespace argos {

/**
 * A space hash behind the interface of positional indices: memory in proportion to the entities,
 * however far apart they are.
 *
 * A query over more cells than there are entities visits all entities instead.
 * @tparam UPDATER  a CSpaceHashUpdater<ENTITY> that needs no arguments.
 */
template <class ENTITY, class UPDATER>
class CHashIndex : public CPositionalIndex<ENTITY> {
 public:
  typedef typename CPositionalIndex<ENTITY>::COperation COperation;

  /** @param cellSize m. @throws CARGoSException if a component is not > 0. */
  explicit CHashIndex(const CVector3& cellSize) { m_hash.SetCellSize(cellSize); }

  CAbstractSpaceHash<ENTITY>& GetHash() { return m_hash; }

  void AddEntity(ENTITY& entity) override { m_hash.AddElement(entity); }
  void RemoveEntity(ENTITY& entity) override { m_hash.RemoveElement(entity); }
  void Update() override { m_hash.Update(); }
  void Reset() override { m_hash.Update(); }

  void GetEntitiesAt(CSet<ENTITY*, SEntityComparator>& entities,
                     const CVector3& position) const override {
    entities.clear();
    const SCellNumber cell = m_hash.GetLattice().CellOf(position);
    m_hash.VisitCell(cell.Axis[0], cell.Axis[1], cell.Axis[2], [&entities](ENTITY& entity) {
      entities.insert(&entity);
      return true;
    });
  }

  void ForAllEntities(COperation& operation) override { m_hash.GetElements().ForAll(operation); }

  void ForEntitiesInBoxRange(const CVector3& center, const CVector3& halfSize,
                             COperation& operation) override {
    const SCellNumber min = m_hash.GetLattice().CellOf(center - halfSize);
    const SCellNumber max = m_hash.GetLattice().CellOf(center + halfSize);
    if (CountCells(min, max) > static_cast<Real>(m_hash.GetElements().GetNumEntities())) {
      ForAllEntities(operation);
      return;
    }
    ForCellsInBox(min, max, [&](SInt32 i, SInt32 j, SInt32 k) {
      return m_hash.VisitCell(i, j, k, operation);
    });
  }

  void ForEntitiesAlongRay(const CRay3& ray, COperation& operation,
                           bool stopAtClosestMatch = false) override {
    const SCellNumber start = m_hash.GetLattice().CellOf(ray.GetStart());
    const SCellNumber end = m_hash.GetLattice().CellOf(ray.GetEnd());
    if (CountSteps(start, end) > static_cast<Real>(m_hash.GetElements().GetNumEntities())) {
      m_hash.GetElements().ForAll(
          [&](ENTITY& entity) { return operation(entity) || stopAtClosestMatch; });
      return;
    }
    WalkLattice(m_hash.GetLattice(), ray, [&](const SCellNumber& cell) {
      bool goOn = true;
      m_hash.VisitCell(cell.Axis[0], cell.Axis[1], cell.Axis[2], [&](ENTITY& entity) {
        goOn = operation(entity) && goOn;
        return goOn || stopAtClosestMatch;
      });
      return goOn;
    });
  }

 private:
  // compared as a real number: integers would overflow
  static Real CountCells(const SCellNumber& min, const SCellNumber& max) {
    Real count = 1.0;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      count *= static_cast<Real>(max.Axis[axis]) - min.Axis[axis] + 1.0;
    }
    return count;
  }

  static Real CountSteps(const SCellNumber& start, const SCellNumber& end) {
    Real count = 0.0;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      count += std::abs(static_cast<Real>(end.Axis[axis]) - start.Axis[axis]);
    }
    return count;
  }

  CSpaceHash<ENTITY, UPDATER> m_hash;
};

}  // namespace argos

#endif
