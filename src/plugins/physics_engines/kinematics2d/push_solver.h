#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_SOLVER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_SOLVER_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/planar_vector.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/push_parts.h>
#include <argos3/plugins/simulator/physics_engines/planar/body_forest.h>
#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>

#include <limits>
#include <span>
#include <vector>

namespace argos {

/** The motion of a body in a tick: m, and rad about its origin. */
struct STwist {
  Real X = 0.0;
  Real Y = 0.0;
  Real Turn = 0.0;

  SPlanarVector GetStep() const { return {X, Y}; }
};

/**
 * Computes how bodies move when robots push them against their friction with the ground.
 *
 * Quasi-static: nothing has momentum. Each body has a target and a force that aims at it, with
 * bounds: that of an object is its friction, which aims at rest; that of a robot is its drive,
 * which aims at the planned step. Of all motions in which no body penetrates another, bodies make
 * the one with the least sum of forces times deviations from targets (minimum dissipation).
 *
 * Bodies that are connected by contacts are solved as bodies of little mass (CContactIsland). That
 * is repeated from the motion that was found until the motion is steady: then the mass has no
 * effect, and the result depends neither on the order of bodies nor on that of contacts.
 */
class CPushSolver {
 public:
  static constexpr UInt32 kNone = std::numeric_limits<UInt32>::max();
  static constexpr Real kUnlimited = std::numeric_limits<Real>::infinity();

  /** A contact of two bodies. The normal has unit length and points to the pushed one. */
  struct SContact {
    UInt32 Pushing = kNone; /**< number of a body; kNone: an obstacle that does not move */
    UInt32 Pushed = 0; /**< number of a body */
    SPlanarVector Normal = {};
    Real LeverPushing = 0.0, LeverPushed = 0.0; /**< of the normal about the bodies' origins, m */
    /** Least motion of the pushed body along the normal, relative to the pushing one, m: the
     * negative gap. */
    Real Least = 0.0;
    /** Set by corrections: how the levers change while the bodies turn, m/rad. */
    Real BendPushing = 0.0, BendPushed = 0.0;
  };

  /** Removes all bodies and contacts. */
  void Clear();
  /**
   * Keeps the solution. After Clear(), an island that has the same bodies, told apart by their
   * keys, the same targets, and as many contacts between them, is solved from there if its friction
   * held all that pushed: then one sweep is enough.
   */
  void Remember();
  /**
   * Adds a body.
   * @param target           its motion without contacts; of objects that lie on the ground: none.
   * @param force, torque    bounds of what aims at the target, N and N m; with an unlimited torque
   *                         the body always turns as its target.
   * @param squaredGyration  moment of inertia over mass, m^2.
   * @param key              tells the body from others in all ticks; kNone: it is not remembered.
   * @return its number.
   */
  UInt32 AddBody(const STwist& target, Real force, Real torque, Real squaredGyration,
                 UInt32 key = kNone);
  /** @return its number. */
  UInt32 AddContact(const SContact& contact);
  const SContact& GetContact(UInt32 contact) const;
  /** Replaces a contact of the same bodies, when Solve() asks for it. */
  void SetContact(UInt32 contact, const SContact& replacement);
  /** The force of a contact in the last solution, N. */
  Real GetForce(UInt32 contact) const {
    CheckContact(contact);
    return m_contacts[contact].Force;
  }
  void Solve() {
    Solve([](UInt32) { return false; });
  }
  /**
   * @param correct  called with the number of each contact of bodies whose motion was found, may
   *                 replace the contact by what it is with that motion, and says if it has: then
   *                 the motion is searched further from there, until it is steady.
   */
  template <typename CORRECT>
  void Solve(CORRECT&& correct);
  /** After Solve(): the number of the first body that contacts connect with a body. */
  UInt32 GetIsland(UInt32 body) {
    CheckNumber(body);
    return FindRootOf(m_parents, body);
  }
  const STwist& GetTwist(UInt32 body) const {
    CheckNumber(body);
    return m_bodies[body].Twist;
  }

