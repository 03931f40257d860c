#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_OVERLAP_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_OVERLAP_SOLVER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <box2d/box2d.h>

#include <vector>

namespace argos {

/**
 * Pushes overlapping bodies apart, after a substep.
 *
 * Box2D 2.4 detects a contact only when shapes already overlap: two e-pucks that collide head-on at
 * 10 cm/s each overlap by up to 1 cm at the end of the substep in which they collide, and its own
 * position solver removes a fifth of an overlap per iteration, in the next substep. This solver
 * corrects the remaining overlaps, positions only, in sweeps over the pairs (Gauss-Seidel; J.
 * Bender, M. Müller, M. Macklin, A Survey on Position Based Dynamics, 2017, section 5.1). Walls are
 * last in each sweep, so that unsolved overlaps in a crowd remain between robots, never in a wall.
 *
 * It moves two bodies in inverse proportion to their masses, which keeps their centre of mass; it
 * does not change velocities, which Box2D's solver corrects in the next substep.
 */
class COverlapSolver {
 public:
  /** Allocates memory for @p pairs pairs. */
  void Reserve(size_t pairs);

  /** Separates overlapping bodies. @return the deepest overlap that may be left, Box2D units. */
  float Resolve(b2World& world);
  /** The greatest impulse of a contact in the previous substep, kg Box2D units / s. */
  float GetGreatestImpulse() const { return m_greatestImpulse; }

 private:
  struct SBody {
    b2Body* Body;
    b2Vec2 Centre;  // of mass
    float Angle;
    b2Rot Rotation;
    float InverseMass;  // 0 if it does not move
    float InverseInertia;  // about the centre of mass
    b2Vec2 Start;  // Centre before the substep's pushes
    bool Moved;
  };
  struct SPair {
    b2Contact* Contact;
    UInt32 A, B;
    float Reach;  // sum of radii if both are discs around their centres of mass; else negative
  };

  float Solve();
  bool Gather(b2World& world);
  bool PutBodies(b2World& world);
  UInt32 IndexOf(b2Body* body);
  void AddPair(b2Contact& contact);
  float SolvePair(const SPair& pair);
  float SolveDiscs(const SPair& pair);
  float SolveManifold(const SPair& pair);
  void Push(SBody& a, SBody& b, const b2Vec2& normal, const b2Vec2& point, float depth);

  std::vector<SBody> m_bodies;
  std::vector<SPair> m_pairs;
  std::vector<SPair> m_wallPairs;  // with an immovable body
  std::vector<UInt32> m_indexOf;  // by number of body: index in m_bodies, valid if it is that body
  float m_greatestImpulse = 0.0F;
};

/** The number that a CPlanarStore gave to a Box2D body. */
inline UInt32 GetBodyNumber(b2Body& body) {
  return static_cast<UInt32>(body.GetUserData().pointer);
}

}  // namespace argos

#endif
