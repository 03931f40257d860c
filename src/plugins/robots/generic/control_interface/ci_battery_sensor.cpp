#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>

namespace argos {

void CCI_BatterySensor::ListNumbers(CNumberList& list) const {
  list.Add("available_charge", "", m_sReading.AvailableCharge);
  list.Add("time_left", "s", m_sReading.TimeLeft);
}

}  // namespace argos
