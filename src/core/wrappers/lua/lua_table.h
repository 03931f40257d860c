#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_TABLE_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_TABLE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/wrappers/lua/lua_arguments.h>
#include <argos3/core/wrappers/lua/lua_closure.h>
#include <argos3/core/wrappers/lua/lua_value.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

struct lua_State;

/**
 * @file How a device appears in Lua.
 *
 * An actuator:
 *
 *     void CCI_XActuator::CreateLuaState(lua_State* state) {
 *       CLuaTable wheels(state, *this, "wheels");                          // robot.wheels
 *       wheels.AddMethod<&CCI_XActuator::SetLinearVelocity>("set_velocity", *this);
 *     }
 *
 * Where a method's signature is not enough, use a function without captures. Its parameters after
 * the device are checked like those of a method; a single CLuaArguments& receives all of them:
 *
 *       leds.AddFunction("set_single_color", *this, [](CCI_X& device, CLuaArguments& arguments) {
 *         const auto led = static_cast<UInt32>(arguments.NextIndex(device.GetNumLEDs()));
 *         device.SetSingleColor(led, arguments.Next<CColor>());
 *       });
 *
 * A sensor creates its table with initial values, and updates it before each step of the script:
 *
 *     void CCI_XSensor::CreateLuaState(lua_State* state) {
 *       CLuaTable table(state, *this, "proximity");
 *       WriteReadings(table);
 *     }
 *     void CCI_XSensor::ReadingsToLuaState(lua_State* state) {
 *       CLuaTable table(state, *this);                                     // created above
 *       WriteReadings(table);
 *     }
 *     void CCI_XSensor::WriteReadings(CLuaTable& table) const {
 *       table.SetRecords(m_tReadings, [](CLuaTable& record, const SReading& reading) {
 *         record.Set("value", reading.Value);
 *         if (record.IsNew()) record.Set("angle", reading.Angle);          // never changes
 *       });
 *     }
 *
 * These functions may raise Lua errors (when memory runs out): call them only from CreateLuaState()
 * and ReadingsToLuaState(), which run protected. Tables are popped in the reverse order of their
 * creation, as C++ destroys them.
 */
namespace argos {

/** Access to a Lua table, which stays on the stack for the lifetime of this object. */
class CLuaTable : private CNonCopyable {
 public:
  /**
   * In CreateLuaState(): robot.<name>, created if it does not exist.
   * @throws CARGoSException as CLuaUtility::OpenRobotStateTable() does.
   */
  template <typename DEVICE>
  CLuaTable(lua_State* state, const DEVICE& device, const char* name) : CLuaTable(state) {
    OpenRobotTable(&device, name);
  }

  /**
   * In ReadingsToLuaState(): the table that the device opened in CreateLuaState(), even if the
   * script has changed the global "robot".
   */
  template <typename DEVICE>
  CLuaTable(lua_State* state, const DEVICE& device) : CLuaTable(state) {
    FindRobotTable(&device);
  }

  ~CLuaTable();

  /** True if the constructor, or the call that returned it, created the table. */
  bool IsNew() const { return m_isNew; }
  lua_State* GetState() const { return m_state; }

  /** The table under a key; created if there is none. */
  CLuaTable GetTable(const char* key);
  /** @param index  from 1. */
  CLuaTable GetTable(std::size_t index);
  /**
   * A new table under a key. A table that was there stays as it is: a script may have kept it. If
   * readings are reused, it is returned instead.
   * @param numItems, numFields  that will be set, so that this does not enlarge the table.
   */
  CLuaTable MakeTable(const char* key, std::size_t numItems = 0, std::size_t numFields = 2);

  /**
   * Makes lists of variable length reuse the tables, vectors and colours of their entries, so that
   * readings make no garbage; but then entries that a script has kept change in the next tick. For
   * the tables that are opened after that.
   */
  static void ReuseReadings(lua_State* state);

  /**
   * Adds a function that calls a method of the device.
   * @tparam METHOD  its parameters have types that CLuaArguments::Next() reads; it returns nothing
   * or a type that Set() accepts. Exceptions become Lua errors.
   * @param device  must live as long as the state.
   */
  template <auto METHOD, typename DEVICE>
  void AddMethod(const char* name, DEVICE& device) {
    CLuaClosure::PushMethod<METHOD>(m_state, GetFunctionName(name), device);
    SetField(name);
  }

  /**
   * Adds a function that calls function(device, arguments...); see the top of this file.
   * @param function  a lambda without captures, or a function; its first parameter is a reference
   * to the device.
   */
  template <typename DEVICE, typename FUNCTION>
  void AddFunction(const char* name, DEVICE& device, FUNCTION function) {
    CLuaClosure::PushFunction(m_state, GetFunctionName(name), device, +function);
    SetField(name);
  }

