#ifndef ARGOS3_CORE_CONTROL_INTERFACE_CI_SENSOR_H
#define ARGOS3_CORE_CONTROL_INTERFACE_CI_SENSOR_H

#include <argos3/core/config.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

struct lua_State;

namespace argos {

/** Interface of a sensor for controllers, on the real robot and in the simulator. */
class CCI_Sensor : public CBaseConfigurableResource {
 public:
  /** Sensors by type, which is the tag in the experiment file. */
  typedef std::map<std::string, CCI_Sensor*, std::less<std::string> > TMap;

  ~CCI_Sensor() override;

  void Init(TConfigurationNode& node) override;
  void Reset() override;
  void Destroy() override;

  /**
   * A sensor is updated in every tick unless Disable() was called after the last Enable(). So one
   * for which neither was called is updated, although IsEnabled() is false.
   */
  virtual void Enable();
  virtual void Disable();
  bool IsEnabled() const { return m_bEnabled; }
  bool IsDisabled() const { return !m_bEnabled; }
  /** @return true if the sensor is updated. */
  bool IsSwitchedOn() const { return !m_switchedOff; }
  /** Called at the start of the run: stores the state that Reset() restores. */
  void MarkStart();
  void ReturnToStart();

  /**
   * For Lua controllers: adds the sensor's functions and readings to the table "robot" on top of
   * the stack. Without an override a sensor is not available in Lua.
   */
  virtual void CreateLuaState(lua_State* state);

  /** For Lua controllers: copies the readings into the table that CreateLuaState() created. */
  virtual void ReadingsToLuaState(lua_State* state);

  /** One number of the readings, in tables of results. */
  struct SColumn {
    std::string Name; /**< letters, digits and '_': "1", "2", ... or "velocity_left" */
    std::string Unit; /**< unit that controllers see, such as "cm"; "" for none */
  };

  /**
   * The numbers that CopyReadings() copies. Without an override, tables of results cannot contain
   * the readings of this sensor.
   */
  virtual std::vector<SColumn> GetReadingColumns() const;

  /**
   * For tables of results: copies the current readings.
   * @param numbers  one for each of the first columns, NaN before the call.
   * @param count    how many; at most as many are written.
   */
  virtual void CopyReadings(Real* numbers, std::size_t count) const;

  /** Columns "1" to "<count>" with one unit, for overrides of GetReadingColumns(). */
  static std::vector<SColumn> MakeNumberedColumns(std::size_t count, const std::string& unit = "");
  /** Copies the first @p count of @p from, for overrides of CopyReadings(). */
  static void CopyNumbers(std::initializer_list<Real> from, Real* numbers, std::size_t count);

 protected:
  bool m_bEnabled = false;

 private:
  bool m_switchedOff = false;
  bool m_enabledAtStart = false;
  bool m_switchedOffAtStart = false;
};

}  // namespace argos

#endif
