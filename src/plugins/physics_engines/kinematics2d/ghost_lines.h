#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_GHOST_LINES_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_GHOST_LINES_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/planar_vector.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>

#include <limits>
#include <span>
#include <vector>

namespace argos {

/**
 * A line half-way between a disc and a ghost, across that between their centres: the disc stays on
 * its side for a tick.
 *
 * The ghost's engine does the same with the same two poses, so that the motion of the two cannot
 * make them overlap.
 */
struct SGhostLine {
  UInt32 Slot;  // of the disc
  UInt32 Ghost;  // its number
  SPlanarVector Normal;  // from the disc to the ghost, of unit length
  SPlanarVector Start;  // m, world frame; of the disc at the start of the tick
  Real Room;  // m; how far it may move along the normal from there; below 0 if the two overlap
};

/** The lines of a tick. Has() is all that they cost for discs without lines. */
class CGhostLines {
 public:
  /** Allocates memory for lines of so many discs. */
  void Reserve(size_t discs);
  /** Removes all lines. @param discs  their number. */
  void Clear(size_t discs);
  /** @param x, y  m, world frame: of the disc. */
  void Add(UInt32 slot, Real x, Real y, Real radius, UInt32 number, const SGhostDisc& ghost);
  /** Sorts the lines by slot and ghost; to be called before Get(). */
  void Sort();
  bool Has(UInt32 slot) const {
    ARGOS_ASSERT(m_lines.empty() || slot < m_first.size(),
                 "ghost lines are of " << m_first.size() << " discs, not of slot " << slot);
    return !m_lines.empty() && m_first[slot] != kNone;
  }
  /** The lines of a disc, in the order of ghosts. */
  std::span<const SGhostLine> Get(UInt32 slot) const;

 private:
  static constexpr UInt32 kNone = std::numeric_limits<UInt32>::max();

  std::vector<SGhostLine> m_lines;
  std::vector<UInt32> m_first;  // (discs by slot) into m_lines; kNone if they have none
};

}  // namespace argos

#endif
