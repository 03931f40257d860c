#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_FLOOR_PAINTER_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_FLOOR_PAINTER_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/vector2.h>

namespace argos {

/**
 * An error of GetFloorColor(), which belongs to the loop functions: it ends the run as those of
 * their other hooks, also if a robot whose errors do not end it has read the colour.
 */
class CFloorPainterError : public CARGoSException {
 public:
  explicit CFloorPainterError(const CARGoSException& error) : CARGoSException(error) {}
};

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
