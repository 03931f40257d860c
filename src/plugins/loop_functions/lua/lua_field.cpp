// The field of global variables of robots' Lua scripts.

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/controller_field.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/wrappers/lua/lua_controller.h>
#include <argos3/core/wrappers/lua/lua_headers.h>

#include <cstdio>
#include <set>
#include <utility>

namespace argos {

namespace {

// null if the robot runs no script
lua_State* GetScript(CControllableEntity& robot) {
  auto* const controller =
      robot.HasController() ? dynamic_cast<CLuaController*>(&robot.GetController()) : nullptr;
  return controller != nullptr ? controller->GetLuaState() : nullptr;
}

int PushGlobal(lua_State* state) {
  const auto* const name = static_cast<const char*>(lua_touserdata(state, 1));
  lua_pushglobaltable(state);
  lua_pushstring(state, name);
  lua_rawget(state, -2);
  return 1;
}

/* Calls use(type) with the value of a global variable on top of the stack. */
template <typename USE>
void WithGlobal(lua_State* state, const std::string& name, USE use) {
  const int top = lua_gettop(state);
  if (lua_checkstack(state, 4) != 0) {
    // protected, because the name needs memory of the script
    lua_pushcfunction(state, &PushGlobal);
    lua_pushlightuserdata(state, const_cast<char*>(name.c_str()));
    if (lua_pcall(state, 1, 1, 0) == LUA_OK) {
      use(lua_type(state, -1));
    }
  }
  lua_settop(state, top);
}

double ToNumber(lua_State* state, int type) {
  return type == LUA_TBOOLEAN ? lua_toboolean(state, -1) : lua_tonumber(state, -1);
}

/* Says once that values are left out. */
struct SWarning {
  bool WasGiven = false;
};

class CLuaReader : public CFieldReader {
 public:
  CLuaReader(CControllableEntity& robot, std::string name, std::shared_ptr<SWarning> warning)
      : m_robot(robot), m_name(std::move(name)), m_warning(std::move(warning)) {}

  void Read(std::size_t /*index*/, SFieldRow row) override {
    lua_State* const state = GetScript(m_robot);
    if (state == nullptr) {
      return;
    }
    WithGlobal(state, m_name, [&](int type) {
      if (row.Columns[0].Kind == EColumnKind::Text) {
        row.Numbers[0] = ReadText(state, type, row.Texts);
      } else if (type == LUA_TNUMBER || type == LUA_TBOOLEAN) {
        row.Numbers[0] = ToNumber(state, type);
      } else if (type != LUA_TNIL) {
        Warn(type);
      }
    });
  }

 private:
  double ReadText(lua_State* state, int type, CRowTexts& texts) {
    std::size_t length = 0;
    if (type == LUA_TSTRING) {
      const char* const text = lua_tolstring(state, -1, &length);
      return texts.Add({text, length});
    }
    if (type == LUA_TNUMBER || type == LUA_TBOOLEAN) {
      char text[32];
      std::snprintf(text, sizeof text, "%.17g", ToNumber(state, type));
      return texts.Add(text);
    }
    if (type != LUA_TNIL) {
      Warn(type);
    }
    return texts.Add({});
  }

  void Warn(int type) {
    if (!std::exchange(m_warning->WasGiven, true)) {
      LOGERR << "[WARNING] field \"lua:" << m_name << "\": in robot \""
             << m_robot.GetRootEntity().GetId() << "\" the variable is now a "
             << lua_typename(GetScript(m_robot), type)
             << ", which its column cannot contain: such values are left out" << std::endl;
    }
  }

  CControllableEntity& m_robot;
  std::string m_name;
  std::shared_ptr<SWarning> m_warning;  // warning of all robots
};

class CLuaField : public CControllerField {
 private:
  SBoundField BindRobot(CControllableEntity& robot, const std::string& argument) const override {
    SBoundField bound;
    lua_State* const state = GetScript(robot);
    if (state == nullptr) {
      return bound;
    }
    const std::string column = "lua_" + ToColumnName(argument);
    bool canBeRead = false;
    WithGlobal(state, argument, [&](int type) {
      canBeRead = type == LUA_TNIL || IsValue(type);
      if (type == LUA_TSTRING) {
        bound.Columns = {{column, "", EColumnKind::Text}};
      } else if (IsValue(type)) {
        bound.Columns = {{column, ""}};
      }
    });
    if (canBeRead) {
      bound.Reader = std::make_unique<CLuaReader>(robot, argument, m_warning);
    }
    return bound;
  }

  void ListNamesOf(CControllableEntity& robot, const std::string& prefix,
                   std::vector<std::string>& names) const override {
    lua_State* const state = GetScript(robot);
    if (state == nullptr) {
      return;
    }
    const int top = lua_gettop(state);
    std::set<std::string> sorted;
    if (lua_checkstack(state, 4) != 0) {
      lua_pushglobaltable(state);
      lua_pushnil(state);
      while (lua_next(state, -2) != 0) {
        if (lua_type(state, -2) == LUA_TSTRING && IsValue(lua_type(state, -1))) {
          sorted.insert(prefix + lua_tostring(state, -2));
        }
        lua_pop(state, 1);
      }
    }
    lua_settop(state, top);
    names.insert(names.end(), sorted.begin(), sorted.end());
  }

  static bool IsValue(int type) {
    return type == LUA_TNUMBER || type == LUA_TBOOLEAN || type == LUA_TSTRING;
  }

  std::shared_ptr<SWarning> m_warning = std::make_shared<SWarning>();
};

}  // namespace

REGISTER_FIELD(
    CLuaField, "lua", "the authors of this project", "1.0",
    "A global variable of the robots' Lua scripts: lua:NAME.",
    R"(Column lua_NAME: the value after the tick. A number, true and false as 1 and 0, or a text: what
the variable has in the first robot that has it, at the start of the table. Later values of another
kind are left out (a warning says so once), and so are robots without a script or without the
variable.
)",
    "Usable")

}  // namespace argos
