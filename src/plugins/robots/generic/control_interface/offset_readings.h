#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_OFFSET_READINGS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_OFFSET_READINGS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>

#include <vector>

namespace argos {

/**
 * The readings of sensors under a robot: what the control interfaces of its ground sensors have in
 * common.
 *
 * @tparam SENSOR  the control interface: the readings of each have a type of their own, so that
 *                 functions may be overloaded for them.
 */
template <class SENSOR>
class COffsetReadings {
 public:
  struct SReading {
    Real Value = 0.0; /**< in [0,1]: 0 is black, 1 is white */
    CVector2 Offset; /**< of the sensor from the centre of the robot, in its frame, cm */

    SReading() = default;
    SReading(Real value, const CVector2& offset) : Value(value), Offset(offset) {}
  };

  typedef std::vector<SReading> TReadings;

  /** One reading for each sensor. */
  const TReadings& GetReadings() const { return m_tReadings; }

 protected:
  COffsetReadings() = default;
  ~COffsetReadings() = default;

  TReadings m_tReadings;
};

}  // namespace argos

#endif
