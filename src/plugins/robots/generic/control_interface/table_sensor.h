#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_TABLE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_TABLE_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>

namespace argos {

class CLuaTable;

/**
 * Base of the control interfaces of sensors whose readings are one table in Lua.
 * @tparam BASE  CCI_Sensor, or CVirtualSensor if the interface has it as a virtual base.
 */
template <class BASE>
class CTableSensorOn : public BASE {
 public:
  /** Creates robot.<GetLuaName()> with constants, functions and the first readings. */
  void CreateLuaState(lua_State* state) override;
  /** Writes the current readings. */
  void ReadingsToLuaState(lua_State* state) override;

 private:
  virtual const char* GetLuaName() const = 0;
  /** Sets the constant fields of the new table, and its functions; by default none. */
  virtual void WriteConstants(CLuaTable& /*table*/) {}
  /** Sets the other fields of the table. */
  virtual void WriteReadings(CLuaTable& table) const = 0;
};

/** Makes CCI_Sensor a virtual base of a control interface, as ARGoS 3 has it for some of them. */
class CVirtualSensor : virtual public CCI_Sensor {};

extern template class CTableSensorOn<CCI_Sensor>;
extern template class CTableSensorOn<CVirtualSensor>;

typedef CTableSensorOn<CCI_Sensor> CTableSensor;
typedef CTableSensorOn<CVirtualSensor> CVirtualTableSensor;

}  // namespace argos

#endif
