#ifndef ARGOS3_CORE_SIMULATOR_SPACE_BODY_INDEX_H
#define ARGOS3_CORE_SIMULATOR_SPACE_BODY_INDEX_H

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/simulator/space/indexed_shape.h>
#include <argos3/core/utility/math/range.h>

#include <algorithm>
#include <vector>

namespace argos {

class CEmbodiedEntity;
class CLookAhead;
class CThreadPool;
struct SAnchor;

/**
 * Answers "which solids are near here" from packed arrays.
 *
 * Engines write the poses of origin anchors during physics. Rebuild() then reads them, and sorts
 * the solids of small movable bodies by grid cell, by counting; solids of all other bodies are
 * listed in every cell that they touch. Bodies that are added or moved outside the physics phase
 * are found through an overlay of the same cells until the next Rebuild(), so placing n bodies
 * takes time in proportion to n. Queries never write: they are safe on any number of threads
 * between rebuilds.
 *
 * Answers do not depend on the cells: a hit is decided by the solid and the ray alone.
 */
class CBodyIndex {
 public:
  static constexpr UInt32 kNoBody = ~UInt32(0);
  /** m; a movable body up to this radius is small. Robots are; walls and large boxes are not. */
  static constexpr Real kMaxSmallRadius = 0.3;

  CBodyIndex() = default;

  /** Sets the ground area that the cells divide, m. Bodies outside belong to the border cells. */
  void SetArea(const CRange<CVector3>& limits);

  /** Adds a body that has a description. @return its number. */
  UInt32 Add(CEmbodiedEntity& body);
  void Remove(UInt32 body);
  /** An immovable body has been moved: outside the physics phase. */
  void NoteWideMoved() { m_wideDirty = true; }
  /** Makes the pose of the body's origin count at once; outside the physics phase, one thread. */
  void RefreshNow(UInt32 body);
  /** Takes over a changed description or movability at once. */
  void Redescribe(UInt32 body);
  /** Sorts everything anew; once a tick, after physics. */
  void Rebuild(CThreadPool& pool) { Rebuild(&pool); }

  CEmbodiedEntity& GetBody(UInt32 body) const { return *m_bodies[body].Entity; }
  /** Calls visit(CEmbodiedEntity&) for every body, by number. */
  template <typename VISIT>
  void ForEachBody(VISIT&& visit) const {
    for (const SBody& body : m_bodies) {
      if (body.Entity != nullptr) {
        visit(*body.Entity);
      }
    }
  }
  size_t GetNumBodies() const { return m_numAlive; }

  /**
   * Calls visit(const SIndexedShape&) for every solid whose footprint comes within @p reach (m) of
   * (@p x, @p y), and perhaps for some that do not. Each solid once. Vertical position is ignored.
   */
  template <typename VISIT>
  void ForShapesNear(Real x, Real y, Real reach, VISIT&& visit) const;
  /**
   * Calls visit(const SIndexedShape&) for every solid whose footprint comes within @p reach (m) of
   * @p ray as seen from above, and for some that do not; wide solids perhaps repeatedly.
   * @param isDone  bool(): asked now and then; true if no more solids are of interest.
   */
  template <typename VISIT, typename DONE>
  void ForShapesAlongRay(const CRay3& ray, Real reach, VISIT&& visit, DONE&& isDone) const;
  template <typename VISIT>
  void ForShapesAlongRay(const CRay3& ray, Real reach, VISIT&& visit) const {
    ForShapesAlongRay(ray, reach, visit, [] { return false; });
  }

