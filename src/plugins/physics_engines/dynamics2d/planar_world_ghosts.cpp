// Robots of other engines near the border, in the tick of a planar world.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_world.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m/s: what a robot that stands at the last tick's end is thought to reach in the next one at most
constexpr Real kSuddenSpeed = 0.5;

/** Wakes the things that overlap with a ghost: they sleep, and nothing else tells them of it. */
class CWaker : public b2QueryCallback {
 public:
  CWaker(const b2CircleShape& disc, const b2Transform& frame) : m_disc(disc), m_frame(frame) {}

  bool FoundAny() const { return m_found; }
  bool ReportFixture(b2Fixture* fixture) override {
    b2Body& body = *fixture->GetBody();
    // what is driven never sleeps
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

Real CPlanarWorld::ComputeGhostReach() const {
  // one that drives and one that is driven at may both go the longest path
  return m_widestMovable + (2.0 + kAround) * kEncounterSlack * m_metresPerUnit +
         std::max(2.0 * m_longestPath, kSuddenSpeed * m_settings.Tick);
}

void CPlanarWorld::SetGhosts(const std::vector<SGhostDisc>& ghosts) {
  m_ghosts.assign(ghosts.begin(), ghosts.end());
}

// After all others are marked: which robots may come half-way to a ghost?
void CPlanarWorld::MeetGhosts() {
  m_meetings.clear();
  const Real slack = kEncounterSlack * m_metresPerUnit;
  for (UInt32 ghost = 0; ghost < m_ghosts.size(); ++ghost) {
    const SGhostDisc& disc = m_ghosts[ghost];
    // a robot's own reach has its own path in it, and it may go half of the gap
    const Real reach = disc.Radius + m_longestPath + slack;
    m_nearGhost.clear();
    m_encounters.MarkNear(disc.X, disc.Y, reach, &m_nearGhost);
    for (const SInPlay& play : m_inPlay) {
      const SDrivenBody& body = m_driven[play.Slot];
      if (!body.IsDisc && std::hypot(body.Pose.X - disc.X, body.Pose.Y - disc.Y) <=
                              reach + body.BoundingRadius + m_longestPath) {
        m_nearGhost.push_back(play.Slot);
      }
    }
    for (const UInt32 slot : m_nearGhost) {
      m_meetings.push_back({ghost, slot});
    }
  }
}

void CPlanarWorld::PlaceGhosts() {
  for (const SGhostMeeting& meeting : m_meetings) {
    PlaceGhostFace(m_ghosts[meeting.Ghost], m_driven[meeting.Slot]);
  }
  if (!m_passive.empty()) {
    for (const SGhostDisc& ghost : m_ghosts) {
      PlaceGhostDisc(ghost);
    }
  }
}

b2Body& CPlanarWorld::CreateGhostBody(const SPlanarPose& pose, UInt32 partner) {
  if (m_ghostBodies.empty()) {
    m_world.SetContactFilter(&m_ghostFilter);
  }
  b2Body& body = CreateBody(pose, EPlanarKind::Immovable, SPlanarOwner(), false);
  m_ghostFilter.SetPartner(GetBodyNumber(body), partner);
  m_ghostBodies.push_back(&body);
  return body;
}

// half-way between the ghost and the robot, across the line between their centres
void CPlanarWorld::PlaceGhostFace(const SGhostDisc& ghost, const SDrivenBody& body) {
  const Real dx = body.Pose.X - ghost.X;
  const Real dy = body.Pose.Y - ghost.Y;
  const Real distance = std::hypot(dx, dy);
  if (!(distance > 0.0)) {
    return;
  }
  const Real gap = distance - ghost.Radius - body.BoundingRadius;
  // so large that no path of the robot leads around it or through it
  const Real half = ghost.Radius + 2.0 * body.BoundingRadius + 2.0 * m_longestPath;
  const Real toCentre = (ghost.Radius + 0.5 * gap - half) / distance;
  SPlanarPose pose;
  pose.X = ghost.X + dx * toCentre;
  pose.Y = ghost.Y + dy * toCentre;
  pose.SetYaw(std::atan2(dy, dx));
  b2Body& face = CreateGhostBody(pose, GetBodyNumber(*m_inPlay[body.InPlay].Body));
  b2PolygonShape box;
  box.SetAsBox(ToUnits(half), ToUnits(half));
  box.m_radius = kShapeMargin;
  b2FixtureDef definition;
  definition.shape = &box;
  definition.friction = 0.0F;
  definition.restitution = 0.0F;
  face.CreateFixture(&definition);
}

void CPlanarWorld::PlaceGhostDisc(const SGhostDisc& ghost) {
  SPlanarPose pose;
  pose.X = ghost.X;
  pose.Y = ghost.Y;
  b2CircleShape shape;
  shape.m_radius = ToUnits(ghost.Radius) + kShapeMargin;
  b2Transform frame;
  frame.Set(b2Vec2(ToUnits(ghost.X), ToUnits(ghost.Y)), 0.0F);
  CWaker waker(shape, frame);
  b2AABB box;
  shape.ComputeAABB(&box, frame, 0);
  const b2Vec2 around(ToUnits(m_longestPath), ToUnits(m_longestPath));
  box.lowerBound -= around;
  box.upperBound += around;
  m_world.QueryAABB(&waker, box);
  if (waker.FoundAny()) {
    AddDisc(CreateGhostBody(pose, CGhostFilter::kThings), ghost.Radius, m_settings.UnitsPerMetre,
            0.0);
  }
}

void CPlanarWorld::RemoveGhosts() {
  for (b2Body* body : m_ghostBodies) {
    m_ghostFilter.SetPartner(GetBodyNumber(*body), CGhostFilter::kNoGhost);
    DestroyBody(*body);
  }
  m_ghostBodies.clear();
}

}  // namespace argos
