#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_INDEX_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_INDEX_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/core/simulator/geometry/disc_list.h>
#include <argos3/core/simulator/geometry/height_range.h>
#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/simulator/geometry/ray_hit.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/ray_span.h>
#include <argos3/core/utility/spatial/cell_chains.h>
#include <argos3/core/utility/spatial/cell_items.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/core/utility/spatial/planar_grid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace argos {

class CEmbodiedEntity;
class CThreadPool;

/**
 * Finds the solids near a place, from packed arrays.
 *
 * Engines write the poses of origin anchors during physics. Rebuild() then reads them and sorts the
 * solids of small movable bodies by grid cell; solids of all other bodies are listed in every cell
 * that they touch. Bodies that are added or moved outside the physics phase are found through an
 * overlay of the same cells until the next Rebuild(), so placing n bodies takes time in proportion
 * to n. Queries never write: they are safe on any number of threads between rebuilds.
 *
 * Results do not depend on the cells: the solid and the ray alone decide about a hit.
 *
 * The index never dereferences an entity: Add() and Redescribe() pass what it needs of a body, and
 * it reads the pose through a pointer.
 */
class CBodyIndex {
 public:
  static constexpr UInt32 kNoBody = ~UInt32(0);
  /** m; a movable body up to this radius is small. Robots are; walls and large boxes are not. */
  static constexpr Real kMaxSmallRadius = 0.3;

  CBodyIndex() = default;

  /**
   * Sets the ground area that the cells divide, m. Border cells hold the bodies outside of it.
   * @param period  of the area: movable bodies are inside of it along its periodic axes. Queries
   * find all images of bodies, at the places of these.
   */
  void SetArea(const CRange<CVector3>& limits, const SPeriodicity& period = SPeriodicity());

  /**
   * Adds a body. CEmbodiedEntity::EnterIndex() calls it.
   * @param origin, description  must exist as long as the body is in the index.
   * @param links  poses of the links of an articulated body, see CEmbodiedEntity::GetLinkPoses();
   *               must exist as long; null for other bodies.
   * @return its number.
   */
  UInt32 Add(CEmbodiedEntity& body, const SBodyPose& origin, const SBodyDescription& description,
             bool movable, const SBodyPose* links = nullptr);
  void Remove(UInt32 body);
  /** Notes that an immovable body has been moved; outside the physics phase. */
  void NoteWideMoved() { m_wideDirty = true; }
  /** Makes queries see the present pose of a body; outside the physics phase, one thread. */
  void RefreshNow(UInt32 body);
  /** Makes queries see a changed description or movability. */
  void Redescribe(UInt32 body, const SBodyDescription& description, bool movable,
                  const SBodyPose* links = nullptr);
  /** @return true if bodies were added, or moved by RefreshNow(), since Rebuild(). */
  bool HasMovedBodies() const { return m_numStale > 0; }
  /** Sorts all solids by their current poses; once a tick, after physics. */
  void Rebuild(CThreadPool& pool) { Rebuild(&pool); }

  CEmbodiedEntity& GetBody(UInt32 body) const {
    CheckNumber(body);
    return *m_bodies[body].Entity;
  }
  template <typename VISIT>
  void ForEachBody(VISIT&& visit) const; /**< calls visit(CEmbodiedEntity&), by number */
  size_t GetNumBodies() const { return m_numAlive; }
  size_t GetEndOfNumbers() const { return m_bodies.size(); } /**< numbers of bodies are less */

  /**
   * Calls visit(const SIndexedShape&) for every solid whose footprint comes within @p reach (m) of
   * (@p x, @p y), and perhaps for others. Each solid once. Vertical position is ignored.
   */
  template <typename VISIT>
  void ForShapesNear(Real x, Real y, Real reach, VISIT&& visit) const;
  /**
   * The same, but upright discs that span the heights of @p query are mostly added to @p discs
   * instead, unless they are out of reach or of the ignored body. Visited solids may be either.
   * @param takeDiscs  void(): called when @p discs is full; empties it.
   */
  template <typename VISIT, typename TAKE_DISCS>
  void ListDiscsNear(const SDiscQuery& query, SDiscList& discs, TAKE_DISCS&& takeDiscs,
                     VISIT&& visit) const;
  /**
   * Calls visit(const SIndexedShape&) for every solid whose footprint touches @p area and that may
   * be at one of @p heights, and perhaps for others. Each solid once.
   */
  template <typename VISIT>
  void ForShapesInArea(const SPlanarArea& area, VISIT&& visit,
                       const SHeightRange& heights = SHeightRange::All()) const;
  /**
   * Calls visit(const SIndexedShape&) for every solid that comes within @p reach of a point of one
   * of @p rays, a range of CRay3, and perhaps for others; for wide ones perhaps repeatedly, and for
   * all if there are several rays. Ignores the parts of rays that are above or below all solids.
   * @param isDone  bool(): called before each row of cells; true ends the query.
   */
  template <typename RAYS, typename VISIT, typename DONE>
  void ForShapesAlongRays(const RAYS& rays, const SRayReach& reach, VISIT&& visit,
                          DONE&& isDone) const;
  /** The same for one ray, to its end. */
  template <typename VISIT>
  void ForShapesAlongRay(const CRay3& ray, const SRayReach& reach, VISIT&& visit) const {
    ForShapesAlongRays(std::array<CRay3, 1>{ray}, reach, visit, [] { return false; });
  }