 private:
  struct SRequirement : SContact {
    Real Force = 0.0;  // N, of the last solution
    Real KnownForce = -1.0;  // N, of the last tick; negative: it did not exist
  };
  struct SBody {
    UInt32 Key;
    STwist Target;
    Real Force, Torque;  // N, N m
    Real SquaredGyration;  // m^2
    UInt32 Place;  // in its island
    Real Give, TurnGive;  // m/N, rad/(N m): compliance
    Real Bend = 0.0;  // N m/rad: how fast the torque of contacts decreases
    STwist Start;  // before forces
    STwist Twist;
    STwist Used;  // force and torque that aim at the target, of the last solution, N, N m
    UInt32 NumContacts = 0;
    UInt32 Known = kNone;  // in the list of known bodies
  };
  /** A body or contact, in the order of islands. */
  typedef SForestMember SMember;
  /** Bodies that are connected by contacts. */
  struct SIsland {
    std::span<const SMember> Bodies, Contacts;
    Real Need;  // m, by which bodies at their targets would penetrate each other
  };

  /** What is known of a body, or of a contact, from the last solution. */
  struct SKnownBody {
    UInt32 Key;
    UInt32 NumContacts;
    STwist Target, Twist, Used;
  };
  struct SKnownContact {
    UInt64 Bodies;  // keys of the pushing one and of the pushed one
    UInt32 Number;  // of contacts of the same bodies, the first one has the lowest
    Real Force;  // N
  };

  void CheckContact([[maybe_unused]] UInt32 contact) const {
    ARGOS_ASSERT(contact < m_contacts.size(),
                 "the solver has no contact with the number " << contact);
  }
  void CheckNumber([[maybe_unused]] UInt32 body) const {
    ARGOS_ASSERT(body < m_bodies.size(), "the solver has no body with the number " << body);
  }
  UInt32 FindKnown(UInt32 key) const;
  void Recall();
  void RecallContacts();
  bool IsKnown(const SIsland& island) const;
  void StartFromKnown(const SIsland& island);
  bool WasHeld(const SBody& body, Real need) const;
  void ListContacts();
  void SortByIslands();
  SIsland TakeIsland(size_t& body, size_t& contact) const;
  UInt32 Iterate(const SIsland& island, UInt32 mostSweeps);
  bool Prepare(SIsland& island);
  void CountContact(UInt32 body, Real lever);
  void SetUp(const SIsland& island, Real give);
  void SetUpContacts(const SIsland& island);
  void Restart(const SIsland& island, Real massShare);
  bool IsSteady(const SIsland& island, Real share) const;
  void StartFromResult(const SIsland& island);
  Real ComputePlannedMotion(const SContact& contact) const;

  std::vector<SBody> m_bodies;
  TBodyForest m_parents;
  std::vector<SRequirement> m_contacts;
  std::vector<SMember> m_bodyOrder, m_contactOrder;
  // of the last solution, sorted by keys, and scratch
  std::vector<SKnownBody> m_knownBodies;
  std::vector<SKnownContact> m_knownContacts, m_contactsByKey;
  bool m_isRecalled = false;  // since Clear()
  // of the island that is solved; behind the bodies is what does not move
  std::vector<SIslandBody<Real>> m_islandBodies;
  std::vector<SIslandContact<Real>> m_islandContacts;
  CPushParts m_parts;
};

template <typename CORRECT>
void CPushSolver::Solve(CORRECT&& correct) {
  Recall();
  SortByIslands();
  for (size_t body = 0, contact = 0; body < m_bodyOrder.size();) {
    SIsland island = TakeIsland(body, contact);
    UInt32 sweeps = 0;
    UInt32 corrections = 0;
    UInt32 repetitions = 0;
    Real massShare = 1.0;
    for (bool isDone = !Prepare(island); !isDone; ++repetitions) {
      sweeps += Iterate(island, kPushSweeps - sweeps);
      const bool isSteady = IsSteady(island, corrections > 0 ? kCorrectedSteady : kPushSteady);
      bool isCorrected = false;
      if (!(isSteady && corrections > 0)) {
        for (const SMember& member : island.Contacts) {
          isCorrected |= correct(member.Number);
        }
      }
      isDone =
          sweeps >= kPushSweeps || corrections >= kPushCorrections || (isSteady && !isCorrected);
      massShare *= repetitions >= kManyRepetitions ? kLighter : 1.0;
      if (isCorrected) {
        ++corrections;
        Restart(island, kMassOfCorrected);
      } else if (massShare < 1.0) {
        Restart(island, massShare);
      } else {
        StartFromResult(island);
      }
    }
  }
}

}  // namespace argos

#endif
