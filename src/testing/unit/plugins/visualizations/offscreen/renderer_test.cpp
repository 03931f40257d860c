#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/plugins/simulator/visualizations/offscreen/gl_context.h>
#include <argos3/plugins/simulator/visualizations/offscreen/render_target.h>
#include <argos3/testing/support/pictures.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace renderer_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

std::shared_ptr<const std::vector<std::uint8_t>> MakePixels(std::vector<std::uint8_t> values) {
  return std::make_shared<const std::vector<std::uint8_t>>(std::move(values));
}

SCameraPlacement ParallelViewFromAbove(double height) {
  SCameraPlacement placement = ViewFromAbove(3.0);
  placement.OrthographicHeight = height;
  return placement;
}

// number of reddish pixels
int CountReddish(const SPicture& picture) {
  int count = 0;
  for (int y = 0; y < picture.Height; ++y) {
    for (int x = 0; x < picture.Width; ++x) {
      count += IsReddish(picture.At(x, y)) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

TEST_CASE("renderer: a red box is red where the camera projects it, and nowhere else",
          "[visualizations][offscreen][renderer]") {
  const std::string look = GENERATE("light", "dark");
  const Eigen::Vector3d base =
      GENERATE(Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(-0.8, 0.3, 0.0),
               Eigen::Vector3d(0.7, -0.4, 0.5));
  CAPTURE(look, base);
  SRenderSettings settings = SmallPicture();
  settings.Look = SLook::FromName(look);
  CRenderer renderer(settings);
  SScene scene = MakeEmptyScene();
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance(base, {0.4, 0.4, 0.4}, kRed));
  SPicture picture;
  renderer.Render(scene, ObliqueView(), picture);
  REQUIRE(picture.Width == 160);
  REQUIRE(picture.Height == 120);
  CHECK(IsReddish(PixelOf(picture, ObliqueView(), base + Eigen::Vector3d(0.0, 0.0, 0.2))));
  CHECK(IsReddish(PixelOf(picture, ObliqueView(), base + Eigen::Vector3d(0.15, -0.2, 0.1))));
  CHECK(IsReddish(PixelOf(picture, ObliqueView(), base + Eigen::Vector3d(-0.1, 0.1, 0.4))));
  CHECK(IsGreyish(PixelOf(picture, ObliqueView(), base + Eigen::Vector3d(0.35, -0.2, 0.1))));
  CHECK(IsGreyish(PixelOf(picture, ObliqueView(), base + Eigen::Vector3d(-0.35, -0.2, 0.3))));
  // the most distant corners of the picture
  CHECK(IsGreyish(picture.At(0, 0)));
  CHECK(IsGreyish(picture.At(159, 119)));
}

TEST_CASE("renderer: every kind of solid covers its centre",
          "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SPicture picture;
  const SCameraPlacement above = ViewFromAbove(2.0);
  SScene scene = MakeEmptyScene();
  const auto kind = GENERATE(EMeshKind::Box, EMeshKind::Cylinder, EMeshKind::Sphere);
  CAPTURE(static_cast<int>(kind));
  scene.OfKind(kind).push_back(MakeInstance({0.3, 0.2, 0.25}, {0.4, 0.4, 0.3}, kRed));
  renderer.Render(scene, above, picture);
  CHECK(IsReddish(PixelOf(picture, above, {0.3, 0.2, 0.4})));
  CHECK(IsGreyish(PixelOf(picture, above, {-0.3, -0.2, 0.0})));
  // 0.27 m along the diagonal: inside a square of side 0.4 m, outside a circle of that diameter
  const bool cornerIsCovered = IsReddish(PixelOf(picture, above, {0.49, 0.39, 0.4}));
  CHECK(cornerIsCovered == (kind == EMeshKind::Box));
}

TEST_CASE("renderer: a ring has a hole", "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SPicture picture;
  const SCameraPlacement above = ViewFromAbove(2.0);
  SScene scene = MakeEmptyScene();
  // outer radius 0.4 m, tube radius 0.1 m: the centre line is at 0.3 m
  SMeshInstance ring = MakeInstance({0.0, 0.0, 0.1}, {0.8, 0.8, 0.8}, kRed);
  ring.Param = 0.25f;
  scene.OfKind(EMeshKind::Ring).push_back(ring);
  renderer.Render(scene, above, picture);
  CHECK(IsReddish(PixelOf(picture, above, {0.3, 0.0, 0.2})));
  CHECK(IsReddish(PixelOf(picture, above, {-0.21, 0.21, 0.2})));
  CHECK(IsGreyish(PixelOf(picture, above, {0.0, 0.0, 0.0})));
}

TEST_CASE("renderer: the nearer of two solids occludes the other",
          "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SPicture picture;
  SScene scene = MakeEmptyScene();
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0.0, 0.5, 0.0}, {1.0, 0.2, 0.6}, kGreen));
  scene.OfKind(EMeshKind::Cylinder)
      .push_back(MakeInstance({0.0, -0.5, 0.0}, {0.3, 0.3, 0.6}, kRed));
  renderer.Render(scene, ObliqueView(), picture);
  CHECK(IsReddish(PixelOf(picture, ObliqueView(), {0.0, -0.65, 0.4})));
  CHECK(IsGreenish(PixelOf(picture, ObliqueView(), {0.4, 0.4, 0.4})));
}

