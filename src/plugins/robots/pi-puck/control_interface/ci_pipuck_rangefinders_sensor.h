#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_RANGEFINDERS_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_RANGEFINDERS_SENSOR_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace argos {

/** The eight range sensors around the Pi-Puck. */
class CCI_PiPuckRangefindersSensor : public CTableSensor {
 public:
  /** Anchor; position (m) and orientation in its frame: the sensor looks along z; range, m. */
  using TConfiguration = std::tuple<const char*, CVector3, CQuaternion, Real>;

  /** One sensor and its reading. */
  struct SInterface {
    const UInt8& Label; /**< from 0 */
    const TConfiguration& Configuration;
    Real Proximity = 0.0; /**< distance to the nearest body, m; the range without one */
    Real Illuminance = 0.0; /**< always 0 */

    explicit SInterface(const UInt8& label);
  };

  /** Calls @p visit for each sensor, in the order of the labels. */
  virtual void Visit(std::function<void(const SInterface&)> visit) = 0;

  std::vector<SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

 protected:
  static const std::map<UInt8, TConfiguration> MAP_SENSOR_CONFIG;

 private:
  const char* GetLuaName() const override { return "rangefinders"; }
  /** [i] = { proximity, illuminance, transform = { position, orientation, anchor } } */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#endif
