#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_shapes.h>

#include <algorithm>

namespace argos {

namespace {

// Overlaps of the described shapes below this are not corrected, Box2D units; the smallest movable
// body has radius 1, so this is 0.05 % of its radius.
constexpr float kTolerance = 0.0005F;
// Pairs up to this far apart can become overlaps when their neighbours are pushed, Box2D units.
constexpr float kNear = 0.3F;
// Greatest correction of a pair in a sweep, Box2D units: bodies that were placed with an overlap
// are separated smoothly in some ticks.
constexpr float kMaxPush = 0.25F;
constexpr int kMaxSweeps = 40;
// How often the pairs of a substep are collected, if bodies are pushed into others that were not
// near before.
constexpr int kMaxRounds = 4;
// Bodies that were pushed farther than this in a substep, Box2D units, may overlap a body with
// which Box2D has no contact: its bounding boxes have a margin, but that may be exceeded.
constexpr float kFar = 0.01F;

const b2CircleShape* AsCentredDisc(b2Fixture& fixture) {
  if (fixture.GetType() != b2Shape::e_circle) {
    return nullptr;
  }
  const auto* circle = static_cast<const b2CircleShape*>(fixture.GetShape());
  return circle->m_p == fixture.GetBody()->GetLocalCenter() ? circle : nullptr;
}

// signed distance between the described shapes; negative if they overlap
float ComputeGap(b2Contact& contact) {
  b2Fixture& fixtureA = *contact.GetFixtureA();
  b2Fixture& fixtureB = *contact.GetFixtureB();
  const b2CircleShape* discA = AsCentredDisc(fixtureA);
  const b2CircleShape* discB = AsCentredDisc(fixtureB);
  const b2Body& a = *fixtureA.GetBody();
  const b2Body& b = *fixtureB.GetBody();
  if (discA != nullptr && discB != nullptr) {
    return b2Distance(a.GetWorldCenter(), b.GetWorldCenter()) - discA->m_radius - discB->m_radius +
           2.0F * kShapeMargin;
  }
  b2Manifold manifold;
  contact.Evaluate(&manifold, a.GetTransform(), b.GetTransform());
  if (manifold.pointCount == 0) {
    // farther apart than both margins, but perhaps not by much: checked again later
    return 2.0F * kShapeMargin;
  }
  b2WorldManifold points;
  points.Initialize(&manifold, a.GetTransform(), fixtureA.GetShape()->m_radius, b.GetTransform(),
                    fixtureB.GetShape()->m_radius);
  float separation = points.separations[0];
  if (manifold.pointCount == 2) {
    separation = std::min(separation, points.separations[1]);
  }
  return separation + 2.0F * kShapeMargin;
}

float ComputeImpulse(b2Contact& contact) {
  const b2Manifold& manifold = *contact.GetManifold();
  float impulse = 0.0F;
  for (int32 i = 0; i < manifold.pointCount; ++i) {
    impulse += manifold.points[i].normalImpulse;
  }
  return impulse;
}

bool HaveContact(b2Body& body, b2Body& other) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->other == &other) {
      return true;
    }
  }
  return false;
}

/** Tests whether a body overlaps another with which Box2D has no contact. */
class CUnknownOverlap : public b2QueryCallback {
 public:
  explicit CUnknownOverlap(b2Body& body) : m_body(body) {}

  bool IsIn(b2World& world) {
    m_filter = world.GetContactManager().m_contactFilter;
    for (m_fixture = m_body.GetFixtureList(); m_fixture != nullptr && !m_found;
         m_fixture = m_fixture->GetNext()) {
      world.QueryAABB(this, m_fixture->GetAABB(0));
    }
    return m_found;
  }
  bool ReportFixture(b2Fixture* other) override {
    b2Body& body = *other->GetBody();
    m_found = &body != &m_body && !HaveContact(m_body, body) &&
              (m_filter == nullptr || m_filter->ShouldCollide(m_fixture, other)) &&
              b2TestOverlap(m_fixture->GetShape(), 0, other->GetShape(), 0, m_body.GetTransform(),
                            body.GetTransform());
    return !m_found;
  }

