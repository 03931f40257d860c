#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_FLOOR_PAINTER_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_FLOOR_PAINTER_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/vector2.h>

namespace argos {

/** Interface of the object that colours a `<floor source="loop_functions">`. */
class CFloorPainter {
 public:
  /** Colour of the floor; @p positionOnFloor in m, world frame. */
  virtual CColor GetFloorColor(const CVector2& positionOnFloor) = 0;

 protected:
  ~CFloorPainter() = default;
};

}  // namespace argos

#endif