TEST_CASE("renderer: a mirror-symmetric scene gives a mirror-symmetric picture",
          "[visualizations][offscreen][renderer]") {
  SRenderSettings settings = SmallPicture();
  // the sun is in the plane of symmetry
  settings.ToSun = Eigen::Vector3d(0.0, -0.4, 1.0);
  CRenderer renderer(settings);
  SScene scene = MakeEmptyScene();
  for (const double side : {-1.0, 1.0}) {
    scene.OfKind(EMeshKind::Box)
        .push_back(MakeInstance({0.6 * side, 0.1, 0.0}, {0.3, 0.5, 0.4}, kRed));
    scene.OfKind(EMeshKind::Sphere)
        .push_back(MakeInstance({0.25 * side, -0.6, 0.2}, {0.3, 0.3, 0.3}, kGreen));
    scene.Glows.push_back({{static_cast<float>(0.9 * side), -0.5f, 0.2f}, 0.05f, kRed, 4.0f});
    SLine line;
    line.Start = {static_cast<float>(0.1 * side), 0.5f, 0.3f};
    line.End = {static_cast<float>(0.9 * side), 0.9f, 0.1f};
    line.Color = kGreen;
    scene.Lines.push_back(line);
  }
  SPicture picture;
  renderer.Render(scene, ObliqueView(), picture);
  int different = 0;
  for (int y = 0; y < picture.Height; ++y) {
    for (int x = 0; x < picture.Width / 2; ++x) {
      const std::uint8_t* left = picture.At(x, y);
      const std::uint8_t* right = picture.At(picture.Width - 1 - x, y);
      for (int channel = 0; channel < 3; ++channel) {
        different += std::abs(left[channel] - right[channel]) > 24 ? 1 : 0;
      }
    }
  }
  // The sample positions in a pixel and the texels of the shadow map are not mirrored: channels of
  // border pixels may differ; the outlines of the solids have about 500 pixels.
  CHECK(different < picture.Width * picture.Height / 100);
}