 private:
  b2Body& m_body;
  b2ContactFilter* m_filter = nullptr;
  b2Fixture* m_fixture = nullptr;
  bool m_found = false;
};

}  // namespace

void COverlapSolver::Reserve(size_t pairs) {
  m_bodies.reserve(pairs);
  m_pairs.reserve(pairs);
  m_wallPairs.reserve(pairs);
  m_indexOf.reserve(pairs);
}

float COverlapSolver::Resolve(b2World& world) {
  float deepest = 0.0F;
  m_greatestImpulse = 0.0F;
  for (int round = 0; round < kMaxRounds && Gather(world); ++round) {
    deepest = Solve();
    if (!PutBodies(world)) {
      break;
    }
    world.Step(0.0F, 0, 0);  // finds contacts, moves nothing
  }
  return deepest;
}

// Corrects the overlaps of the gathered pairs. @return the deepest overlap that may be left.
float COverlapSolver::Solve() {
  float deepest = 0.0F;
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    deepest = 0.0F;
    for (const SPair& pair : m_pairs) {
      deepest = std::max(deepest, SolvePair(pair));
    }
    for (const SPair& pair : m_wallPairs) {
      deepest = std::max(deepest, SolvePair(pair));
    }
    if (deepest == 0.0F) {
      break;
    }
  }
  return deepest;
}

// Writes the corrected poses. @return true if a body was pushed into one that was not gathered.
bool COverlapSolver::PutBodies(b2World& world) {
  for (const SBody& body : m_bodies) {
    if (body.Moved) {
      body.Body->SetTransform(body.Centre - b2Mul(body.Rotation, body.Body->GetLocalCenter()),
                              body.Angle);
    }
  }
  return std::any_of(m_bodies.begin(), m_bodies.end(), [&world](const SBody& body) {
    return body.Moved && b2DistanceSquared(body.Centre, body.Start) > kFar * kFar &&
           CUnknownOverlap(*body.Body).IsIn(world);
  });
}

// Collects the pairs that are near each other. @return true if any overlaps.
bool COverlapSolver::Gather(b2World& world) {
  m_bodies.clear();
  m_pairs.clear();
  m_wallPairs.clear();
  bool overlap = false;
  for (b2Contact* contact = world.GetContactList(); contact != nullptr;
       contact = contact->GetNext()) {
    m_greatestImpulse = std::max(m_greatestImpulse, ComputeImpulse(*contact));
    const float gap = ComputeGap(*contact);
    if (gap < kNear) {
      AddPair(*contact);
      overlap = overlap || gap < -kTolerance;
    }
  }
  return overlap;
}

UInt32 COverlapSolver::IndexOf(b2Body* body) {
  const UInt32 number = GetBodyNumber(*body);
  if (number >= m_indexOf.size()) {
    m_indexOf.resize(number + 1);
  }
  UInt32& index = m_indexOf[number];
  if (index >= m_bodies.size() || m_bodies[index].Body != body) {
    index = static_cast<UInt32>(m_bodies.size());
    const b2Vec2 centre = body->GetWorldCenter();
    SBody entry = {body, centre, body->GetAngle(), body->GetTransform().q,
                   0.0F, 0.0F,   centre,           false};
    if (body->GetType() == b2_dynamicBody) {
      const float mass = body->GetMass();
      entry.InverseMass = 1.0F / mass;
      entry.InverseInertia =
          1.0F / (body->GetInertia() - mass * body->GetLocalCenter().LengthSquared());
    }
    m_bodies.push_back(entry);
  }
  return index;
}

