#ifndef ARGOS3_PLUGINS_MEDIA_INDEX_CHOICE_H
#define ARGOS3_PLUGINS_MEDIA_INDEX_CHOICE_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** Spatial index of a medium: the attributes `index` and `grid_size`. */
struct SIndexChoice {
  enum class EKind {
    Grid, /**< cells that divide the arena */
    Hash, /**< unbounded cells */
    Dummy /**< none: all entities are tested */
  };

  /** A grid over an arena. */
  struct SCells {
    CVector3 Extent; /**< extents of the arena, m, each > 0 */
    SInt32 Number[3]; /**< along x, y, z */
  };

  EKind Kind = EKind::Grid;
  SInt32 GridSize[3] = {0, 0, 0}; /**< cells along x, y, z; 0: chosen from the arena */

  /**
   * @param withDummy  true if the medium supports `dummy`.
   * @throws CARGoSException if a value is unknown or out of range.
   */
  void Read(TConfigurationNode& medium, bool withDummy = false);
  /** "grid", ... */
  const char* GetName() const;
  /**
   * The cells for an arena: as many as configured, by default one for each whole metre, limited to
   * the number beyond which a grid does not get faster. @param extent m.
   */
  SCells MakeCells(const CVector3& extent) const;
};

}  // namespace argos

#endif