  /** Where @p ray enters a solid: a fraction in [0,1], 0 if it starts inside; or kNoHit. */
  Real Intersect(const SIndexedShape& shape, const CRay3& ray) const;
  /** Finds the first body that @p ray meets, except @p ignored. @return false if none. */
  bool FindClosestHit(SEmbodiedEntityIntersectionItem& item, const CRay3& ray,
                      const CEmbodiedEntity* ignored = nullptr) const;
  /**
   * True if a third body is between two bodies: if it meets the part of @p segment that is outside
   * both of them. Exchanging the ends changes nothing but rounding.
   * @param segment  from a point of body @p start to one of body @p end: numbers, or kNoBody.
   */
  bool IsBlocked(const CRay3& segment, UInt32 start, UInt32 end) const;
  /**
   * A bound of the distance from (@p x, @p y) to the solids of a body, seen from above, m: none is
   * farther. Infinite for articulated bodies, 0 for kNoBody.
   */
  Real ComputeReach(UInt32 body, Real x, Real y) const;
  /** Appends every body that @p ray meets, once each. */
  void FindAllHits(TEmbodiedEntityIntersectionData& data, const CRay3& ray) const;
  /**
   * Finds a body that overlaps a solid of @p description at that pose by more than rounding.
   * @param ignored number of a body to leave out, or kNoBody.
   * @param links   poses of the links of the described body; null: as at the start.
   * @return the number of the body found with the lowest number, or kNoBody.
   */
  UInt32 FindOverlap(const SBodyDescription& description, const CVector3& position,
                     const CQuaternion& orientation, UInt32 ignored,
                     const SBodyPose* links = nullptr) const;

  /** Prefetches the lists that a query around a small body at (x, y), m, with that reach reads. */
  void LoadListsAhead(Real x, Real y, Real reach) const;

 private:
  struct SPose {
    Real X, Y, Z;  // m, world frame, of the origin anchor
    Real Cos, Sin;  // cosine and sine of the yaw, if upright
    bool Upright;
    bool Small = false;  // the body is small: sorted by cell
  };
  struct SBody {
    CEmbodiedEntity* Entity;  // null: free slot
    const SBodyPose* Origin;  // pose of the entity
    const SBodyDescription* Description;  // shared by many bodies; kept alive by the entity
    const SBodyPose* Links;  // poses of the links, by number; null unless articulated
    Real Reach;  // m, of the packed solids around the origin, seen from above, if upright
    Real TiltedReach;  // m, the same in any orientation
    UInt32 OverlayPlace;  // cell of a small body, number of a wide one's first solid in the overlay
    UInt16 NumShapes;
    bool Movable;
    bool Stale;  // is in the overlay: its sorted solids do not count
  };
  struct SEntry {
    UInt32 Body;
    UInt16 Shape;
  };
  struct SWideShape {
    SIndexedShape Shape;
    SPlanarCell FirstCell;  // cell in which it is listed
  };

  // where invariants are checked: that it is the number of a body that is in the index
  void CheckNumber(UInt32 body) const;

  SCellRange CellsOf(const SIndexedShape& shape) const;
  // a wide solid counts in one of the cells in which a query finds it
  bool CountsInCell(UInt32 cell, const SWideShape& wide, const SCellRange& query) const {
    return m_grid.IsFirstCommon(cell, wide.FirstCell, query);
  }
  static SPose MakePose(const CVector3& position, const CQuaternion& orientation);
  static SIndexedShape Pack(const SShapeDescription& shape, const SPose& pose,
                            const CQuaternion& orientation, UInt32 body = kNoBody,
                            UInt16 number = 0);
  SIndexedShape Pack(UInt32 body, UInt16 shape) const;
  SIndexedShape Unpack(size_t place) const;  // a solid in the order of the cells
  // pose of the body frame, moved along with the link of a solid
  static SBodyPose PoseOf(const SBody& body, const SShapeDescription& solid);
  void ReadPose(UInt32 body);
  void Describe(UInt32 body);
  void Forget(UInt32 body);
  void Rebuild(CThreadPool* pool);
  bool ChooseCells();
  void SortSmall(CThreadPool* pool);
  void ListSorted(CThreadPool* pool, UInt32 numShapes);
  void PackSmall(CThreadPool* pool);
  void ListWide();
  void IncludeWide(const SIndexedShape& shape);
  void ClearOverlay();
  void PutInOverlay(UInt32 body);
  void LinkIntoOverlay(UInt32 body);
  void LinkWideIntoOverlay(UInt32 body);

