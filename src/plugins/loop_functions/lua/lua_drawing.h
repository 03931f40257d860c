#ifndef ARGOS3_PLUGINS_LOOP_FUNCTIONS_LUA_LUA_DRAWING_H
#define ARGOS3_PLUGINS_LOOP_FUNCTIONS_LUA_LUA_DRAWING_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/wrappers/lua/lua_arguments.h>

struct lua_State;

namespace argos {

class CDrawing;

/**
 * The functions of the table "draw", with which the hooks draw_in_world() and draw_in_overlay() of
 * Lua loop functions add shapes to a picture; doc/lua.md describes them. Wrong arguments, and calls
 * outside of these hooks, throw, and so become Lua errors.
 */
class CLuaDrawing {
 public:
  /** Creates the global table. */
  void Register(lua_State* state);

  /** The functions add to @p drawing during its lifetime. */
  class CScope : private CNonCopyable {
   public:
    CScope(CLuaDrawing& functions, CDrawing& drawing) : m_functions(functions) {
      functions.m_drawing = &drawing;
    }
    ~CScope() { m_functions.m_drawing = nullptr; }

   private:
    CLuaDrawing& m_functions;
  };

  void DrawPoint(CLuaArguments& arguments);
  void DrawLine(CLuaArguments& arguments);
  void DrawPath(CLuaArguments& arguments);
  void DrawTriangle(CLuaArguments& arguments);
  void DrawPolygon(CLuaArguments& arguments);
  void DrawCircle(CLuaArguments& arguments);
  void DrawCylinder(CLuaArguments& arguments);
  void DrawBox(CLuaArguments& arguments);
  void DrawText(CLuaArguments& arguments);

 private:
  CDrawing& GetDrawing();

  CDrawing* m_drawing = nullptr;  // null outside of hooks
};

}  // namespace argos

#endif