TEST_CASE("renderer: the shadow of a solid is on the side away from the sun",
          "[visualizations][offscreen][renderer]") {
  SRenderSettings settings = SmallPicture();
  settings.ToSun = Eigen::Vector3d(-1.0, 0.0, 1.0);
  CRenderer renderer(settings);
  SScene scene = MakeEmptyScene();
  scene.ShowGrid = false;
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0.0, 0.0, 0.0}, {0.2, 0.2, 0.4}, kRed));
  const SCameraPlacement above = ViewFromAbove(3.0);
  SPicture picture;
  renderer.Render(scene, above, picture);
  // at 45 degrees the shadow of a box 0.4 m high ends 0.4 m behind it
  const int shade = Brightness(PixelOf(picture, above, {0.35, 0.0, 0.0}));
  const int lit = Brightness(PixelOf(picture, above, {-0.35, 0.0, 0.0}));
  const int beyond = Brightness(PixelOf(picture, above, {0.65, 0.0, 0.0}));
  CHECK(shade < lit - 100);
  CHECK(std::abs(beyond - lit) < 6);
}

TEST_CASE("renderer: flying solids cast shadows on the ground, also from outside the picture",
          "[visualizations][offscreen][renderer]") {
  SRenderSettings settings = SmallPicture();
  settings.ToSun = Eigen::Vector3d(-1.0, 0.0, 1.0);
  CRenderer renderer(settings);
  SScene scene = MakeEmptyScene();
  scene.ShowGrid = false;
  // the picture from 3 m above is 4.3 m wide: the second box is outside, at x = -3.2
  const double height = 1.5;
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({-1.0, 0.5, height}, {0.3, 0.3, 0.1}, kRed));
  scene.OfKind(EMeshKind::Box)
      .push_back(MakeInstance({-1.7 - height, -0.5, height}, {0.3, 0.3, 0.1}, kRed));
  const SCameraPlacement above = ViewFromAbove(3.0);
  SPicture picture;
  renderer.Render(scene, above, picture);
  // at 45 degrees a shadow is displaced by the height of its solid: 1.55 m for its middle
  const int lit = Brightness(PixelOf(picture, above, {1.2, 0.0, 0.0}));
  CHECK(Brightness(PixelOf(picture, above, {0.55, 0.5, 0.0})) < lit - 100);
  CHECK(Brightness(PixelOf(picture, above, {-1.65, -0.5, 0.0})) < lit - 100);
  // directly below them there is neither shadow nor reduced skylight
  CHECK(std::abs(Brightness(PixelOf(picture, above, {0.1, 0.5, 0.0})) - lit) < 6);
  CHECK(std::abs(Brightness(PixelOf(picture, above, {1.0, 0.5, 0.0})) - lit) < 6);
}

namespace {

SLine MakeWideLine(const std::array<float, 3>& start, const std::array<float, 3>& end) {
  SLine line;
  line.Start = start;
  line.End = end;
  line.Color = kGreen;
  line.Width = 4.0f;
  return line;
}

}  // namespace

TEST_CASE("renderer: lights and lines in the air are drawn, even close to the eye",
          "[visualizations][offscreen][renderer]") {
  // the nearest solid is the ground, 20 m below
  CRenderer renderer(SmallPicture());
  SScene scene = MakeEmptyScene();
  scene.Glows.push_back({{0.2f, 0.0f, 19.0f}, 0.1f, kRed, 0.0f});
  scene.Lines.push_back(MakeWideLine({-0.2f, -0.3f, 19.2f}, {-0.2f, 0.3f, 18.8f}));
  const SCameraPlacement above = ViewFromAbove(20.0);
  SPicture picture;
  renderer.Render(scene, above, picture);
  CHECK(IsReddish(PixelOf(picture, above, {0.2, 0.0, 19.0})));
  CHECK(IsGreenish(PixelOf(picture, above, {-0.2, 0.0, 19.0})));
}

