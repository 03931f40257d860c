#ifndef ARGOS3_PLUGINS_ENTITIES_ANCHOR_USE_H
#define ARGOS3_PLUGINS_ENTITIES_ANCHOR_USE_H

#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/memory/object_slabs.h>

#include <vector>

namespace argos {

class CEntity;

/*
 * For the sources of components that are mounted on anchors and need their poses while enabled.
 */

/** Begins or ends one use of an anchor; the origin anchor is always in use. */
inline void UseAnchor(SAnchor& anchor, bool use) {
  if (anchor.Index > 0) {
    use ? anchor.Enable() : anchor.Disable();
  }
}
/**
 * Notes on the body of the robot that @p component has been enabled, or disabled, and that its
 * Update() is needed after each move of the body.
 */
void CountFollower(CEntity& component, bool enabled);
/** SetEnabled() of a component, not composable, whose Update() is needed after each move. */
void SetFollowerEnabled(CEntity& component, bool enabled);
/** Registers a mount of @p user, which may be enabled already, on an anchor permanently. */
void MountOnAnchor(SAnchor& anchor, const CEntity& user);
/** The anchors on which a component is mounted, most often one; not owned. */
typedef std::vector<SAnchor*, CSlabAllocator<SAnchor*>> TAnchorsInUse;

/**
 * Returns the index of an anchor in the list of anchors that @p user is mounted on; appends a new
 * one.
 */
UInt32 NumberOfAnchor(TAnchorsInUse& anchors, SAnchor& anchor, const CEntity& user);

}  // namespace argos

#endif
