#include <argos3/core/simulator/visualization/drawing.h>

#include <argos3/testing/support/captured_logs.h>

#include <catch2/catch.hpp>

#include <limits>

namespace visualization_drawing_test {

using namespace argos;
using Catch::WithinAbs;
using Catch::Matchers::Contains;

namespace {

typedef SDrawnShape::EKind EKind;

// roundings of rotations of values of about 1
constexpr Real kRounding = 1e-12;

const CQuaternion kQuarterTurn(CRadians::PI_OVER_TWO, CVector3::Z);

void CheckVector(const CVector3& found, const CVector3& expected) {
  CHECK_THAT(found.GetX(), WithinAbs(expected.GetX(), kRounding));
  CHECK_THAT(found.GetY(), WithinAbs(expected.GetY(), kRounding));
  CHECK_THAT(found.GetZ(), WithinAbs(expected.GetZ(), kRounding));
}

// a drawing whose frame is at (1,2,3), turned left by a quarter
CDrawing MakeTurnedDrawing() {
  CDrawing drawing;
  drawing.Begin(640, 480);
  drawing.SetFrame(CVector3(1.0, 2.0, 3.0), kQuarterTurn);
  return drawing;
}

const SDrawnShape& OnlyShape(const CDrawing& drawing) {
  REQUIRE(drawing.GetShapes().size() == 1);
  return drawing.GetShapes()[0];
}

}  // namespace

TEST_CASE("drawing: a point has its place in the world, its colour and its diameter",
          "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  drawing.DrawPoint(CVector3(0.5, 0.0, 0.1), CColor::GREEN, 7.0);
  const SDrawnShape& shape = OnlyShape(drawing);
  CHECK(shape.Kind == EKind::Point);
  CHECK(shape.Space == SDrawnShape::ESpace::World);
  CHECK(shape.Color == CColor::GREEN);
  CHECK(shape.Pixels == 7.0);
  CheckVector(shape.Position, CVector3(1.0, 2.5, 3.1));
}

TEST_CASE("drawing: a line has both ends in the world", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  drawing.DrawLine(CVector3(0.5, 0.0, 0.0), CVector3(1.5, -1.0, 2.0), CColor::BLUE, 3.0);
  const SDrawnShape& shape = OnlyShape(drawing);
  CHECK(shape.Kind == EKind::Line);
  CHECK(shape.Color == CColor::BLUE);
  CHECK(shape.Pixels == 3.0);
  CheckVector(shape.Position, CVector3(1.0, 2.5, 3.0));
  CheckVector(shape.Position + shape.Size, CVector3(2.0, 3.5, 5.0));
}

TEST_CASE("drawing: a triangle has its tip ahead, and is centred on its height",
          "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  drawing.DrawTriangle(CVector3(), CQuaternion(), 0.2, 0.6, CColor::RED, false);
  const SDrawnShape& shape = OnlyShape(drawing);
  CHECK(shape.Kind == EKind::Polygon);
  CHECK_FALSE(shape.IsFilled);
  CHECK(shape.Pixels > 0.0);
  REQUIRE(shape.Count == 3);
  CHECK(drawing.GetCorners()[shape.First] == CVector2(0.3, 0.0));
  CHECK(drawing.GetCorners()[shape.First + 1] == CVector2(-0.3, 0.1));
  CHECK(drawing.GetCorners()[shape.First + 2] == CVector2(-0.3, -0.1));
}

TEST_CASE("drawing: polygons keep their corners, orientation and fill", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  const std::vector<CVector2> square = {CVector2(0.0, 0.0), CVector2(1.0, 0.0), CVector2(1.0, 1.0),
                                        CVector2(0.0, 1.0)};
  const std::vector<CVector2> arrow = {CVector2(0.0, 0.0), CVector2(-1.0, 1.0), CVector2(2.0, 0.0)};
  drawing.DrawPolygon(CVector3(), CQuaternion(), square, CColor::CYAN);
  drawing.DrawPolygon(CVector3(), kQuarterTurn, arrow, CColor::CYAN, false);
  REQUIRE(drawing.GetShapes().size() == 2);
  const SDrawnShape& first = drawing.GetShapes()[0];
  const SDrawnShape& second = drawing.GetShapes()[1];
  CHECK(first.IsFilled);
  CHECK(first.Count == 4);
  CHECK(second.First == 4);
  CHECK(second.Count == 3);
  CHECK(drawing.GetCorners()[second.First + 2] == CVector2(2.0, 0.0));
  // two quarters to the left: x points backwards
  CVector3 ahead = CVector3::X;
  ahead.Rotate(second.Orientation);
  CheckVector(ahead, -CVector3::X);
  // fewer corners are no area
  drawing.DrawPolygon(CVector3(), CQuaternion(), {CVector2(), CVector2(1.0, 1.0)});
  CHECK(drawing.GetShapes().size() == 2);
}

TEST_CASE("drawing: a face is a polygon in the plane of its corners", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  drawing.DrawFace({CVector3(0.5, 0.0, 0.0), CVector3(1.5, 0.0, 0.0), CVector3(0.5, 0.0, 2.0)});
  const SDrawnShape& face = OnlyShape(drawing);
  CHECK(face.Kind == EKind::Polygon);
  CHECK(face.IsFace);
  CHECK(face.IsFilled);
  const std::vector<CVector3> corners = {CVector3(1.0, 2.5, 3.0), CVector3(1.0, 3.5, 3.0),
                                         CVector3(1.0, 2.5, 5.0)};
  REQUIRE(face.Count == corners.size());
  for (UInt32 i = 0; i < face.Count; ++i) {
    const CVector2& flat = drawing.GetCorners()[face.First + i];
    CVector3 corner(flat.GetX(), flat.GetY(), 0.0);
    CheckVector(corner.Rotate(face.Orientation) + face.Position, corners[i]);
  }
  // without an area, or over the picture, there is none
  drawing.DrawFace({CVector3(), CVector3::X, CVector3(2.0, 0.0, 0.0)});
  drawing.SetOverlay();
  drawing.DrawFace({CVector3(), CVector3::X, CVector3::Y});
  CHECK(drawing.GetShapes().size() == 1);
}

TEST_CASE("drawing: frames are moved in themselves, and can be kept", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  const CVector3 position = drawing.GetFramePosition();
  const CQuaternion orientation = drawing.GetFrameOrientation();
  drawing.MoveFrame(CVector3(1.0, 0.0, 0.0), kQuarterTurn);
  drawing.DrawPoint(CVector3(0.5, 0.0, 0.0));
  drawing.SetFrame(position, orientation);
  drawing.DrawPoint(CVector3());
  REQUIRE(drawing.GetShapes().size() == 2);
  CheckVector(drawing.GetShapes()[0].Position, CVector3(0.5, 3.0, 3.0));
  CheckVector(drawing.GetShapes()[1].Position, CVector3(1.0, 2.0, 3.0));
}

TEST_CASE("drawing: circles, cylinders and boxes keep their sizes", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  drawing.DrawCircle(CVector3(), CQuaternion(), 0.25, CColor::RED, true, 6);
  drawing.DrawCylinder(CVector3(0.0, 0.0, 1.0), CQuaternion(), 0.1, 0.4, CColor::WHITE);
  drawing.DrawBox(CVector3(1.0, 0.0, 0.0), CQuaternion(), CVector3(0.1, 0.2, 0.3), CColor::BROWN);
  REQUIRE(drawing.GetShapes().size() == 3);
  CHECK(drawing.GetShapes()[0].Kind == EKind::Circle);
  CHECK(drawing.GetShapes()[0].Size.GetX() == 0.25);
  CHECK(drawing.GetShapes()[0].Count == 6);
  CHECK(drawing.GetShapes()[1].Kind == EKind::Cylinder);
  CHECK(drawing.GetShapes()[1].Size == CVector3(0.2, 0.2, 0.4));
  CheckVector(drawing.GetShapes()[1].Position, CVector3(1.0, 2.0, 4.0));
  CHECK(drawing.GetShapes()[2].Kind == EKind::Box);
  CHECK(drawing.GetShapes()[2].Size == CVector3(0.1, 0.2, 0.3));
  CHECK(drawing.GetShapes()[2].Color == CColor::BROWN);
  CheckVector(drawing.GetShapes()[2].Position, CVector3(1.0, 3.0, 3.0));
}

TEST_CASE("drawing: texts keep their bytes and share styles", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  STextStyle bold;
  bold.IsBold = true;
  bold.Size = 20.0;
  drawing.DrawText(CVector3(), "fb0", CColor::BLACK);
  drawing.DrawText(CVector3(), "fb1", CColor::BLACK);
  drawing.DrawText(CVector3(), "na\xC3\xAFve\n2", CColor::RED, bold);
  REQUIRE(drawing.GetShapes().size() == 3);
  CHECK(drawing.GetText(drawing.GetShapes()[0]) == "fb0");
  CHECK(drawing.GetText(drawing.GetShapes()[1]) == "fb1");
  CHECK(drawing.GetText(drawing.GetShapes()[2]) == "na\xC3\xAFve\n2");
  CHECK(drawing.GetStyles().size() == 2);
  CHECK(drawing.GetShapes()[0].Style == 0);
  CHECK(drawing.GetShapes()[1].Style == 0);
  REQUIRE(drawing.GetShapes()[2].Style == 1);
  CHECK(drawing.GetStyles()[1] == bold);
  CHECK(drawing.GetShapes()[2].Pixels == 20.0);
}

TEST_CASE("drawing: over the picture, coordinates are pixels", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  CHECK(drawing.GetWidth() == 640);
  CHECK(drawing.GetHeight() == 480);
  drawing.SetOverlay();
  drawing.DrawLine(CVector3(10.0, 20.0, 0.0), CVector3(30.0, 20.0, 0.0));
  const SDrawnShape& shape = OnlyShape(drawing);
  CHECK(shape.Space == SDrawnShape::ESpace::Overlay);
  CHECK(shape.Position == CVector3(10.0, 20.0, 0.0));
  CHECK(shape.Size == CVector3(20.0, 0.0, 0.0));
}

TEST_CASE("drawing: a new picture starts empty, in the world frame", "[core][drawing]") {
  CDrawing drawing = MakeTurnedDrawing();
  drawing.DrawText(CVector3(), "x");
  drawing.DrawTriangle(CVector3(), CQuaternion(), 1.0, 1.0);
  drawing.SetOverlay();
  drawing.Begin(64, 48);
  CHECK(drawing.GetShapes().empty());
  CHECK(drawing.GetCorners().empty());
  CHECK(drawing.GetTexts().empty());
  drawing.DrawPoint(CVector3(0.1, 0.2, 0.3));
  CHECK(OnlyShape(drawing).Position == CVector3(0.1, 0.2, 0.3));
  CHECK(OnlyShape(drawing).Space == SDrawnShape::ESpace::World);
}

TEST_CASE("drawing: what is not finite is left out, with one warning", "[core][drawing]") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  const Real infinity = std::numeric_limits<Real>::infinity();
  CDrawing drawing = MakeTurnedDrawing();
  drawing.DrawCircle(CVector3(), CQuaternion(), nan);
  drawing.DrawLine(CVector3(), CVector3(infinity, 0.0, 0.0));
  drawing.DrawPolygon(CVector3(), CQuaternion(),
                      {CVector2(0.0, 0.0), CVector2(1.0, nan), CVector2(1.0, 1.0)});
  drawing.DrawText(CVector3(nan, 0.0, 0.0), "lost");
  drawing.DrawPoint(CVector3(0.0, 0.0, 0.0));
  CHECK(OnlyShape(drawing).Kind == EKind::Point);
  CHECK(drawing.GetCorners().empty());
  CHECK(drawing.GetTexts().empty());
  const std::string warning = TakeLogErr();
  CHECK_THAT(warning, Contains("[WARNING] A circle at (1,2,3)") && !Contains("line at"));
}

}  // namespace visualization_drawing_test
