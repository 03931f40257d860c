#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_PARTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_PUSH_PARTS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/physics_engines/planar/body_forest.h>
#include <argos3/plugins/simulator/physics_engines/planar/contact_island.h>

#include <span>
#include <vector>

namespace argos {

/**
 * Solves a large island in parts: the bodies that contacts with a force connect, such as the rows
 * of a block, each of which a robot pushes. A part takes as many sweeps as it needs, and small ones
 * take steps of Newton's method. Sweeps over everything in between find which contacts have a
 * force, and that nothing is left to solve.
 */
class CPushParts {
 public:
  using SBody = SIslandBody<Real>;
  using SContact = SIslandContact<Real>;

  /** @return true if an island has more bodies than a part that Newton's method can solve. */
  static bool IsLarge(std::span<const SBody> bodies) { return bodies.size() > kLarge; }
  /**
   * @param bodies  the last one is what does not move.
   * @param tolerance  of velocities, m.
   * @return the number of sweeps, those over parts by their share of the contacts.
   */
  UInt32 Solve(std::span<SBody> bodies, std::span<SContact> contacts, Real tolerance,
               UInt32 mostSweeps);

 private:
  static constexpr size_t kLarge = 64;
  /** A body or contact, in the order of parts. */
  typedef SForestMember SMember;

  void FindParts(std::span<const SBody> bodies, std::span<const SContact> contacts);
  UInt32 SolvePart(std::span<SBody> bodies, std::span<SContact> contacts,
                   std::span<const SMember> ofBodies, std::span<const SMember> ofContacts,
                   Real tolerance, UInt32 mostSweeps);

  TBodyForest m_parents;
  std::vector<SMember> m_bodyOrder, m_contactOrder;
  std::vector<UInt32> m_places;  // by body: its number in its part
  std::vector<SBody> m_bodies;
  std::vector<SContact> m_contacts;
};

}  // namespace argos

#endif
