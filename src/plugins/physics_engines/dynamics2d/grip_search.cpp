#include <argos3/plugins/simulator/physics_engines/dynamics2d/grip_search.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/convex_polygon.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

SPlanarVector FindNearestPoint(const SFootprint& footprint, const SPlanarVector& point) {
  const Real x = point.X - footprint.X;
  const Real y = point.Y - footprint.Y;
  if (footprint.Radius > 0.0) {
    const Real distance = std::hypot(x, y);
    const Real share = distance > footprint.Radius ? footprint.Radius / distance : 1.0;
    return {footprint.X + share * x, footprint.Y + share * y};
  }
  SPlanarVector inFrame = RotateIntoFrame(footprint, x, y);
  if (footprint.Polygon != nullptr) {
    const SPolygonNearest nearest = FindNearest(*footprint.Polygon, CVector2(inFrame.X, inFrame.Y));
    if (nearest.Distance > 0.0) {
      inFrame = {nearest.Point.GetX(), nearest.Point.GetY()};
    }
  } else {
    inFrame.X = std::clamp(inFrame.X, -footprint.HalfX, footprint.HalfX);
    inFrame.Y = std::clamp(inFrame.Y, -footprint.HalfY, footprint.HalfY);
  }
  const SPlanarVector offset = RotateOutOfFrame(footprint, inFrame.X, inFrame.Y);
  return {footprint.X + offset.X, footprint.Y + offset.Y};
}

class CGripSearch {
 public:
  CGripSearch(const SPlanarVector& centre, Real radius) : m_centre(centre), m_nearest(radius) {}

  const std::optional<SGripPlace>& GetPlace() const { return m_place; }

  void Visit(const SPlanarOwner& owner, const SFootprint& part) {
    const SPlanarVector point = FindNearestPoint(part, m_centre);
    const Real distance = std::hypot(point.X - m_centre.X, point.Y - m_centre.Y);
    const bool isFirst = !m_place && distance <= m_nearest;
    if (isFirst || distance < m_nearest ||
        (m_place && distance == m_nearest &&
         owner.Body->GetIndex() < m_place->Owner.Body->GetIndex())) {
      m_nearest = distance;
      m_place = {owner, point};
    }
  }

 private:
  SPlanarVector m_centre;
  Real m_nearest;
  std::optional<SGripPlace> m_place;
};

}  // namespace

std::optional<SGripPlace> FindGripPlace(const CPlanarStore& store, const CDiscPairs& discPairs,
                                        CCrowdSolids& solids, const SPlanarVector& centre,
                                        Real radius, const SPlanarHandle& own) {
  CGripSearch search(centre, radius);
  const SPeriodicity& period = store.GetSettings().Period;
  discPairs.ForNear(centre.X, centre.Y, radius, [&](UInt32 place) {
    const CDiscPairs::SDisc& disc = discPairs.GetDiscs()[place];
    const SDrivenBody& body = store.GetDriven()[disc.Number];
    if (body.IsGrippable && *body.Owner.Handle != own) {
      const SPlanarVector image = FindNearestImage(period, disc.X, disc.Y, centre.X, centre.Y);
      search.Visit(body.Owner,
                   {disc.X + image.X, disc.Y + image.Y, 1.0, 0.0, 0.0, 0.0, disc.Radius});
    }
  });
  solids.ForNear(centre.X, centre.Y, radius, [&](UInt32 item) {
    const CCrowdSolids::SSolid& solid = solids.GetSolid(item);
    const SPlanarOwner& owner = solid.Kind == EPlanarKind::Driven
                                    ? store.GetDriven()[solid.Slot].Owner
                                    : store.GetPassive()[solid.Slot].Owner;
    if (!store.IsGrippable(*owner.Handle) || *owner.Handle == own) {
      return;
    }
    const SPlanarVector image = FindNearestImage(period, solid.X, solid.Y, centre.X, centre.Y);
    for (size_t part = 0; part < solid.Shape->Parts.size(); ++part) {
      search.Visit(owner, Displace(solids.GetParts()[solid.FirstPart + part], image.X, image.Y));
    }
  });
  return search.GetPlace();
}

}  // namespace argos
