#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_ISLAND_NEWTON_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_ISLAND_NEWTON_H

#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>

#include <argos3/core/utility/datatypes/datatypes.h>

#include <array>
#include <cstddef>
#include <span>

namespace argos {

/**
 * A step of Newton's method on the impulses of an island's contacts and grips.
 *
 * Drives are eliminated: a body whose drive is within its bounds keeps its velocity, whatever
 * pushes it, and one whose drive is at its bound gives way; so are the motors of turrets. Contacts
 * that press get no approach, those that do not slide no slip, and grips no error. Which are which
 * is taken from where a sweep would put them: if that is right, so is the step, and if not, it may
 * lead astray.
 *
 * @tparam NUMBER  float or double.
 */
template <typename NUMBER>
class CIslandNewton {
 public:
  CIslandNewton(std::span<SIslandBody<NUMBER>> bodies, std::span<SIslandContact<NUMBER>> contacts,
                std::span<SIslandGrip<NUMBER>> grips)
      : m_bodies(bodies), m_contacts(contacts), m_grips(grips) {}
  /** @return true if the island has no more bodies, contacts and grips than there is space for. */
  bool Fits() const {
    return m_bodies.size() <= kMaxBodies && m_contacts.size() <= kMaxContacts &&
           2 * m_grips.size() <= kMaxUnknowns;
  }
  /**
   * Changes the impulses of contacts, and velocities; drives are to be swept before and after that.
   * @param damping  share of each contact's own compliance that is added to its equation: more of
   *                 it makes the step shorter.
   * @return false if there is no step.
   */
  bool Step(NUMBER damping);

 private:
  static constexpr size_t kMaxBodies = 64, kMaxContacts = 96, kMaxUnknowns = 96;
  static constexpr size_t kLanes = 4;  // numbers of a row that are computed together
  static constexpr UInt32 kEnd = 2 * kMaxUnknowns;

  enum class EState : UInt8 { Open, Frictionless, Sticks, Slides, SlidesBack };
  /** The change of a velocity for an impulse of 1. */
  struct SCompliance {
    NUMBER XX, XY, YY, Turn;
  };
  struct SMotion {
    NUMBER X, Y, Turn;
  };
  /** What an unknown impulse has to do with one of its bodies; of B, all has the opposite sign. */
  struct SSide {
    UInt32 Body;
    UInt32 Next;  // of the same body
    SMotion Speed;  // derivative of the speed that the impulse is to stop, by the velocity
    SMotion Impulse;  // on the body, if the unknown one is 1
  };

  void FindCompliances();
  void FindCompliancesOfTurrets();
  bool ListUnknowns();
  bool AddUnknowns(UInt32 number);
  void AddGrip(UInt32 number);
  void AddUnknown(const SIslandContact<NUMBER>& contact, bool isNormal, NUMBER ratio, NUMBER speed,
                  NUMBER compliance);
  NUMBER ComputeApproach(const SIslandContact<NUMBER>& contact) const;
  NUMBER ComputeSlip(const SIslandContact<NUMBER>& contact) const;
  void PutAtBounds();
  void Push(const SIslandContact<NUMBER>& contact, NUMBER normal, NUMBER tangent);
  void FillMatrix(NUMBER damping);
  void AddTurrets();
  bool SolveEquations();
  void TakeImpulses();

  std::span<SIslandBody<NUMBER>> m_bodies;
  std::span<SIslandContact<NUMBER>> m_contacts;
  std::span<SIslandGrip<NUMBER>> m_grips;
  size_t m_count = 0;  // of unknowns
  size_t m_firstOfGrips = 0;  // unknown
  std::array<SCompliance, kMaxBodies> m_compliances;
  std::array<UInt32, kMaxBodies> m_firstSides;  // by body: the last side that was added
  std::array<SMotion, kMaxBodies> m_moved;
  std::array<EState, kMaxContacts> m_states;
  std::array<bool, kMaxUnknowns / 2> m_turns;  // by grip: its turret turns by itself
  std::array<SSide, 2 * kMaxUnknowns> m_sides;  // A and B of each unknown
  std::array<NUMBER, kMaxUnknowns> m_speeds;  // to be stopped
  std::array<NUMBER, kMaxUnknowns> m_own;  // compliance of the contact or grip alone
  // the right hand side is the column behind the last one
  std::array<std::array<NUMBER, kMaxUnknowns + kLanes>, kMaxUnknowns> m_matrix;
  std::array<NUMBER, kMaxUnknowns> m_changes;  // of impulses
};

}  // namespace argos

#endif
