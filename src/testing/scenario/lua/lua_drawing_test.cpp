// Shapes that Lua loop functions draw.

#include "lua_world.h"

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace lua_drawing_test {

using namespace argos;
using Catch::Contains;

namespace {

using EKind = SDrawnShape::EKind;

/** What loop functions draw whose hooks are the given code. */
class CPicture {
 public:
  explicit CPicture(const std::string& inWorld, const std::string& inOverlay = "",
                    const std::string& more = "")
      : m_world(WithLoopFunctions(more + "\nfunction draw_in_world() " + inWorld +
                                  "\nend function draw_in_overlay() " + inOverlay + "\nend")) {
    TakeLog();
  }

  CDrawing& Draw() {
    CLoopFunctions& functions = m_world.GetSimulator().GetLoopFunctions();
    m_drawing.Begin(640, 480);
    m_drawing.SetWorldFrame();
    functions.DrawInWorld(m_drawing);
    m_drawing.SetOverlay();
    functions.DrawInOverlay(m_drawing);
    return m_drawing;
  }
  CLuaWorld& GetWorld() { return m_world; }

 private:
  CLuaWorld m_world;
  CDrawing m_drawing;
};

std::string ErrorOf(const std::string& call) {
  CPicture picture(call);
  try {
    picture.Draw();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("lua drawing: every function adds its shape", "[lua][drawing]") {
  CPicture picture(
      "draw.point(vector3(1, 2, 3), 'red', 7)\n"
      "draw.line(vector3(1, 0, 0), vector3(3, 1, 0), '0,0,255,128', 2)\n"
      "draw.circle(vector3(0, 0, 0.1), 0.5, 0, 255, 0, false)\n"
      "draw.triangle(vector3(1, 1, 0), math.pi / 2, 0.2, 0.4, 'red')\n"
      "draw.polygon({ vector3(0, 0, 0.5), vector3(1, 0, 9), vector3(1, 1, 9) }, 'green')\n"
      "draw.cylinder(vector3(0, 0, 1), 0.25, 0.5, 'yellow')\n"
      "draw.box(vector3(2, 0, 0), vector3(1, 2, 3), 'gray50')\n"
      "draw.text(vector3(0, 0, 1), 'here')");
  const CDrawing& drawing = picture.Draw();
  const std::vector<SDrawnShape>& shapes = drawing.GetShapes();
  REQUIRE(shapes.size() == 8);
  for (const SDrawnShape& shape : shapes) {
    CHECK(shape.Space == SDrawnShape::ESpace::World);
  }
  CHECK(shapes[0].Kind == EKind::Point);
  CHECK(shapes[0].Position == CVector3(1, 2, 3));
  CHECK(shapes[0].Color == CColor::RED);
  CHECK(shapes[0].Pixels == 7.0);

  CHECK(shapes[1].Kind == EKind::Line);
  CHECK(shapes[1].Position == CVector3(1, 0, 0));
  CHECK(shapes[1].Size == CVector3(2, 1, 0));
  CHECK(shapes[1].Color == CColor(0, 0, 255, 128));
  CHECK(shapes[1].Pixels == 2.0);

  CHECK(shapes[2].Kind == EKind::Circle);
  CHECK(shapes[2].Size.GetX() == 0.5);
  CHECK(shapes[2].Color == CColor(0, 255, 0));
  CHECK_FALSE(shapes[2].IsFilled);

  CHECK(shapes[3].Kind == EKind::Polygon);
  CHECK(shapes[3].Count == 3);
  CHECK(shapes[3].IsFilled);
  CHECK(shapes[3].Orientation == CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));

  CHECK(shapes[4].Kind == EKind::Polygon);
  CHECK(shapes[4].Position == CVector3(0, 0, 0.5));
  REQUIRE(shapes[4].Count == 3);
  CHECK(drawing.GetCorners()[shapes[4].First + 2] == CVector2(1, 1));

  CHECK(shapes[5].Kind == EKind::Cylinder);
  CHECK(shapes[5].Size == CVector3(0.5, 0.5, 0.5));
  CHECK(shapes[6].Kind == EKind::Box);
  CHECK(shapes[6].Size == CVector3(1, 2, 3));
  CHECK(shapes[7].Kind == EKind::Text);
  CHECK(drawing.GetText(shapes[7]) == "here");
  CHECK(shapes[7].Color == CColor::BLACK);
}

TEST_CASE("lua drawing: a path has a line between each two places", "[lua][drawing]") {
  CPicture picture(
      "draw.path(trail, 'red', 3)", "",
      "trail = {}\n"
      "function post_step() trail[#trail + 1] = vector3(simulation.clock(), 0, 0) end");
  CHECK(picture.Draw().GetShapes().empty());
  picture.GetWorld().Step(4);
  const std::vector<SDrawnShape>& shapes = picture.Draw().GetShapes();
  REQUIRE(shapes.size() == 3);
  CHECK(shapes[2].Position == CVector3(3, 0, 0));
  CHECK(shapes[2].Size == CVector3(1, 0, 0));
  CHECK(shapes[2].Pixels == 3.0);
}

TEST_CASE("lua drawing: the overlay is in pixels", "[lua][drawing]") {
  CPicture picture("", "draw.text(vector3(10, 30, 0), simulation.time() .. ' s', 'white', 20)");
  picture.GetWorld().Step(2);
  const CDrawing& drawing = picture.Draw();
  REQUIRE(drawing.GetShapes().size() == 1);
  const SDrawnShape& text = drawing.GetShapes()[0];
  CHECK(text.Space == SDrawnShape::ESpace::Overlay);
  CHECK(text.Position == CVector3(10, 30, 0));
  CHECK(drawing.GetText(text) == "0.2 s");
  CHECK(drawing.GetStyles()[text.Style].Size == 20.0);
}

TEST_CASE("lua drawing: wrong calls are errors with function and line", "[lua][drawing][errors]") {
  CHECK_THAT(ErrorOf("draw.point(1, 2)"),
             Contains("failed in draw_in_world()") && Contains("loop.lua:2:") &&
                 Contains("draw.point: argument 1 must be a vector3, got 1"));
  CHECK_THAT(ErrorOf("draw.point(vector3(0,0,0))"), Contains("argument 2 must be the name of a "));
  CHECK_THAT(ErrorOf("draw.point(vector3(0,0,0), 'red', 5, 6)"), Contains("too many arguments"));
  CHECK_THAT(ErrorOf("draw.circle(vector3(0,0,0), -1, 'red')"),
             Contains("the radius (m) must be a positive number, got -1"));
  CHECK_THAT(ErrorOf("draw.circle(vector3(0,0,0), 0/0, 'red')"), Contains("positive number"));
  CHECK_THAT(ErrorOf("draw.polygon({ vector3(0,0,0) }, 'red')"),
             Contains("argument 1 must be a list of at least 3 vector3"));
  CHECK_THAT(ErrorOf("draw.path({ vector3(0,0,0), 7 }, 'red')"),
             Contains("argument 1 must be a list of at least 0 vector3"));
  CHECK_THAT(ErrorOf("draw.path('x', 'red')"), Contains("argument 1 must be a list"));
  CHECK_THAT(ErrorOf("draw.text(vector3(0,0,0), 'a', 'red', 0)"), Contains("size (pixels)"));
}

TEST_CASE("lua drawing: outside of its hooks, drawing is an error", "[lua][drawing][errors]") {
  CHECK_THAT(LoadError(WithLoopFunctions("function init() draw.point(vector3(0,0,0), 'red') end")),
             Contains("drawing is possible in draw_in_world() and draw_in_overlay() only"));
}

TEST_CASE("lua drawing: a script may have these hooks alone", "[lua][drawing]") {
  CHECK(LoadError(WithLoopFunctions("function draw_in_world() end")) == "");
}

}  // namespace lua_drawing_test