void COverlapSolver::AddPair(b2Contact& contact) {
  b2Fixture& fixtureA = *contact.GetFixtureA();
  b2Fixture& fixtureB = *contact.GetFixtureB();
  const b2CircleShape* discA = AsCentredDisc(fixtureA);
  const b2CircleShape* discB = AsCentredDisc(fixtureB);
  SPair pair = {&contact, IndexOf(fixtureA.GetBody()), IndexOf(fixtureB.GetBody()), -1.0F};
  if (discA != nullptr && discB != nullptr) {
    pair.Reach = discA->m_radius + discB->m_radius - 2.0F * kShapeMargin;
  }
  const bool wall = m_bodies[pair.A].InverseMass == 0.0F || m_bodies[pair.B].InverseMass == 0.0F;
  (wall ? m_wallPairs : m_pairs).push_back(pair);
}

// The Solve functions return the depth of the pair's overlap; 0 if they did not change it.
float COverlapSolver::SolvePair(const SPair& pair) {
  return pair.Reach > 0.0F ? SolveDiscs(pair) : SolveManifold(pair);
}

float COverlapSolver::SolveDiscs(const SPair& pair) {
  SBody& a = m_bodies[pair.A];
  SBody& b = m_bodies[pair.B];
  b2Vec2 normal = b.Centre - a.Centre;
  const float limit = pair.Reach - kTolerance;
  if (normal.LengthSquared() >= limit * limit) {
    return 0.0F;
  }
  const float distance = normal.Normalize();
  if (distance < b2_epsilon) {
    normal.Set(1.0F, 0.0F);  // as Box2D does for discs with one centre
  }
  const float depth = pair.Reach - distance;
  const float share = std::min(depth, kMaxPush) / (a.InverseMass + b.InverseMass);
  a.Centre -= share * a.InverseMass * normal;
  b.Centre += share * b.InverseMass * normal;
  a.Moved = a.Moved || a.InverseMass > 0.0F;
  b.Moved = b.Moved || b.InverseMass > 0.0F;
  return depth;
}

float COverlapSolver::SolveManifold(const SPair& pair) {
  SBody& a = m_bodies[pair.A];
  SBody& b = m_bodies[pair.B];
  b2Transform frameA;
  frameA.q = a.Rotation;
  frameA.p = a.Centre - b2Mul(a.Rotation, a.Body->GetLocalCenter());
  b2Transform frameB;
  frameB.q = b.Rotation;
  frameB.p = b.Centre - b2Mul(b.Rotation, b.Body->GetLocalCenter());
  b2Manifold manifold;
  pair.Contact->Evaluate(&manifold, frameA, frameB);
  if (manifold.pointCount == 0) {
    return 0.0F;
  }
  b2WorldManifold points;
  points.Initialize(&manifold, frameA, pair.Contact->GetFixtureA()->GetShape()->m_radius, frameB,
                    pair.Contact->GetFixtureB()->GetShape()->m_radius);
  float deepest = 0.0F;
  for (int32 i = 0; i < manifold.pointCount; ++i) {
    const float depth = -(points.separations[i] + 2.0F * kShapeMargin);
    if (depth > kTolerance) {
      // two points share the push: both act on one face
      Push(a, b, points.normal, points.points[i],
           std::min(depth, kMaxPush) / static_cast<float>(manifold.pointCount));
      deepest = std::max(deepest, depth);
    }
  }
  return deepest;
}

void COverlapSolver::Push(SBody& a, SBody& b, const b2Vec2& normal, const b2Vec2& point,
                          float depth) {
  const b2Vec2 armA = point - a.Centre;
  const b2Vec2 armB = point - b.Centre;
  const float leverA = b2Cross(armA, normal);
  const float leverB = b2Cross(armB, normal);
  const float share = depth / (a.InverseMass + b.InverseMass + a.InverseInertia * leverA * leverA +
                               b.InverseInertia * leverB * leverB);
  if (a.InverseMass > 0.0F) {
    a.Centre -= share * a.InverseMass * normal;
    a.Angle -= share * a.InverseInertia * leverA;
    a.Rotation.Set(a.Angle);
    a.Moved = true;
  }
  if (b.InverseMass > 0.0F) {
    b.Centre += share * b.InverseMass * normal;
    b.Angle += share * b.InverseInertia * leverB;
    b.Rotation.Set(b.Angle);
    b.Moved = true;
  }
}

}  // namespace argos