  /** Where @p ray enters a solid of any kind: fraction in [0,1], 0 if it starts inside; else > 1.
   */
  Real Intersect(const SIndexedShape& shape, const CRay3& ray) const;
  /** First body that @p ray meets, @p ignored aside. @return false if none. */
  bool FindClosestHit(SEmbodiedEntityIntersectionItem& item, const CRay3& ray,
                      const CEmbodiedEntity* ignored = nullptr) const;
  /**
   * True if a third body stands between two bodies: if it meets the part of @p segment that is
   * outside both of them. Exchanging the ends changes nothing but rounding.
   * @param segment  from a point of the body @p start to one of the body @p end, which are numbers
   *                 or kNoBody.
   */
  bool IsBlocked(const CRay3& segment, UInt32 start, UInt32 end) const;
  /** Appends every body that @p ray meets, once each. */
  void FindAllHits(TEmbodiedEntityIntersectionData& data, const CRay3& ray) const;
  /**
   * Finds a body that overlaps a solid of @p description at that pose by more than a rounding.
   * @param ignored number of a body to look through, or kNoBody.
   * @return the number of the body found with the lowest number, or kNoBody.
   */
  UInt32 FindOverlap(const SBodyDescription& description, const CVector3& position,
                     const CQuaternion& orientation, UInt32 ignored) const;

 private:
  friend class CLookAhead;

  struct SPose {
    Real X, Y, Z;  // m, world frame, of the origin anchor
    Real Cos, Sin;  // of the yaw, if upright
    bool Upright;
  };
  struct SBody {
    CEmbodiedEntity* Entity;  // null: free slot
    const SAnchor* Origin;  // of the entity
    const SBodyDescription* Description;  // shared by many bodies; kept alive by the entity
    Real Reach;  // m, of the packed solids around the origin, seen from above, if upright
    Real TiltedReach;  // m, the same however the body lies
    UInt32 OverlayPlace;  // cell of a small body, number of a wide one's first solid in the overlay
    UInt32 NextInCell;  // overlay chain of small bodies
    UInt16 NumShapes;
    bool Stale;  // in the overlay: its sorted solids do not count
    bool Small;  // sorted by cell; false for a free slot
  };
  // where the lists of a cell begin; they end where those of the next cell begin
  struct SCellStart {
    UInt32 Small;  // into m_shapes
    UInt32 Wide;  // into m_wideItems
  };
  struct SCellRange {
    int MinI, MaxI, MinJ, MaxJ;
  };
  struct SWideShape {
    SIndexedShape Shape;
    int MinI, MinJ;  // first cell in which it is listed
  };
  // a cell that a wide solid of the overlay touches
  struct SOverlayLink {
    UInt32 Wide;  // into m_overlayWide
    UInt32 Next;  // of the same cell, or kNoBody
  };

  int CellI(Real x) const { return ClampCell((x - m_minX) * m_inverseCell, m_numI); }
  int CellJ(Real y) const { return ClampCell((y - m_minY) * m_inverseCell, m_numJ); }
  static int ClampCell(Real cell, int count) {
    // the comparison in floating point keeps far-away and NaN positions inside the table
    return cell > 0.0 ? (cell < count ? static_cast<int>(cell) : count - 1) : 0;
  }
  UInt32 CellOf(const CVector3& position) const {
    return static_cast<UInt32>(CellJ(position.GetY()) * m_numI + CellI(position.GetX()));
  }
  SCellRange CellsAround(Real x, Real y, Real reach) const {
    return {CellI(x - reach), CellI(x + reach), CellJ(y - reach), CellJ(y + reach)};
  }
  SCellRange CellsOf(const SIndexedShape& shape) const;
  template <typename VISIT>
  void ForCells(const SCellRange& cells, VISIT&& visit) const {
    for (int j = cells.MinJ; j <= cells.MaxJ; ++j) {
      for (int i = cells.MinI; i <= cells.MaxI; ++i) {
        visit(static_cast<size_t>(j) * m_numI + i);
      }
    }
  }
  // a shape that several cells list counts in the first of those that a query looks at
  static bool IsFirst(int i, int j, const SWideShape& wide, const SCellRange& cells) {
    return i == std::max(wide.MinI, cells.MinI) && j == std::max(wide.MinJ, cells.MinJ);
  }
  static bool IsUpright(const CQuaternion& orientation);
  static SPose MakePose(const CVector3& position, const CQuaternion& orientation);
  static SIndexedShape Pack(const SShapeDescription& shape, const SPose& pose,
                            const CQuaternion& orientation);
  SIndexedShape Pack(UInt32 body, UInt16 shape) const;
  void Describe(UInt32 body);
  void Forget(UInt32 body);
  void Rebuild(CThreadPool* pool);
  bool ChooseCells();
  UInt32 TurnCountsIntoStarts(UInt32 SCellStart::*list);
  void SortSmall(CThreadPool* pool);
  void ListWide();
  void ClearOverlay();
  void PutInOverlay(UInt32 body);
  void LinkIntoOverlay(UInt32 body);
  void LinkWideIntoOverlay(UInt32 body);