TEST_CASE("renderer: row 0 of the floor image is at the lowest y",
          "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SScene scene = MakeEmptyScene();
  scene.ShowGrid = false;
  scene.Floor.Width = 2;
  scene.Floor.Height = 2;
  scene.Floor.Version = 1;
  // lower left red, lower right green, upper left black, upper right white
  scene.Floor.Pixels =
      MakePixels({220, 30, 30, 255, 30, 200, 30, 255, 0, 0, 0, 255, 255, 255, 255, 255});
  const SCameraPlacement above = ViewFromAbove(5.0);
  SPicture picture;
  renderer.Render(scene, above, picture);
  CHECK(IsReddish(PixelOf(picture, above, {-0.5, -0.5, 0.0})));
  CHECK(IsGreenish(PixelOf(picture, above, {0.5, -0.5, 0.0})));
  CHECK(Brightness(PixelOf(picture, above, {-0.5, 0.5, 0.0})) < 60);
  CHECK(Brightness(PixelOf(picture, above, {0.5, 0.5, 0.0})) > 700);
  // in full light the colours are those of the image, within the rounding of the two conversions
  const std::uint8_t* red = PixelOf(picture, above, {-0.5, -0.5, 0.0});
  CHECK(std::abs(red[0] - 220) <= 3);
  CHECK(std::abs(red[1] - 30) <= 3);

  // a floor image of a new version replaces the old one
  scene.Floor.Pixels = MakePixels(std::vector<std::uint8_t>(16, 255));
  ++scene.Floor.Version;
  renderer.Render(scene, above, picture);
  CHECK(IsGreyish(PixelOf(picture, above, {-0.5, -0.5, 0.0})));
}

TEST_CASE("renderer: lights, lines and translucent solids are drawn",
          "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SScene scene = MakeEmptyScene();
  scene.Glows.push_back({{0.5f, 0.0f, 0.1f}, 0.1f, kRed, 0.0f});
  scene.Lines.push_back(MakeWideLine({-0.5f, -0.6f, 0.1f}, {-0.5f, 0.6f, 0.1f}));
  SRgba glass = kRed;
  glass.A = 128;
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0.0, 0.6, 0.0}, {0.4, 0.4, 0.1}, glass));
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0.0, -0.6, 0.0}, {0.4, 0.4, 0.1}, kRed));
  const SCameraPlacement above = ViewFromAbove(2.0);
  SPicture picture;
  renderer.Render(scene, above, picture);
  CHECK(IsReddish(PixelOf(picture, above, {0.5, 0.0, 0.1})));
  CHECK(IsGreenish(PixelOf(picture, above, {-0.5, 0.3, 0.1})));
  const std::uint8_t* through = PixelOf(picture, above, {0.0, 0.6, 0.1});
  const std::uint8_t* solid = PixelOf(picture, above, {0.0, -0.6, 0.1});
  CHECK(through[0] > through[1] + 20);
  CHECK(through[1] > solid[1] + 40);
}

TEST_CASE("renderer: equal scenes give equal pictures bit by bit",
          "[visualizations][offscreen][renderer]") {
  SScene scene = MakeEmptyScene();
  scene.OfKind(EMeshKind::Cylinder).push_back(MakeInstance({0.2, 0.1, 0.0}, {0.5, 0.5, 0.5}, kRed));
  SPicture first;
  SPicture second;
  SPicture third;
  CRenderer renderer(SmallPicture());
  renderer.Render(scene, ObliqueView(), first);
  renderer.Render(MakeEmptyScene(), ObliqueView(), second);
  renderer.Render(scene, ObliqueView(), second);
  CRenderer other(SmallPicture());
  other.Render(scene, ObliqueView(), third);
  CHECK(first.Pixels == second.Pixels);
  CHECK(first.Pixels == third.Pixels);
}

TEST_CASE("renderer: more samples give more shades along an edge",
          "[visualizations][offscreen][renderer]") {
  const auto countShades = [](int samples) {
    SRenderSettings settings = SmallPicture();
    settings.Samples = samples;
    settings.Look.EdgeDarkening = 0.0f;
    CRenderer renderer(settings);
    SScene scene = MakeEmptyScene();
    scene.ShowGrid = false;
    scene.OfKind(EMeshKind::Cylinder)
        .push_back(MakeInstance({0.0, 0.0, 0.0}, {1.0, 1.0, 0.01}, SRgba{10, 10, 10, 255}));
    SPicture picture;
    renderer.Render(scene, ViewFromAbove(2.0), picture);
    std::array<bool, 256> seen{};
    for (std::size_t i = 0; i < picture.Pixels.size(); i += 4) {
      seen[picture.Pixels[i]] = true;
    }
    return std::count(seen.begin() + 40, seen.begin() + 200, true);
  };
  const auto none = countShades(1);
  const auto four = countShades(4);
  const auto sixteen = countShades(16);
  CHECK(none < four);
  CHECK(four < sixteen);
}

