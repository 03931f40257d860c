#ifndef ARGOS3_PLUGINS_MEDIA_INDEX_CHOICE_H
#define ARGOS3_PLUGINS_MEDIA_INDEX_CHOICE_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** How a medium finds what is near a point: the attributes `index` and `grid_size`. */
struct SIndexChoice {
  enum class EKind {
    Grid, /**< cells that divide the arena */
    Hash, /**< the same without bounds */
    Dummy /**< none: everything is looked at */
  };

  /** A grid over an arena. */
  struct SCells {
    CVector3 Extent; /**< of the arena, m, each > 0 */
    SInt32 Number[3]; /**< along x, y, z */
  };

  EKind Kind = EKind::Grid;
  SInt32 GridSize[3] = {0, 0, 0}; /**< cells along x, y, z; 0: chosen from the arena */

  /**
   * @param withDummy  does the medium know `dummy`?
   * @throws CARGoSException if a value is unknown or out of range.
   */
  void Read(TConfigurationNode& medium, bool withDummy = false);
  /** "grid", ... */
  const char* GetName() const;
  /**
   * The cells for an arena: as many as asked for, by default one for each whole metre, and no more
   * than make it faster. @param extent m.
   */
  SCells MakeCells(const CVector3& extent) const;
};

}  // namespace argos

#endif