  /** table[key] = value. Numbers become floats, colours tables { red, green, blue }. */
  template <typename T>
  void Set(const char* key, const T& value) {
    if constexpr (kIsObject<T>) {
      if (m_isReused) {
        PushField(key);
        if (CLuaValue::Overwrite(m_state, value)) {
          return;
        }
      }
    }
    CLuaValue::Push(m_state, value);
    SetField(key);
  }
  /** @param index  from 1. */
  template <typename T>
  void Set(std::size_t index, const T& value) {
    if constexpr (kIsObject<T>) {
      if (m_isReused) {
        PushIndex(index);
        if (CLuaValue::Overwrite(m_state, value)) {
          return;
        }
      }
    }
    CLuaValue::Push(m_state, value);
    SetIndex(index);
  }

  /** Replaces the contents by a list of numbers. */
  template <typename T>
  void SetNumbers(const std::vector<T>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      Set(i + 1, static_cast<Real>(numbers[i]));
    }
    Truncate(numbers.size());
  }

  /**
   * Replaces the contents by a list of tables, one for each record; existing tables are reused.
   * @param write  called with the record's CLuaTable& and the record.
   */
  template <typename RECORDS, typename WRITE>
  void SetRecords(const RECORDS& records, WRITE write) {
    std::size_t index = 0;
    for (const auto& record : records) {
      CLuaTable table = GetTable(++index);
      write(table, record);
    }
    Truncate(index);
  }

  /**
   * The same for records of which only one field changes, a number: the name of the field is looked
   * up once.
   * @param number    number(record) is the value of that field.
   * @param writeNew  called as write() above, for the tables that are new only.
   */
  template <typename RECORDS, typename NUMBER, typename WRITE>
  void SetRecords(const RECORDS& records, const char* key, NUMBER number, WRITE writeNew) {
    PushKey(key);
    std::size_t index = 0;
    for (const auto& record : records) {
      const Real value = number(record);
      if (!SetInRecord(++index, value)) {
        CLuaTable table = MakeTable(index, kRecordSizeHint);
        table.Set(key, value);
        writeNew(table, record);
      }
    }
    PopKey();
    Truncate(index);
  }

  /**
   * The same with a new table for each record, so that a script may keep the old ones; unless
   * readings are reused.
   */
  template <typename RECORDS, typename WRITE>
  void SetNewRecords(const RECORDS& records, WRITE write) {
    std::size_t index = 0;
    if (m_isReused) {
      const CLuaTable spares = FindSpares();
      for (const auto& record : records) {
        CLuaTable table = UseSpare(spares, ++index);
        write(table, record);
      }
      Truncate(index);
      return;
    }
    for (const auto& record : records) {
      CLuaTable table = MakeTable(++index, kRecordSizeHint);
      write(table, record);
    }
    Truncate(index);
  }

  /** Removes the entries after the first @p count, so that #table is count. */
  void Truncate(std::size_t count);

 private:
  static constexpr int kRecordSizeHint =
      4;  // fields, so that filling a new table seldom enlarges it

  // values that are userdata or tables in Lua
  template <typename T>
  static constexpr bool kIsObject = std::is_same_v<T, CVector2> || std::is_same_v<T, CVector3> ||
                                    std::is_same_v<T, CQuaternion> || std::is_same_v<T, CColor>;

  explicit CLuaTable(lua_State* state);
  /** Takes the table on top of the stack. */
  CLuaTable(lua_State* state, bool isNew, bool isReused, std::string path);

  CLuaTable MakeTable(std::size_t index, int sizeHint);
  void OpenRobotTable(const void* device, const char* name);
  void FindRobotTable(const void* device);
  std::string GetFunctionName(const char* name) const;
  void SetField(const char* key);
  void SetIndex(std::size_t index);
  void PushKey(const char* key);
  void PopKey();
  /** Sets the field with the key on top in the table at an index. @return false if it is none. */
  bool SetInRecord(std::size_t index, Real number);

  void PushField(const char* key) const;
  void PushIndex(std::size_t index) const;

  // these serve reused readings:
  CLuaTable FindSpares() const;
  CLuaTable UseSpare(const CLuaTable& spares, std::size_t index);

  lua_State* m_state;
  int m_index = 0;  // index on the stack, from its bottom
  bool m_isNew = false;
  bool m_isReused = false;  // readings are, see ReuseReadings()
  std::string m_path;  // "robot.wheels"; only in CreateLuaState()
};

}  // namespace argos

#endif
