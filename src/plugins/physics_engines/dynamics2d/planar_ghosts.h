#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GHOSTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_GHOSTS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>

#include <box2d/box2d.h>

#include <limits>
#include <vector>

namespace argos {

/** A robot that may meet a ghost in this tick. */
struct SGhostMeeting {
  UInt32 Ghost;  // in the list of ghosts
  UInt32 Slot;  // of the driven body
};

/**
 * Lets each body that stands for a ghost collide with its partner only.
 *
 * A robot of this world and one of another must not both take the gap between them. So for each
 * robot that may meet a ghost a face is put half-way between the two, which only it can feel.
 * Things without a drive, of which other worlds know nothing, feel the ghost itself.
 */
class CGhostFilter : public b2ContactFilter {
 public:
  static constexpr UInt32 kNoGhost = std::numeric_limits<UInt32>::max();
  static constexpr UInt32 kThings = kNoGhost - 1;  // the partners are all things without a drive

  /** Says of the body with that number whose ghost it is, or that it is none. */
  void SetPartner(UInt32 body, UInt32 partner);
  /** Says of the body with that number whether it has a drive. */
  void SetDriven(UInt32 body, bool isDriven);
  /** Makes room for that many bodies. */
  void Reserve(size_t bodies) { m_bodies.reserve(bodies); }

  bool ShouldCollide(b2Fixture* a, b2Fixture* b) override;

 private:
  struct SBody {
    UInt32 Partner = kNoGhost;
    bool IsDriven = false;
  };
  SBody& At(UInt32 body);
  bool IsPartner(UInt32 ghost, UInt32 body) const;

  std::vector<SBody> m_bodies;  // by number
};

}  // namespace argos

#endif