  Real SmallReach() const { return std::max(m_maxSmallReach, m_tiltedReach); }
  bool IsStale(UInt32 body) const { return m_numStale > 0 && m_bodies[body].Stale; }
  template <typename VISIT>
  void VisitSmallRow(int j, int minI, int maxI, VISIT&& visit) const;
  template <typename VISIT>
  void VisitBody(UInt32 body, VISIT&& visit) const;
  template <typename VISIT>
  void VisitOverlayRow(int j, int minI, int maxI, VISIT&& visit) const;
  template <typename VISIT>
  void VisitOverlayWide(const SCellRange& cells, VISIT&& visit) const;
  template <typename VISIT>
  void VisitWide(const SCellRange& cells, VISIT&& visit) const;
  bool FindThird(SIndexedShape& found, const CRay3& segment, UInt32 start, UInt32 end) const;
  Real IntersectBody(UInt32 body, const CRay3& ray) const;

  // the area and its cells, row by row: cell (i, j) has number j * m_numI + i
  Real m_minX = 0.0, m_minY = 0.0, m_maxX = 0.0, m_maxY = 0.0;  // m
  Real m_cell = 1.0, m_inverseCell = 1.0;  // m, 1/m
  int m_numI = 1, m_numJ = 1;
  size_t m_cellsChosenFor = 0;  // number of bodies when cells were chosen
  Real m_cellsChosenReach = 0.0;

  std::vector<SBody> m_bodies;  // by body number
  std::vector<UInt32> m_free;  // numbers to use again
  std::vector<UInt32> m_released;  // numbers to use again after the next Rebuild()
  size_t m_numAlive = 0;
  Real m_maxSmallReach = 0.0;  // m, of all that ever were small; how far solids of an upright small
                               // body may be from the cell that it is sorted into
  Real m_tiltedReach = 0.0;  // m, the same for the small bodies that are tilted now

  // written by Rebuild()
  std::vector<UInt32> m_cellOfBody;  // (bodies); kNoBody if not small
  std::vector<SCellStart> m_cellStart;  // (cells + 1)
  std::vector<UInt32> m_cursor;  // (cells) scratch of the counting sort
  std::vector<UInt32> m_placeOfBody;  // (bodies) of its first solid in m_shapes, if small
  std::vector<SIndexedShape> m_shapes;  // of small bodies, in cell order
  std::vector<SWideShape> m_wide;  // of all other bodies
  std::vector<UInt32> m_wideItems;  // numbers into m_wide
  bool m_wideDirty = true;

  // the overlay
  std::vector<UInt32> m_overlayHead;  // (cells) first small body of the chain, or kNoBody
  std::vector<UInt32> m_overlayCells;  // cells with a chain
  std::vector<SWideShape> m_overlayWide;  // of bodies that are not small; those of one in a row
  std::vector<UInt32> m_overlayWideHead;  // (cells) into m_overlayLinks, or kNoBody; perhaps empty
  std::vector<UInt32> m_overlayWideCells;  // cells with a chain of such solids
  std::vector<SOverlayLink> m_overlayLinks;
  size_t m_numStale = 0;
};

}  // namespace argos

#include <argos3/core/simulator/space/body_index_impl.h>

#endif
