#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_LED_DETECTIONS_IMPL_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_LED_DETECTIONS_IMPL_H

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/plugins/robots/generic/control_interface/led_detections.h>

namespace argos {

template <class ALGORITHM>
void CLEDDetections<ALGORITHM>::WriteReadings(CLuaTable& table) const {
  table.SetNewRecords(m_tReadings, [](CLuaTable& record, const SReading& reading) {
    record.Set("color", reading.Color);
    record.Set("center", reading.Center);
  });
}

}  // namespace argos

#endif
