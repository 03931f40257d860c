#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_OVERLAP_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_OVERLAP_SOLVER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <box2d/box2d.h>

#include <vector>

namespace argos {

/**
 * Pushes overlapping bodies apart, after a substep.
 *
 * Box2D 2.4 learns of a contact when shapes overlap already: two e-pucks that meet head-on at 10
 * cm/s each are up to 1 cm into each other at the end of the substep in which they meet, and its
 * own position solver removes a fifth of an overlap per iteration, in the next substep. This solver
 * takes out what is left, positions only, in sweeps over the pairs (Gauss-Seidel; J. Bender, M.
 * Müller, M. Macklin, A Survey on Position Based Dynamics, 2017, section 5.1). Walls come last in
 * each sweep, so that what cannot be solved in a crowd is left between robots, never in a wall.
 *
 * It moves two bodies in inverse proportion to their masses, so it keeps their centre of mass; it
 * does not touch velocities, which Box2D's solver makes right in the next substep.
 */
class COverlapSolver {
 public:
  /** Makes room for @p pairs pairs, so that no more memory is needed up to there. */
  void Reserve(size_t pairs);

  /** Moves what overlaps. @return the deepest overlap that may be left, Box2D units. */
  float Resolve(b2World& world);
  /** The greatest impulse, kg units / s, that Box2D exchanged in a contact in the substep before.
   */
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

/** The number that a body carries; dense, given by its world. */
inline UInt32 GetBodyNumber(b2Body& body) {
  return static_cast<UInt32>(body.GetUserData().pointer);
}

}  // namespace argos

#endif
