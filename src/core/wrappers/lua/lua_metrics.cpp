#include <argos3/core/wrappers/lua/lua_metrics.h>

#include <argos3/core/control_interface/metric_recorder.h>
#include <argos3/core/wrappers/lua/lua_arguments.h>
#include <argos3/core/wrappers/lua/lua_closure.h>
#include <argos3/core/wrappers/lua/lua_headers.h>

#include <string_view>

namespace argos {

void CLuaMetrics::Register(lua_State* state) {
  static CLuaMetrics metrics;  // has no data
  lua_newtable(state);
  CLuaClosure::PushMethod<&CLuaMetrics::Record>(state, "metrics.record", metrics);
  lua_setfield(state, -2, "record");
  lua_setglobal(state, "metrics");
}

void CLuaMetrics::Record(CLuaArguments& arguments) {
  const std::string_view name = arguments.NextText();
  const Real value = arguments.Next<Real>();
  const std::string_view unit = arguments.HasNext() ? arguments.NextText() : std::string_view();
  arguments.Finish();
  RecordMetric(name, value, unit);
}

}  // namespace argos
