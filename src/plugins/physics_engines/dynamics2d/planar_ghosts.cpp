#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

/** Wakes the passive bodies that overlap a ghost: nothing else would wake them. */
class CWaker : public b2QueryCallback {
 public:
  CWaker(const b2CircleShape& disc, const b2Transform& frame) : m_disc(disc), m_frame(frame) {}

  bool FoundAny() const { return m_found; }
  bool ReportFixture(b2Fixture* fixture) override {
    b2Body& body = *fixture->GetBody();
    // driven bodies never sleep
    if (body.GetType() == b2_dynamicBody &&
        b2TestOverlap(&m_disc, 0, fixture->GetShape(), 0, m_frame, body.GetTransform())) {
      body.SetAwake(true);
    }
    m_found = true;
    return true;
  }

 private:
  const b2CircleShape& m_disc;
  const b2Transform& m_frame;
  bool m_found = false;
};

}  // namespace

void CPlanarGhosts::Place(CDiscPairs& discPairs, CCrowd& crowd, Real reach, Real longestPath) {
  const bool hasActivePassive =
      std::any_of(m_store.GetPassive().begin(), m_store.GetPassive().end(),
                  [](const SPassiveBody& body) { return body.Body->IsEnabled(); });
  for (const SGhostDisc& ghost : m_ghosts) {
    m_nearGhost.clear();
    discPairs.ForNear(ghost.X, ghost.Y, ghost.Radius + reach,
                      [this](UInt32 place) { m_nearGhost.push_back(place); });
    for (const UInt32 place : m_nearGhost) {
      const SDrivenBody& body = m_store.GetDriven(discPairs.GetDiscs()[place].Number);
      if (body.IsActive()) {
        PlaceFace(ghost, body, longestPath);
      } else {
        PlaceLine(ghost, place, discPairs, crowd);
      }
    }
    PlaceForSolids(ghost, crowd.GetSolids(), reach, longestPath);
    if (hasActivePassive) {
      PlaceDisc(ghost, longestPath);
    }
  }
}

// A robot that is no disc stays on its side of a face. Objects touch the ghost.
void CPlanarGhosts::PlaceForSolids(const SGhostDisc& ghost, CCrowdSolids& solids, Real reach,
                                   Real longestPath) {
  m_nearGhost.clear();
  solids.ForNear(ghost.X, ghost.Y, ghost.Radius,
                 [this](UInt32 item) { m_nearGhost.push_back(item); });
  for (const UInt32 item : m_nearGhost) {
    const CCrowdSolids::SSolid& solid = solids.GetSolid(item);
    if (solid.Kind == EPlanarKind::Passive) {
      SFootprint disc = {ghost.X, ghost.Y, 1.0, 0.0, 0.0, 0.0, ghost.Radius};
      solids.AddObstacle(item, disc, kSolidReach * reach);
      continue;
    }
    const SDrivenBody& body = m_store.GetDriven(solid.Slot);
    if (std::hypot(body.Pose.X - ghost.X, body.Pose.Y - ghost.Y) >
        ghost.Radius + body.BoundingRadius + 2.0 * kSolidReach * reach) {
      continue;
    }
    if (body.IsActive()) {
      PlaceFace(ghost, body, longestPath);
    } else if (const std::optional<SFootprint> face = MakeFace(ghost, body, longestPath)) {
      solids.AddObstacle(item, *face, kSolidReach * reach);
    }
  }
}

// half-way between the ghost and the robot, across the line between their centres
void CPlanarGhosts::PlaceLine(const SGhostDisc& ghost, UInt32 place, CDiscPairs& discPairs,
                              CCrowd& crowd) {
  const CDiscPairs::SDisc& disc = discPairs.GetDiscs()[place];
  const Real dx = ghost.X - disc.X;
  const Real dy = ghost.Y - disc.Y;
  const Real distance = std::hypot(dx, dy);
  if (!(distance > 0.0)) {
    return;
  }
  const Real gap = distance - ghost.Radius - disc.Radius;
  const Real share = (disc.Radius + 0.5 * gap) / distance;
  crowd.AddLine(discPairs, place,
                {dx / distance, dy / distance, disc.X + share * dx, disc.Y + share * dy});
}

