#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_TABLE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_TABLE_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>

namespace argos {

class CLuaTable;

/** Receives the numbers of a sensor's readings, one after the other. */
class CNumberList {
 public:
  /** @param name, unit  as in CCI_Sensor::SColumn. */
  virtual void Add(const char* name, const char* unit, Real value) = 0;

 protected:
  ~CNumberList() = default;
};

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

  std::vector<CCI_Sensor::SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

 private:
  virtual const char* GetLuaName() const = 0;
  /** Sets the constant fields of the new table, and its functions; by default none. */
  virtual void WriteConstants(CLuaTable& /*table*/) {}

 protected:
  /**
   * Lists the numbers for tables of results, always as many and in the same order; by default none.
   */
  virtual void ListNumbers(CNumberList& /*list*/) const {}
  /** Sets the other fields of the table; by default those that ListNumbers() lists. */
  virtual void WriteReadings(CLuaTable& table) const;
};

/** Makes CCI_Sensor a virtual base of a control interface, as ARGoS 3 has it for some of them. */
class CVirtualSensor : virtual public CCI_Sensor {};

extern template class CTableSensorOn<CCI_Sensor>;
extern template class CTableSensorOn<CVirtualSensor>;

typedef CTableSensorOn<CCI_Sensor> CTableSensor;
typedef CTableSensorOn<CVirtualSensor> CVirtualTableSensor;

}  // namespace argos

#endif