  // calls query(dx, dy) for each displacement of an area to where bodies may be
  template <typename QUERY>
  void ForImages(const SPlanarArea& area, QUERY&& query) const;
  // of the image of a solid from the solid itself, m
  CVector3 FindDisplacement(const SIndexedShape& shape) const;
  template <typename VISIT>
  void ForImagesNear(Real x, Real y, Real reach, VISIT&& visit) const;
  template <typename VISIT>
  void ForImagesInArea(const SPlanarArea& area, const SHeightRange& heights, VISIT&& visit) const;
  template <typename VISIT, typename DONE>
  void ForImagesAlongRay(const CRay3& ray, const SRayReach& reach, VISIT&& visit,
                         DONE&& isDone) const;
  template <typename VISIT>
  void ForShapesNearHere(Real x, Real y, Real reach, VISIT&& visit) const;
  template <typename VISIT>
  void ForShapesInAreaHere(const SPlanarArea& area, const SHeightRange& heights,
                           VISIT&& visit) const;
  template <typename RAYS, typename VISIT, typename DONE>
  void ForShapesAlongRaysHere(const RAYS& rays, const SRayReach& reach, VISIT&& visit,
                              DONE&& isDone) const;
  Real SmallReach() const { return std::max(m_maxSmallReach, m_tiltedReach); }
  bool IsStale(UInt32 body) const { return m_numStale > 0 && m_bodies[body].Stale; }
  // cells no farther than the margin, m, from an area
  SCellRange CellsAround(const SPlanarArea& area, Real margin) const;
  // counts(const auto& shape): false for a solid or packed solid that is not to be visited
  template <typename COUNTS, typename VISIT>
  void VisitNear(const SCellRange& small, const SCellRange& wide, const SHeightRange& heights,
                 COUNTS&& counts, VISIT&& visit) const;
  template <typename VISIT>
  void VisitUnsorted(const SCellRange& small, const SCellRange& wide, VISIT&& visit) const;
  static bool CountAny(const SPackedShape&) { return true; }
  template <typename COUNTS, typename VISIT>
  void VisitSmall(const SCellRange& cells, COUNTS&& counts, VISIT&& visit) const;
  template <typename VISIT, typename TAKE_DISCS>
  void ListSmall(const SCellRange& cells, const SDiscQuery& query, SDiscList& discs,
                 TAKE_DISCS&& takeDiscs, VISIT&& visit) const;
  template <typename VISIT>
  void VisitBody(UInt32 body, VISIT&& visit) const;
  template <typename VISIT>
  void VisitOverlay(const SCellRange& small, const SCellRange& wide, VISIT&& visit) const;
  template <typename VISIT>
  void VisitWide(const SCellRange& cells, VISIT&& visit) const;
  bool FindOccluder(SIndexedShape& found, const CRay3& segment, UInt32 start, UInt32 end) const;
  Real IntersectBody(UInt32 body, const CRay3& ray) const;

  SPlanarArea m_area;
  SPeriodicity m_period;
  CPlanarGrid<> m_grid;
  size_t m_cellsChosenFor = 0;  // number of bodies when cells were chosen
  Real m_cellsChosenReach = 0.0;  // m, m_maxSmallReach then

  std::vector<SBody> m_bodies;  // indexed by body number
  std::vector<SPose> m_poses;  // indexed by body number; as of Rebuild() or RefreshNow()
  std::vector<UInt32> m_free;  // numbers to use again
  std::vector<UInt32> m_released;  // numbers to use again after the next Rebuild()
  size_t m_numAlive = 0;
  Real m_maxSmallReach = 0.0;  // m, of all that ever were small; how far solids of an upright small
                               // body may be from the cell that it is sorted into
  Real m_tiltedReach = 0.0;  // m, the same for the small bodies that are tilted now

  // written by Rebuild()
  CCountingSort m_sort;  // sorts small bodies by cell
  std::vector<SEntry> m_entries;  // (solids of small bodies) in cell order
  std::vector<SPackedShape> m_shapes;  // shapes of small bodies, in cell order
  std::vector<SBoxSides> m_sides;  // sides of the same solids; empty unless m_hasSmallBoxes
  bool m_hasSmallBoxes = false;  // some small body had a solid that is a box
  SHeightRange m_smallHeights;  // of m_shapes
  std::vector<SWideShape> m_wide;  // of all other bodies
  SHeightRange m_wideHeights;  // of m_wide
  Real m_wideOutreach = 0.0;  // m; how far wide bodies are outside of the area, at most
  CCellItems m_wideCells;  // numbers into m_wide
  bool m_wideDirty = true;

  // the overlay
  CCellChains m_overlay;  // small bodies
  std::vector<SWideShape> m_overlayWide;  // shapes of wide bodies; those of one are adjacent
  CCellChains m_overlayWideCells;  // numbers into m_overlayWide; perhaps without cells
  size_t m_numStale = 0;
};

}  // namespace argos

#include <argos3/core/simulator/geometry/body_index_impl.h>
#include <argos3/core/simulator/geometry/body_index_images.h>

#endif