b2Body& CPlanarGhosts::CreateGhostBody(const SPlanarPose& pose, UInt32 partner) {
  if (m_bodies.empty()) {
    m_store.GetWorld().SetContactFilter(&m_filter);
  }
  b2Body& body = m_store.CreateBody(pose, EPlanarKind::Immovable, SPlanarOwner(), false);
  m_filter.SetPartner(GetBodyNumber(body), partner);
  m_bodies.push_back(&body);
  return body;
}

// A square whose side is half-way between the ghost and the circle around the robot, across the
// line between their centres; none if they have one centre.
std::optional<SFootprint> CPlanarGhosts::MakeFace(const SGhostDisc& ghost, const SDrivenBody& body,
                                                  Real longestPath) {
  const Real dx = body.Pose.X - ghost.X;
  const Real dy = body.Pose.Y - ghost.Y;
  const Real distance = std::hypot(dx, dy);
  if (!(distance > 0.0)) {
    return std::nullopt;
  }
  const Real gap = distance - ghost.Radius - body.BoundingRadius;
  // so large that no path of the robot leads around it or through it
  const Real half = ghost.Radius + 2.0 * body.BoundingRadius + 2.0 * longestPath;
  const Real toCentre = (ghost.Radius + 0.5 * gap - half) / distance;
  return SFootprint{ghost.X + dx * toCentre,
                    ghost.Y + dy * toCentre,
                    dx / distance,
                    dy / distance,
                    half,
                    half,
                    0.0};
}

void CPlanarGhosts::PlaceFace(const SGhostDisc& ghost, const SDrivenBody& body, Real longestPath) {
  const std::optional<SFootprint> face = MakeFace(ghost, body, longestPath);
  if (!face) {
    return;
  }
  SPlanarPose pose;
  pose.X = face->X;
  pose.Y = face->Y;
  pose.SetYaw(std::atan2(face->Sin, face->Cos));
  b2Body& faceBody =
      CreateGhostBody(pose, GetBodyNumber(m_active.GetBox2DBody(*body.Owner.Handle)));
  b2PolygonShape box;
  box.SetAsBox(m_store.ToUnits(face->HalfX), m_store.ToUnits(face->HalfY));
  box.m_radius = kShapeMargin;
  b2FixtureDef definition;
  definition.shape = &box;
  definition.friction = 0.0F;
  definition.restitution = 0.0F;
  faceBody.CreateFixture(&definition);
}

void CPlanarGhosts::PlaceDisc(const SGhostDisc& ghost, Real longestPath) {
  SPlanarPose pose;
  pose.X = ghost.X;
  pose.Y = ghost.Y;
  b2CircleShape shape;
  shape.m_radius = m_store.ToUnits(ghost.Radius) + kShapeMargin;
  b2Transform frame;
  frame.Set(b2Vec2(m_store.ToUnits(ghost.X), m_store.ToUnits(ghost.Y)), 0.0F);
  CWaker waker(shape, frame);
  b2AABB box;
  shape.ComputeAABB(&box, frame, 0);
  const b2Vec2 around(m_store.ToUnits(longestPath), m_store.ToUnits(longestPath));
  box.lowerBound -= around;
  box.upperBound += around;
  m_store.GetWorld().QueryAABB(&waker, box);
  if (waker.FoundAny()) {
    AddDisc(CreateGhostBody(pose, CGhostFilter::kPassive), ghost.Radius,
            m_store.GetSettings().UnitsPerMetre, 0.0);
  }
}

void CPlanarGhosts::Remove() {
  for (b2Body* body : m_bodies) {
    m_filter.SetPartner(GetBodyNumber(*body), CGhostFilter::kNoGhost);
    m_store.DestroyBody(*body);
  }
  m_bodies.clear();
}

}  // namespace argos
