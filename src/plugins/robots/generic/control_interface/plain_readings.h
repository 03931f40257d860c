#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLAIN_READINGS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_PLAIN_READINGS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <vector>

namespace argos {

/** Base of control interfaces whose readings are a list of numbers, one for each sensor. */
class CPlainReadings : public CTableSensor {
 public:
  const std::vector<Real>& GetReadings() const { return m_tReadings; }

  std::vector<SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

 protected:
  std::vector<Real> m_tReadings;

 private:
  /** A list of numbers, in the order of the robot's sensors. */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#endif
