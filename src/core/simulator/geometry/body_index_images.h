#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_INDEX_IMAGES_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_BODY_INDEX_IMAGES_H

#include <argos3/core/simulator/geometry/body_index.h>

// the queries of CBodyIndex in a periodic area: each is repeated where images of it may meet bodies

namespace argos {

template <typename QUERY>
void CBodyIndex::ForImages(const SPlanarArea& area, QUERY&& query) const {
  const Real out = std::max(SmallReach(), m_wideOutreach) + 1e-9;  // a rounding
  m_period.ForDisplacements(
      area, {m_area.MinX - out, m_area.MinY - out, m_area.MaxX + out, m_area.MaxY + out}, query);
}

// out of line, so that queries in other arenas are inlined as without it
template <typename VISIT>
[[gnu::noinline, gnu::cold]] void CBodyIndex::ForImagesNear(Real x, Real y, Real reach,
                                                            VISIT&& visit) const {
  ForImages({x - reach, y - reach, x + reach, y + reach}, [&](Real dx, Real dy) {
    ForShapesNearHere(x + dx, y + dy, reach,
                      [&](const SIndexedShape& shape) { visit(Displace(shape, -dx, -dy)); });
  });
}

template <typename VISIT>
[[gnu::noinline, gnu::cold]] void CBodyIndex::ForImagesInArea(const SPlanarArea& area,
                                                              const SHeightRange& heights,
                                                              VISIT&& visit) const {
  ForImages(area, [&](Real dx, Real dy) {
    ForShapesInAreaHere({area.MinX + dx, area.MinY + dy, area.MaxX + dx, area.MaxY + dy}, heights,
                        [&](const SIndexedShape& shape) { visit(Displace(shape, -dx, -dy)); });
  });
}

template <typename VISIT, typename DONE>
[[gnu::noinline, gnu::cold]] void CBodyIndex::ForImagesAlongRay(const CRay3& ray,
                                                                const SRayReach& reach,
                                                                VISIT&& visit,
                                                                DONE&& isDone) const {
  SPlanarArea area = SPlanarArea::Empty();
  area.Include(ray.GetStart().GetX(), ray.GetStart().GetY(), reach.Across, reach.Across);
  area.Include(ray.GetEnd().GetX(), ray.GetEnd().GetY(), reach.Across, reach.Across);
  ForImages(area, [&](Real dx, Real dy) {
    const CVector3 way(dx, dy, 0.0);
    ForShapesAlongRaysHere(
        std::array{CRay3(ray.GetStart() + way, ray.GetEnd() + way)}, reach,
        [&](const SIndexedShape& shape) { visit(Displace(shape, -dx, -dy)); }, isDone);
  });
}

}  // namespace argos

#endif
