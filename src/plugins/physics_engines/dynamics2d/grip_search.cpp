#include <argos3/plugins/simulator/physics_engines/dynamics2d/grip_search.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <box2d/b2_distance.h>

namespace argos {

namespace {

// the point of the described solid of a fixture that is nearest to a point
b2Vec2 ComputeNearestPoint(const b2Fixture& fixture, const b2Vec2& point) {
  const b2Transform& frame = fixture.GetBody()->GetTransform();
  if (fixture.GetType() == b2Shape::e_circle) {
    const auto& disc = static_cast<const b2CircleShape&>(*fixture.GetShape());
    b2Vec2 outward = point - b2Mul(frame, disc.m_p);
    const float outside = outward.Normalize() - (disc.m_radius - kShapeMargin);
    return outside > 0.0F ? point - outside * outward : point;
  }
  b2DistanceInput input;
  input.proxyA.Set(fixture.GetShape(), 0);
  input.proxyB.Set(&point, 1, 0.0F);
  input.transformA = frame;
  input.transformB.SetIdentity();
  input.useRadii = false;
  b2SimplexCache cache;
  cache.count = 0;
  b2DistanceOutput output;
  b2Distance(&output, &cache, &input);
  return output.pointA;
}

class CGripSearch : public b2QueryCallback {
 public:
  CGripSearch(const b2Vec2& centre, float radius, const std::vector<SPlanarOwner>& grippable,
              const b2Body& own)
      : m_centre(centre), m_nearest(radius), m_grippable(grippable), m_own(own) {}

  const SGripPlace& GetPlace() const { return m_place; }

  bool ReportFixture(b2Fixture* fixture) override {
    b2Body& body = *fixture->GetBody();
    if (&body == &m_own || m_grippable[GetBodyNumber(body)].Body == nullptr) {
      return true;
    }
    const b2Vec2 point = ComputeNearestPoint(*fixture, m_centre);
    const float distance = b2Distance(point, m_centre);
    const bool isFirst = m_place.Body == nullptr && distance <= m_nearest;
    if (isFirst || distance < m_nearest ||
        (distance == m_nearest && GetIndex(body) < GetIndex(*m_place.Body))) {
      m_nearest = distance;
      m_place = {&body, point};
    }
    return true;
  }

 private:
  ssize_t GetIndex(b2Body& body) const { return m_grippable[GetBodyNumber(body)].Body->GetIndex(); }

  b2Vec2 m_centre;
  float m_nearest;
  const std::vector<SPlanarOwner>& m_grippable;
  const b2Body& m_own;
  SGripPlace m_place;
};

}  // namespace

SGripPlace FindGripPlace(const b2World& world, const b2Vec2& centre, float radius,
                         const std::vector<SPlanarOwner>& grippable, const b2Body& own) {
  CGripSearch search(centre, radius, grippable, own);
  b2AABB box;
  box.lowerBound = centre - b2Vec2(radius, radius);
  box.upperBound = centre + b2Vec2(radius, radius);
  world.QueryAABB(&search, box);
  return search.GetPlace();
}

}  // namespace argos
