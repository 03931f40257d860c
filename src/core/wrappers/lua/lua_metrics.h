#ifndef ARGOS3_CORE_WRAPPERS_LUA_LUA_METRICS_H
#define ARGOS3_CORE_WRAPPERS_LUA_LUA_METRICS_H

struct lua_State;

namespace argos {

class CLuaArguments;

/** The table "metrics" of scripts; doc/lua.md describes it. */
class CLuaMetrics {
 public:
  /** Creates the global table. */
  static void Register(lua_State* state);

  /** metrics.record(name, value [, unit]): see RecordMetric(). */
  void Record(CLuaArguments& arguments);
};

}  // namespace argos

#endif