TEST_CASE("renderer: a picture beyond the driver's limits is an error that gives the limits",
          "[visualizations][offscreen][renderer]") {
  SRenderSettings settings = SmallPicture();
  settings.Width = 1000000;
  CHECK_THROWS_WITH(CRenderer(settings), Contains("1000000x120") && Contains("can draw"));
}

TEST_CASE("look: an unknown name is an error that lists the known ones",
          "[visualizations][offscreen][look]") {
  CHECK_THROWS_WITH(SLook::FromName("sepia"),
                    Contains("\"sepia\"") && Contains("\"light\" or \"dark\""));
}

TEST_CASE("renderer: in an orthographic view size does not depend on the height",
          "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SPicture picture;
  // 2 m are 120 pixels: half a metre is 30 pixels, whether at the ground or 1.5 m above it
  const double height = GENERATE(0.0, 1.5);
  CAPTURE(height);
  SScene scene = MakeEmptyScene();
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0.3, 0.2, height}, {0.5, 0.5, 0.1}, kRed));
  const SCameraPlacement above = ParallelViewFromAbove(2.0);
  renderer.Render(scene, above, picture);
  // the border is antialiased: half a pixel on each side
  CHECK(std::abs(CountReddish(picture) - 30 * 30) <= 2 * 30);
  CHECK(IsReddish(PixelOf(picture, above, {0.06, 0.2, 0.0})));
  CHECK(IsGreyish(PixelOf(picture, above, {0.03, 0.2, 0.0})));
  // no walls are seen
  CHECK(IsReddish(PixelOf(picture, above, {0.54, 0.44, 0.0})));
  CHECK(IsGreyish(PixelOf(picture, above, {0.57, 0.47, 0.0})));
}

TEST_CASE("renderer: a lit LED is seen from any distance, a dark one is not",
          "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SPicture picture;
  SGlow led;
  led.Position = {0.0f, 0.0f, 0.1f};
  led.Radius = 0.004f;
  led.Color = kRed;
  led.HaloScale = 3.6f;
  led.IsSignal = GENERATE(0.0f, 1.0f);
  CAPTURE(led.IsSignal);
  SScene scene = MakeEmptyScene();
  scene.Glows.push_back(led);
  // 8 mm from 60 m: a fortieth of a pixel
  const SCameraPlacement far = ViewFromAbove(60.0);
  renderer.Render(scene, far, picture);
  CHECK(IsReddish(PixelOf(picture, far, {0.0, 0.0, 0.1})) == (led.IsSignal > 0.0f));
}

TEST_CASE("renderer: robots too small to be seen are discs",
          "[visualizations][offscreen][renderer]") {
  CRenderer renderer(SmallPicture());
  SPicture with;
  SPicture without;
  SScene scene = MakeEmptyScene();
  const double height = GENERATE(1.0, 60.0);
  CAPTURE(height);
  const SCameraPlacement above = ViewFromAbove(height);
  renderer.Render(scene, above, without);
  scene.Markers.push_back({{0.0f, 0.0f, 0.05f}, 0.035f});
  renderer.Render(scene, above, with);
  // 7 cm are 19 pixels wide from 1 m, and a third of a pixel from 60 m
  CHECK((with.Pixels != without.Pixels) == (height > 10.0));
}

