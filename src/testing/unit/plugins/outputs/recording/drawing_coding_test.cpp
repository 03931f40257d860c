#include <argos3/plugins/simulator/outputs/recording/format/drawing_coding.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

namespace drawing_coding_test {

using namespace argos;

namespace {

void DrawEverything(CDrawing& drawing) {
  const CQuaternion turn(CRadians::PI_OVER_TWO, CVector3::Z);
  STextStyle style;
  style.Family = "serif";
  style.IsBold = true;
  style.Alignment = STextStyle::EAlignment::Right;
  drawing.Begin(640, 480);
  drawing.DrawPoint(CVector3(1, 2, 3), CColor::GREEN, 7.0);
  drawing.SetFrame(CVector3(1, 0, 0), turn);
  drawing.DrawLine(CVector3(1, 0, 0), CVector3(2, 0, 0), CColor::BLUE, 2.0);
  drawing.DrawTriangle(CVector3(), turn, 0.5, 1.0, CColor(1, 2, 3, 4), false);
  drawing.DrawCircle(CVector3(0, 0, 1), turn, 0.25, CColor::RED, true, 6);
  drawing.DrawCylinder(CVector3(), turn, 0.5, 2.0);
  drawing.DrawBox(CVector3(), turn, CVector3(1, 2, 3));
  drawing.DrawFace({CVector3(1, 0, 0), CVector3(2, 0, 0), CVector3(1, 0, 3)}, CColor::CYAN);
  drawing.DrawText(CVector3(), "two\nlines", CColor::BLACK, style);
  drawing.SetOverlay();
  drawing.DrawText(CVector3(10, 20, 0), "score", CColor::WHITE);
  drawing.DrawPolygon(CVector3(), CQuaternion(), {CVector2(0, 0), CVector2(9, 0), CVector2(0, 9)});
}

void CheckEqual(const CDrawing& a, const CDrawing& b) {
  REQUIRE(a.GetShapes().size() == b.GetShapes().size());
  for (size_t i = 0; i < a.GetShapes().size(); ++i) {
    const SDrawnShape& one = a.GetShapes()[i];
    const SDrawnShape& other = b.GetShapes()[i];
    CAPTURE(i);
    CHECK(one.Kind == other.Kind);
    CHECK(one.Space == other.Space);
    CHECK(one.IsFilled == other.IsFilled);
    CHECK(one.IsFace == other.IsFace);
    CHECK(one.Color == other.Color);
    CHECK(one.Position == other.Position);
    CHECK(one.Orientation == other.Orientation);
    CHECK((one.Size - other.Size).Length() < 1e-15);
    CHECK(one.Pixels == other.Pixels);
    CHECK(one.Count == other.Count);
    if (one.Kind == SDrawnShape::EKind::Text) {
      CHECK(a.GetText(one) == b.GetText(other));
      CHECK(a.GetStyles()[one.Style] == b.GetStyles()[other.Style]);
    }
  }
  REQUIRE(a.GetCorners().size() == b.GetCorners().size());
  for (size_t i = 0; i < a.GetCorners().size(); ++i) {
    CHECK(a.GetCorners()[i] == b.GetCorners()[i]);
  }
}

std::string Encode(const CDrawing& drawing) {
  std::string bytes;
  CByteWriter out(bytes);
  WriteDrawing(drawing, out);
  return bytes;
}

}  // namespace

TEST_CASE("drawings: all shapes are the same after writing and drawing again",
          "[core][recording][drawing]") {
  CDrawing drawing;
  DrawEverything(drawing);
  const std::string bytes = Encode(drawing);
  CDrawing again;
  again.Begin(640, 480);
  again.SetWorldFrame();
  CByteReader world(bytes);
  DrawAgain(world, SDrawnShape::ESpace::World, again);
  CHECK(again.GetShapes().size() == 8);
  again.SetOverlay();
  CByteReader overlay(bytes);
  DrawAgain(overlay, SDrawnShape::ESpace::Overlay, again);
  CheckEqual(drawing, again);
}

TEST_CASE("drawings: cut and changed bytes give exceptions or drawings, nothing else",
          "[core][recording][drawing]") {
  CDrawing drawing;
  DrawEverything(drawing);
  const std::string bytes = Encode(drawing);
  size_t numErrors = 0;
  const auto read = [&numErrors](const std::string& text) {
    CDrawing again;
    again.Begin(640, 480);
    try {
      CByteReader in(text);
      DrawAgain(in, SDrawnShape::ESpace::World, again);
    } catch (const CARGoSException&) {
      ++numErrors;
    }
  };
  for (size_t length = 1; length < bytes.size(); ++length) {
    read(bytes.substr(0, length));
  }
  CHECK(numErrors > bytes.size() * 9 / 10);
  for (size_t place = 0; place < bytes.size(); ++place) {
    for (const char value : {'\0', '\x7f', '\xff'}) {
      std::string changed = bytes;
      changed[place] = value;
      read(changed);
    }
  }
  // shapes that are no longer finite are left out
  CHECK_THAT(TakeLogErr(), Catch::Contains("is not drawn: its position or size"));
}

}  // namespace drawing_coding_test
