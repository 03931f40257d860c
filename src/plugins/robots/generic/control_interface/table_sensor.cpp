#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

class CColumnList final : public CNumberList {
 public:
  void Add(const char* name, const char* unit, Real /*value*/) override {
    Columns.push_back({name, unit});
  }

  std::vector<CCI_Sensor::SColumn> Columns;
};

class CNumberCopy final : public CNumberList {
 public:
  CNumberCopy(Real* numbers, std::size_t count) : m_next(numbers), m_end(numbers + count) {}

  void Add(const char* /*name*/, const char* /*unit*/, Real value) override {
    if (m_next != m_end) {
      *m_next++ = value;
    }
  }

 private:
  Real* m_next;
  Real* m_end;
};

class CFieldList final : public CNumberList {
 public:
  explicit CFieldList(CLuaTable& table) : m_table(table) {}

  void Add(const char* name, const char* /*unit*/, Real value) override {
    m_table.Set(name, value);
  }

 private:
  CLuaTable& m_table;
};

}  // namespace

template <class BASE>
void CTableSensorOn<BASE>::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, GetLuaName());
  WriteConstants(table);
  WriteReadings(table);
}

template <class BASE>
void CTableSensorOn<BASE>::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  WriteReadings(table);
}

template <class BASE>
std::vector<CCI_Sensor::SColumn> CTableSensorOn<BASE>::GetReadingColumns() const {
  CColumnList list;
  ListNumbers(list);
  return list.Columns;
}

template <class BASE>
void CTableSensorOn<BASE>::CopyReadings(Real* numbers, std::size_t count) const {
  CNumberCopy list(numbers, count);
  ListNumbers(list);
}

template <class BASE>
void CTableSensorOn<BASE>::WriteReadings(CLuaTable& table) const {
  CFieldList list(table);
  ListNumbers(list);
}

template class CTableSensorOn<CCI_Sensor>;
template class CTableSensorOn<CVirtualSensor>;

}  // namespace argos
