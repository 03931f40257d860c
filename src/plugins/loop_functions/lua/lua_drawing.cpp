#include <argos3/plugins/simulator/loop_functions/lua/lua_drawing.h>

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/wrappers/lua/lua_closure.h>
#include <argos3/core/wrappers/lua/lua_types.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <cmath>
#include <string>
#include <vector>

namespace argos {

namespace {

constexpr Real kDefaultPoint = 5.0;  // pixels, as in CDrawing
constexpr Real kDefaultLine = 1.0;  // pixels

template <auto METHOD>
void AddMethod(lua_State* state, const char* name, CLuaDrawing& functions) {
  CLuaClosure::PushMethod<METHOD>(state, std::string("draw.") + name, functions);
  lua_setfield(state, -2, name);
}

// an argument that may be missing
template <typename T>
T NextOr(CLuaArguments& arguments, const T& missing) {
  if (arguments.IsNextNil()) {
    arguments.Skip();
    return missing;
  }
  return arguments.Next<T>();
}

// a size that must be positive
Real NextSize(CLuaArguments& arguments, const char* what) {
  const Real size = arguments.Next<Real>();
  if (!(size > 0.0) || std::isinf(size)) {
    THROW_ARGOSEXCEPTION(what << " must be a positive number, got " << size);
  }
  return size;
}

// the first argument: a list of vectors
std::vector<CVector3> FirstPlaces(CLuaArguments& arguments, size_t least) {
  const std::string expected = "a list of at least " + std::to_string(least) + " vector3";
  if (!arguments.IsNextTable()) {
    arguments.ThrowNextMustBe(expected);
  }
  constexpr int kList = 1;  // place on the stack of the call
  lua_State* const state = arguments.GetState();
  std::vector<CVector3> places;
  const size_t count = lua_rawlen(state, kList);
  places.reserve(count);
  for (size_t i = 1; i <= count; ++i) {
    lua_rawgeti(state, kList, static_cast<lua_Integer>(i));
    const CVector3* const place = CLuaType<CVector3>::Test(state, -1);
    if (place != nullptr) {
      places.push_back(*place);
    }
    lua_pop(state, 1);
  }
  if (places.size() < count || count < least) {
    arguments.ThrowNextMustBe(expected);
  }
  arguments.Skip();
  return places;
}

CQuaternion YawOf(const CRadians& angle) {
  return CQuaternion(angle, CVector3::Z);
}

}  // namespace

void CLuaDrawing::Register(lua_State* state) {
  lua_newtable(state);
  AddMethod<&CLuaDrawing::DrawPoint>(state, "point", *this);
  AddMethod<&CLuaDrawing::DrawLine>(state, "line", *this);
  AddMethod<&CLuaDrawing::DrawPath>(state, "path", *this);
  AddMethod<&CLuaDrawing::DrawTriangle>(state, "triangle", *this);
  AddMethod<&CLuaDrawing::DrawPolygon>(state, "polygon", *this);
  AddMethod<&CLuaDrawing::DrawCircle>(state, "circle", *this);
  AddMethod<&CLuaDrawing::DrawCylinder>(state, "cylinder", *this);
  AddMethod<&CLuaDrawing::DrawBox>(state, "box", *this);
  AddMethod<&CLuaDrawing::DrawText>(state, "text", *this);
  lua_setglobal(state, "draw");
}

CDrawing& CLuaDrawing::GetDrawing() {
  if (m_drawing == nullptr) {
    THROW_ARGOSEXCEPTION("drawing is possible in draw_in_world() and draw_in_overlay() only");
  }
  return *m_drawing;
}

// draw.point(position, color [, diameter])
void CLuaDrawing::DrawPoint(CLuaArguments& arguments) {
  const auto position = arguments.Next<CVector3>();
  const auto color = arguments.Next<CColor>();
  const Real diameter = NextOr(arguments, kDefaultPoint);
  arguments.Finish();
  GetDrawing().DrawPoint(position, color, diameter);
}

// draw.line(start, end, color [, width])
void CLuaDrawing::DrawLine(CLuaArguments& arguments) {
  const auto start = arguments.Next<CVector3>();
  const auto end = arguments.Next<CVector3>();
  const auto color = arguments.Next<CColor>();
  const Real width = NextOr(arguments, kDefaultLine);
  arguments.Finish();
  GetDrawing().DrawLine(start, end, color, width);
}

// draw.path(positions, color [, width])
void CLuaDrawing::DrawPath(CLuaArguments& arguments) {
  const std::vector<CVector3> places = FirstPlaces(arguments, 0);
  const auto color = arguments.Next<CColor>();
  const Real width = NextOr(arguments, kDefaultLine);
  arguments.Finish();
  for (size_t i = 1; i < places.size(); ++i) {
    GetDrawing().DrawLine(places[i - 1], places[i], color, width);
  }
}

// draw.triangle(position, yaw, base, height, color [, filled])
void CLuaDrawing::DrawTriangle(CLuaArguments& arguments) {
  const auto position = arguments.Next<CVector3>();
  const auto yaw = arguments.Next<CRadians>();
  const Real base = NextSize(arguments, "the base (m)");
  const Real height = NextSize(arguments, "the height (m)");
  const auto color = arguments.Next<CColor>();
  const bool filled = NextOr(arguments, true);
  arguments.Finish();
  GetDrawing().DrawTriangle(position, YawOf(yaw), base, height, color, filled);
}

// draw.polygon(corners, color [, filled])
void CLuaDrawing::DrawPolygon(CLuaArguments& arguments) {
  const std::vector<CVector3> places = FirstPlaces(arguments, 3);
  const auto color = arguments.Next<CColor>();
  const bool filled = NextOr(arguments, true);
  arguments.Finish();
  // level, at the height of the first corner
  std::vector<CVector2> corners;
  corners.reserve(places.size());
  for (const CVector3& place : places) {
    corners.emplace_back(place.GetX(), place.GetY());
  }
  GetDrawing().DrawPolygon(CVector3(0.0, 0.0, places.front().GetZ()), CQuaternion(), corners, color,
                           filled);
}

// draw.circle(position, radius, color [, filled])
void CLuaDrawing::DrawCircle(CLuaArguments& arguments) {
  const auto position = arguments.Next<CVector3>();
  const Real radius = NextSize(arguments, "the radius (m)");
  const auto color = arguments.Next<CColor>();
  const bool filled = NextOr(arguments, true);
  arguments.Finish();
  GetDrawing().DrawCircle(position, CQuaternion(), radius, color, filled);
}

// draw.cylinder(position, radius, height, color)
void CLuaDrawing::DrawCylinder(CLuaArguments& arguments) {
  const auto position = arguments.Next<CVector3>();
  const Real radius = NextSize(arguments, "the radius (m)");
  const Real height = NextSize(arguments, "the height (m)");
  const auto color = arguments.Next<CColor>();
  arguments.Finish();
  GetDrawing().DrawCylinder(position, CQuaternion(), radius, height, color);
}

// draw.box(position, size, color [, yaw])
void CLuaDrawing::DrawBox(CLuaArguments& arguments) {
  const auto position = arguments.Next<CVector3>();
  const auto size = arguments.Next<CVector3>();
  const auto color = arguments.Next<CColor>();
  const CRadians yaw = NextOr(arguments, CRadians::ZERO);
  arguments.Finish();
  GetDrawing().DrawBox(position, YawOf(yaw), size, color);
}

// draw.text(position, text [, color [, size]])
void CLuaDrawing::DrawText(CLuaArguments& arguments) {
  const auto position = arguments.Next<CVector3>();
  const auto text = arguments.Next<std::string>();
  const CColor color = NextOr(arguments, CColor::BLACK);
  STextStyle style;
  if (!arguments.IsNextNil()) {
    style.Size = NextSize(arguments, "the size (pixels)");
  }
  arguments.Finish();
  GetDrawing().DrawText(position, text, color, style);
}

}  // namespace argos
