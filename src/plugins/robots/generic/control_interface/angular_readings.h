#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_ANGULAR_READINGS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_ANGULAR_READINGS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

#include <vector>

namespace argos {

/**
 * The readings of sensors around a robot: what the control interfaces of light and proximity
 * sensors have in common.
 *
 * @tparam SENSOR  the control interface: the readings of each have a type of their own, so that
 *                 functions may be overloaded for them.
 */
template <class SENSOR>
class CAngularReadings {
 public:
  struct SReading {
    Real Value = 0.0; /**< in [0,1]: 0 is dark, or sees nothing; larger is brighter, or nearer */
    CRadians Angle; /**< where the sensor points, in (-PI,PI], counter-clockwise from ahead */

    SReading() = default;
    SReading(Real value, const CRadians& angle) : Value(value), Angle(angle) {}
  };

  /** One reading for each sensor. */
  typedef std::vector<SReading> TReadings;

  const TReadings& GetReadings() const { return m_tReadings; }

 protected:
  CAngularReadings() = default;
  ~CAngularReadings() = default;

  TReadings m_tReadings;
};

}  // namespace argos

#endif
