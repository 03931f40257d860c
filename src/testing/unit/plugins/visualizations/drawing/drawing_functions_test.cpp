#include <argos3/core/simulator/visualization/drawing_functions.h>

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>

#include <catch2/catch.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace drawing_functions_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

class CBeacon : public CPositionalEntity {
 public:
  ENABLE_VTABLE();
  CBeacon(const std::string& id, const CVector3& position,
          const CQuaternion& orientation = CQuaternion())
      : CPositionalEntity(nullptr, id, position, orientation) {}
};

class CBrightBeacon : public CBeacon {
 public:
  ENABLE_VTABLE();
  using CBeacon::CBeacon;
};

// writes the names of the hooks as texts
class CRecordingFunctions : public CDrawingFunctions {
 public:
  CRecordingFunctions() {
    RegisterUserFunction<CRecordingFunctions, CBeacon>(&CRecordingFunctions::DrawBeacon);
    RegisterUserFunction<CRecordingFunctions, CBoxEntity>(&CRecordingFunctions::DrawABox);
  }

  void DrawBeacon(CBeacon& beacon) { Note("beacon " + beacon.GetId()); }
  void DrawABox(CBoxEntity& box) { Note("box " + box.GetId()); }
  void DrawInWorld() override { Note("world"); }
  void DrawInOverlay() override { Note("overlay"); }

 private:
  void Note(const std::string& text) { GetDrawing().DrawText(CVector3(0.1, 0.0, 0.0), text); }
};

class CFailingFunctions : public CDrawingFunctions {
 public:
  void DrawInWorld() override { throw std::runtime_error("no ink"); }
};

std::vector<std::string> TextsOf(const CDrawing& drawing) {
  std::vector<std::string> texts;
  for (const SDrawnShape& shape : drawing.GetShapes()) {
    texts.emplace_back(drawing.GetText(shape));
  }
  return texts;
}

}  // namespace

TEST_CASE("drawing functions: hooks run for exactly their class, in the order of entities",
          "[core][drawing]") {
  CBeacon second("b2", CVector3());
  CBrightBeacon bright("bright", CVector3());
  CBeacon first("b1", CVector3());
  CBoxEntity box("box", CVector3(), CQuaternion(), false, CVector3(1.0, 1.0, 1.0));
  CLightEntity light("light", CVector3(), CColor::YELLOW, 1.0);
  CRecordingFunctions functions;
  CDrawing drawing;
  drawing.Begin(64, 48);
  functions.DrawAll(drawing, {&second, &bright, &light, &box, &first});
  CHECK(TextsOf(drawing) ==
        std::vector<std::string>{"beacon b2", "box box", "beacon b1", "world", "overlay"});
  CHECK(drawing.GetShapes()[3].Space == SDrawnShape::ESpace::World);
  CHECK(drawing.GetShapes()[4].Space == SDrawnShape::ESpace::Overlay);
}

TEST_CASE("drawing functions: hooks of entities draw in their frame, others in the world's",
          "[core][drawing]") {
  CBeacon turned("b", CVector3(1.0, 2.0, 0.0), CQuaternion(CRadians::PI, CVector3::Z));
  CBoxEntity box("box", CVector3(-1.0, 0.0, 0.5), CQuaternion(), false, CVector3(1.0, 1.0, 1.0));
  CRecordingFunctions functions;
  CDrawing drawing;
  drawing.Begin(64, 48);
  functions.DrawAll(drawing, {&turned, &box});
  REQUIRE(drawing.GetShapes().size() == 4);
  // 1e-12: roundings of the rotation
  CHECK(Distance(drawing.GetShapes()[0].Position, CVector3(0.9, 2.0, 0.0)) < 1e-12);
  CHECK(Distance(drawing.GetShapes()[1].Position, CVector3(-0.9, 0.0, 0.5)) < 1e-12);
  CHECK(drawing.GetShapes()[2].Position == CVector3(0.1, 0.0, 0.0));
}

TEST_CASE("drawing functions: Call() does nothing for a class without a hook", "[core][drawing]") {
  CRecordingFunctions functions;
  CLightEntity light("light", CVector3(), CColor::YELLOW, 1.0);
  CHECK_NOTHROW(functions.Call(light));
}

TEST_CASE("drawing functions: drawing outside of hooks is an error", "[core][drawing]") {
  CFailingFunctions functions;
  CHECK_THROWS_WITH(functions.GetDrawing(), Contains("only in hooks that draw"));
  CDrawing drawing;
  drawing.Begin(64, 48);
  CHECK_THROWS_WITH(functions.DrawAll(drawing, {}), Contains("no ink"));
  // also after a hook has thrown
  CHECK_THROWS_AS(functions.GetDrawing(), CARGoSException);
}

}  // namespace drawing_functions_test