TEST_CASE(
    "renderer: discs of robots have 5 pixels of 960, less if they would cover much, and at least 2",
    "[visualizations][offscreen][renderer]") {
  struct SCase {
    int Width, Height;  // pixels
    std::size_t Count;  // of robots
    double Diameter;  // pixels
  };
  // 1707 discs of 3 pixels are a twentieth of the picture, in squares around them
  const SCase c = GENERATE(SCase{160, 120, 1, 2.0}, SCase{320, 960, 1, 5.0},
                           SCase{320, 960, 1707, 3.0}, SCase{320, 960, 100000, 2.0});
  CAPTURE(c.Width, c.Height, c.Count);
  SRenderSettings settings;
  settings.Width = c.Width;
  settings.Height = c.Height;
  CRenderer renderer(settings);
  SPicture without;
  SPicture with;
  SScene scene = MakeEmptyScene();
  const SCameraPlacement above = ViewFromAbove(60.0);
  renderer.Render(scene, above, without);
  // one is in the picture
  scene.Markers.assign(c.Count, {{1000.0f, 0.0f, 0.0f}, 0.001f});
  scene.Markers[0].Position[0] = 0.1f;
  renderer.Render(scene, above, with);
  double covered = 0.0;
  const double contrast = Brightness(PixelOf(without, above, {0.1, 0.0, 0.0})) -
                          settings.Look.Marker.R - settings.Look.Marker.G - settings.Look.Marker.B;
  for (int y = 0; y < c.Height; ++y) {
    for (int x = 0; x < c.Width; ++x) {
      covered += (Brightness(without.At(x, y)) - Brightness(with.At(x, y))) / contrast;
    }
  }
  CAPTURE(covered, contrast);
  // the edge is smooth
  CHECK(covered == Approx(0.25 * std::numbers::pi * c.Diameter * c.Diameter).epsilon(0.2));
}

TEST_CASE("renderer: the parts of the ground that are drawn without shadows have none",
          "[visualizations][offscreen][renderer]") {
  // a solid whose shadow is everywhere makes the renderer look up all shadows
  CRenderer renderer(SmallPicture());
  SPicture some;
  SPicture all;
  SScene scene = MakeEmptyScene();
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0.5, 0.2, 0.0}, {0.3, 0.3, 0.6}, kRed));
  renderer.Render(scene, ObliqueView(), some);
  // under the ground it is neither seen nor throws a shadow on it
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0.0, 0.0, -0.2}, {12.0, 12.0, 0.1}, kGreen));
  renderer.Render(scene, ObliqueView(), all);
  // far from the solid, where the shadow map's resolution, which differs, does not matter
  for (const auto& [x, y] : {std::pair{10, 110}, {150, 110}, {20, 60}, {80, 112}}) {
    CAPTURE(x, y);
    CHECK(std::abs(Brightness(some.At(x, y)) - Brightness(all.At(x, y))) <= 3);
  }
}

TEST_CASE("render target: a side may have as many pixels as the driver can draw",
          "[visualizations][offscreen][renderer]") {
  const std::unique_ptr<CGlContext> context = CGlContext::Create();
  SGlFunctions gl = context->GetFunctions();
  gl.GetIntegerv = [](GLenum name, GLint* value) { *value = name == GL_MAX_SAMPLES ? 1 : 64; };
  CHECK(CRenderTarget(gl, 64, 48, 1).GetDrawnWidth() == 64);
  CHECK(CRenderTarget(gl, 48, 64, 1).GetDrawnHeight() == 64);
  CHECK_THROWS_WITH(CRenderTarget(gl, 65, 48, 1),
                    Contains("65x48 pixels is larger than the 64 pixels"));
  CHECK_THROWS_WITH(CRenderTarget(gl, 48, 65, 1), Contains("48x65 pixels is larger"));
  // without enough samples, it is drawn at twice its size
  CHECK(CRenderTarget(gl, 32, 24, 4).GetDrawnWidth() == 64);
  CHECK_THROWS_WITH(CRenderTarget(gl, 33, 24, 4),
                    Contains("33x24 pixels is larger than the 32 pixels"));
}

}  // namespace renderer_test
