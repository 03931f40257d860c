#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>

namespace argos {

void CCI_ClockSensor::ListNumbers(CNumberList& list) const {
  list.Add("tick", "ticks", static_cast<Real>(m_sReading.Tick));
  list.Add("time", "s", m_sReading.Time);
}

}  // namespace argos
