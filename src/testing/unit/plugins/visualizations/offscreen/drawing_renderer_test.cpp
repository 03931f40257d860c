// From what users' code draws to the pixels of a picture.
#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>
#include <argos3/plugins/simulator/visualizations/scene/drawing_to_scene.h>
#include <argos3/plugins/simulator/visualizations/offscreen/gl_program.h>
#include <argos3/testing/support/pictures.h>

#include <catch2/catch.hpp>

#include <functional>
#include <numbers>

namespace drawing_renderer_test {

using namespace argos;
using Catch::WithinRel;

namespace {

const CColor kPen(220, 30, 30);
constexpr double kHeight = 2.0;  // of the camera, m

// the picture of a drawing from above
SPicture Draw(const std::function<void(CDrawing&)>& draw,
              const SRenderSettings& settings = SmallPicture()) {
  CDrawing drawing;
  drawing.Begin(static_cast<UInt32>(settings.Width), static_cast<UInt32>(settings.Height));
  draw(drawing);
  SScene scene = MakeEmptyScene();
  scene.ShowGrid = false;
  scene.ShowBoundary = false;
  AddDrawing(drawing, scene);
  CRenderer renderer(settings);
  SPicture picture;
  renderer.Render(scene, ViewFromAbove(kHeight), picture);
  return picture;
}

bool IsRedAt(const SPicture& picture, double x, double y, double z = 0.0) {
  return IsReddish(PixelOf(picture, ViewFromAbove(kHeight), {x, y, z}));
}

int CountRed(const SPicture& picture) {
  int count = 0;
  for (int y = 0; y < picture.Height; ++y) {
    for (int x = 0; x < picture.Width; ++x) {
      count += IsReddish(picture.At(x, y)) ? 1 : 0;
    }
  }
  return count;
}

// how many pixels the pen covers, in part or in whole, on ground of one colour
double MeasureCovered(const SPicture& picture) {
  const float ground = ToLinearLight(picture.At(0, 0)[1]);
  const float pen = ToLinearLight(kPen.GetGreen());
  double covered = 0.0;
  for (int y = 0; y < picture.Height; ++y) {
    for (int x = 0; x < picture.Width; ++x) {
      covered += (ground - ToLinearLight(picture.At(x, y)[1])) / (ground - pen);
    }
  }
  return covered;
}

// pixels per metre on the ground: the picture is 27 mm high at a distance of 25 mm
double PixelsPerMeter(const SPicture& picture) {
  return picture.Height / (27.0 / 25.0 * kHeight);
}

}  // namespace

TEST_CASE("drawn box: covers the pixels of its place", "[visualizations][offscreen][drawing]") {
  const SPicture picture = Draw([](CDrawing& drawing) {
    drawing.DrawBox(CVector3(0.3, 0.2, 0.1), CQuaternion(), CVector3(0.4, 0.2, 0.2), kPen);
  });
  for (const double x : {0.12, 0.3, 0.48}) {
    for (const double y : {0.12, 0.28}) {
      CHECK(IsRedAt(picture, x, y, 0.2));
    }
  }
  CHECK_FALSE(IsRedAt(picture, 0.3, 0.34, 0.2));
  CHECK_FALSE(IsRedAt(picture, 0.56, 0.2, 0.2));
}

TEST_CASE("drawn cylinder: is centred and round", "[visualizations][offscreen][drawing]") {
  const SPicture picture = Draw([](CDrawing& drawing) {
    drawing.DrawCylinder(CVector3(-0.3, 0.0, 0.1), CQuaternion(), 0.2, 0.2, kPen);
  });
  CHECK(IsRedAt(picture, -0.3, 0.0, 0.2));
  CHECK(IsRedAt(picture, -0.3, 0.18, 0.2));
  // 0.24 m along the diagonal
  CHECK_FALSE(IsRedAt(picture, -0.13, 0.17, 0.2));
}

TEST_CASE("drawn circle: has the area of a disc", "[visualizations][offscreen][drawing]") {
  const SPicture picture = Draw([](CDrawing& drawing) {
    drawing.DrawCircle(CVector3(0.1, 0.1, 0.0), CQuaternion(), 0.4, kPen);
  });
  const double scale = PixelsPerMeter(picture);
  // 2 %: four samples a pixel along the circumference of 140 pixels
  CHECK_THAT(MeasureCovered(picture), WithinRel(std::numbers::pi * 0.16 * scale * scale, 0.02));
  CHECK(IsRedAt(picture, 0.1, 0.1));
}

TEST_CASE("drawn circle: an outline leaves its inside free, few corners give a polygon",
          "[visualizations][offscreen][drawing]") {
  const SPicture outline = Draw([](CDrawing& drawing) {
    drawing.DrawCircle(CVector3(0.0, 0.0, 0.0), CQuaternion(), 0.4, kPen, false);
  });
  CHECK_FALSE(IsRedAt(outline, 0.0, 0.0));
  const double scale = PixelsPerMeter(outline);
  // 1.5 pixels wide; 5 %: the joints of its parts
  CHECK_THAT(MeasureCovered(outline), WithinRel(1.5 * 2.0 * std::numbers::pi * 0.4 * scale, 0.05));
  const SPicture square = Draw([](CDrawing& drawing) {
    drawing.DrawCircle(CVector3(0.0, 0.0, 0.0), CQuaternion(), 0.4, kPen, true, 4);
  });
  // a square of that diagonal; 2 %: as above
  CHECK_THAT(MeasureCovered(square), WithinRel(0.32 * scale * scale, 0.02));
}

TEST_CASE("drawn triangle and polygon: fill their area, also if not convex, and keep their colour",
          "[visualizations][offscreen][drawing]") {
  const SPicture triangle = Draw([](CDrawing& drawing) {
    drawing.DrawTriangle(CVector3(0.0, 0.0, 0.0), CQuaternion(), 0.4, 0.8, kPen);
  });
  CHECK(IsRedAt(triangle, 0.25, 0.0));
  CHECK(IsRedAt(triangle, -0.35, 0.15));
  CHECK_FALSE(IsRedAt(triangle, 0.35, 0.1));
  // no light changes it; 3: rounding of two conversions of the colour
  const std::uint8_t* pixel = PixelOf(triangle, ViewFromAbove(kHeight), {0.0, 0.0, 0.0});
  CHECK(std::abs(pixel[0] - 220) <= 3);
  CHECK(std::abs(pixel[1] - 30) <= 3);

  const SPicture arrow = Draw([](CDrawing& drawing) {
    drawing.DrawPolygon(
        CVector3(0.0, 0.0, 0.3), CQuaternion(),
        {CVector2(0.0, 0.0), CVector2(-0.3, 0.4), CVector2(0.5, 0.0), CVector2(-0.3, -0.4)}, kPen);
  });
  CHECK(IsRedAt(arrow, 0.4, 0.0, 0.3));
  CHECK(IsRedAt(arrow, -0.15, 0.27, 0.3));
  CHECK_FALSE(IsRedAt(arrow, -0.15, 0.0, 0.3));
}

TEST_CASE("drawn areas: in one plane the later one covers, a higher one covers a lower one",
          "[visualizations][offscreen][drawing]") {
  const SPicture same = Draw([](CDrawing& drawing) {
    drawing.DrawCircle(CVector3(0.0, 0.0, 0.01), CQuaternion(), 0.4, CColor::BLUE);
    drawing.DrawCircle(CVector3(0.0, 0.0, 0.01), CQuaternion(), 0.4, kPen);
  });
  CHECK(IsRedAt(same, 0.1, 0.2));
  const SPicture higher = Draw([](CDrawing& drawing) {
    drawing.DrawCircle(CVector3(0.0, 0.0, 0.1), CQuaternion(), 0.4, kPen);
    drawing.DrawCircle(CVector3(0.0, 0.0, 0.01), CQuaternion(), 0.4, CColor::BLUE);
  });
  CHECK(IsRedAt(higher, 0.1, 0.2));
}

TEST_CASE("drawn areas: translucent ones let the ground through",
          "[visualizations][offscreen][drawing]") {
  const SPicture picture = Draw([](CDrawing& drawing) {
    drawing.DrawCircle(CVector3(), CQuaternion(), 0.3, CColor(220, 30, 30, 128));
  });
  const std::uint8_t* pixel = PixelOf(picture, ViewFromAbove(kHeight), {0.0, 0.0, 0.0});
  CHECK(pixel[0] > pixel[1] + 30);
  CHECK(pixel[1] > 100);
}

TEST_CASE("drawn line: is as wide as asked for, on the ground, too",
          "[visualizations][offscreen][drawing]") {
  const Real width = GENERATE(2.0, 6.0);
  CAPTURE(width);
  const SPicture picture = Draw([width](CDrawing& drawing) {
    drawing.DrawLine(CVector3(-0.5, 0.0, 0.0), CVector3(0.5, 0.0, 0.0), kPen, width);
  });
  const double length = PixelsPerMeter(picture);
  // 5 %: its ends, and the borders' smoothing
  CHECK_THAT(MeasureCovered(picture), WithinRel(width * length, 0.05));
  CHECK(IsRedAt(picture, 0.4, 0.0));
}

TEST_CASE("drawn point: has its diameter in pixels at any distance",
          "[visualizations][offscreen][drawing]") {
  const Real z = GENERATE(0.0, 1.0);
  CAPTURE(z);
  const SPicture picture =
      Draw([z](CDrawing& drawing) { drawing.DrawPoint(CVector3(0.1, 0.0, z), kPen, 20.0); });
  CHECK(IsRedAt(picture, 0.1, 0.0, z));
  // 2 %: the smoothing of its border
  CHECK_THAT(MeasureCovered(picture), WithinRel(std::numbers::pi * 100.0, 0.02));
}

TEST_CASE("drawn text: leaves readable pixels at its place, before all solids",
          "[visualizations][offscreen][drawing]") {
  const SPicture picture = Draw([](CDrawing& drawing) {
    STextStyle style;
    style.Size = 24.0;
    drawing.DrawText(CVector3(0.0, 0.0, 0.0), "HHH", kPen, style);
    drawing.DrawBox(CVector3(0.0, 0.0, 0.5), CQuaternion(), CVector3(0.3, 0.3, 0.3), CColor::BLUE);
  });
  // the text begins in the middle: letters are to its upper right
  int upperRight = 0;
  int elsewhere = 0;
  for (int y = 0; y < picture.Height; ++y) {
    for (int x = 0; x < picture.Width; ++x) {
      if (IsReddish(picture.At(x, y))) {
        (x >= picture.Width / 2 && y < picture.Height / 2 + 1 ? upperRight : elsewhere) += 1;
      }
    }
  }
  // of each letter two stems, 2 pixels wide and 17 high, and a bar; pixels of borders may be pale
  CHECK(upperRight > 120);
  CHECK(upperRight < 600);
  CHECK(elsewhere == 0);
}

TEST_CASE("drawn text: stands in the same place with emulated samples",
          "[visualizations][offscreen][drawing]") {
  const auto draw = [](CDrawing& drawing) {
    drawing.SetOverlay();
    drawing.DrawText(CVector3(20.0, 60.0, 0.0), "HHH", kPen);
  };
  SRenderSettings fine = SmallPicture();
  fine.Samples = 16;
  const SPicture plain = Draw(draw);
  const SPicture emulated = Draw(draw, fine);
  const int count = CountRed(plain);
  CHECK(count > 30);
  // other pixels of the borders are red
  CHECK(std::abs(CountRed(emulated) - count) < count / 2);
}

TEST_CASE("drawing over the picture: coordinates are pixels from the upper left corner",
          "[visualizations][offscreen][drawing]") {
  const SPicture picture = Draw([](CDrawing& drawing) {
    drawing.SetOverlay();
    drawing.DrawPolygon(
        CVector3(10.0, 20.0, 0.0), CQuaternion(),
        {CVector2(0.0, 0.0), CVector2(30.0, 0.0), CVector2(30.0, 10.0), CVector2(0.0, 10.0)}, kPen);
    drawing.DrawLine(CVector3(100.0, 50.0, 0.0), CVector3(100.0, 90.0, 0.0), kPen, 4.0);
  });
  CHECK(IsReddish(picture.At(10, 20)));
  CHECK(IsReddish(picture.At(39, 29)));
  CHECK_FALSE(IsReddish(picture.At(9, 20)));
  CHECK_FALSE(IsReddish(picture.At(40, 29)));
  CHECK_FALSE(IsReddish(picture.At(39, 30)));
  CHECK(IsReddish(picture.At(98, 60)));
  CHECK(IsReddish(picture.At(101, 60)));
  CHECK_FALSE(IsReddish(picture.At(103, 60)));
}

TEST_CASE("drawing over the picture: solids are their outlines from above, sizes are pixels",
          "[visualizations][offscreen][drawing]") {
  struct SCase {
    std::function<void(CDrawing&)> Draw;
    double Area;  // square pixels
  };
  const CVector3 middle(80.0, 60.0, 0.0);
  const CQuaternion turned(CRadians(0.5), CVector3::Z);
  const SCase c = GENERATE_COPY(
      SCase{[=](CDrawing& drawing) { drawing.DrawBox(middle, turned, CVector3(60, 40, 5), kPen); },
            2400.0},
      SCase{[=](CDrawing& drawing) { drawing.DrawCylinder(middle, turned, 30.0, 5.0, kPen); },
            900.0 * std::numbers::pi},
      SCase{[=](CDrawing& drawing) { drawing.DrawCircle(middle, turned, 30.0, kPen); },
            900.0 * std::numbers::pi},
      SCase{[=](CDrawing& drawing) { drawing.DrawCircle(middle, turned, 30.0, kPen, true, 4); },
            1800.0},
      SCase{[=](CDrawing& drawing) { drawing.DrawPoint(middle, kPen, 30.0); },
            225.0 * std::numbers::pi});
  const SPicture picture = Draw([&c](CDrawing& drawing) {
    drawing.SetOverlay();
    c.Draw(drawing);
  });
  // 2 %: four samples a pixel along the circumference
  CHECK_THAT(MeasureCovered(picture), WithinRel(c.Area, 0.02));
  CHECK(IsReddish(picture.At(80, 60)));
}

TEST_CASE("drawing: equal drawings give equal pictures, and an empty one changes nothing",
          "[visualizations][offscreen][drawing]") {
  const auto draw = [](CDrawing& drawing) {
    drawing.DrawText(CVector3(), "fb0");
    drawing.DrawCircle(CVector3(), CQuaternion(), 0.3, CColor(10, 20, 30, 100));
    drawing.DrawLine(CVector3(), CVector3(1.0, 1.0, 1.0));
  };
  CHECK(Draw(draw).Pixels == Draw(draw).Pixels);
  SScene scene = MakeEmptyScene();
  SPicture without;
  SPicture with;
  CRenderer(SmallPicture()).Render(scene, ObliqueView(), without);
  CDrawing drawing;
  drawing.Begin(160, 120);
  AddDrawing(drawing, scene);
  CRenderer(SmallPicture()).Render(scene, ObliqueView(), with);
  CHECK(with.Pixels == without.Pixels);
}

TEST_CASE("drawing renderer: each shape is before those drawn earlier, up to a limit",
          "[visualizations][offscreen][drawing]") {
  CDrawing drawing;
  drawing.Begin(64, 64);
  constexpr std::size_t kShapes = 1500;
  for (std::size_t i = 0; i < kShapes; ++i) {
    drawing.DrawTriangle(CVector3(), CQuaternion(), 0.1, 0.1, CColor::RED);
  }
  SScene scene;
  AddDrawing(drawing, scene);
  REQUIRE(scene.Flats.size() == 3 * kShapes);
  // 2e-6 more for each, from 5e-4 to 2.5e-3 of the distance
  CHECK(scene.Flats.front().Nearer == Approx(5.02e-4));
  CHECK(scene.Flats[3 * 499].Nearer == Approx(1.5e-3));
  CHECK(scene.Flats[3 * 998].Nearer == Approx(2.498e-3));
  CHECK(scene.Flats.back().Nearer == Approx(2.5e-3));
}

TEST_CASE("painter: colours of Qt beyond 0 to 255 are those at the ends",
          "[visualizations][offscreen][drawing]") {
  CDrawing drawing;
  drawing.Begin(64, 64);
  drawing.SetOverlay();
  QPainter painter(drawing);
  painter.setPen(QColor(300, -5, 256, 255));
  painter.drawLine(0, 0, 10, 10);
  painter.setPen(QColor(255, 0, 1, -1));
  painter.drawLine(0, 0, 10, 10);
  REQUIRE(drawing.GetShapes().size() == 2);
  CHECK(drawing.GetShapes()[0].Color == CColor(255, 0, 255, 255));
  CHECK(drawing.GetShapes()[1].Color == CColor(255, 0, 1, 0));
}

TEST_CASE("painter: the corners of a rectangle are a place and that place plus the size",
          "[visualizations][offscreen][drawing]") {
  CDrawing drawing;
  drawing.Begin(64, 64);
  drawing.SetOverlay();
  QPainter painter(drawing);
  painter.drawRect(3, 4, 20, 10);
  painter.fillRect(3, 4, 20, 10, QColor(1, 2, 3));
  REQUIRE(drawing.GetShapes().size() == 2);
  for (const SDrawnShape& shape : drawing.GetShapes()) {
    CHECK(shape.Position == CVector3(3.0, 4.0, 0.0));
    REQUIRE(shape.Count == 4);
    const CVector2 expected[] = {CVector2(0.0, 0.0), CVector2(20.0, 0.0), CVector2(20.0, 10.0),
                                 CVector2(0.0, 10.0)};
    for (UInt32 i = 0; i < 4; ++i) {
      CHECK(drawing.GetCorners()[shape.First + i] == expected[i]);
    }
  }
  CHECK_FALSE(drawing.GetShapes()[0].IsFilled);
  CHECK(drawing.GetShapes()[1].IsFilled);
  CHECK(drawing.GetShapes()[1].Color == CColor(1, 2, 3));
}

}  // namespace drawing_renderer_test
