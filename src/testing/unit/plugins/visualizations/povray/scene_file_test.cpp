#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>

#include <argos3/core/simulator/visualization/povray_model.h>
#include <argos3/support/child_process.h>
#include <argos3/plugins/simulator/visualizations/povray/povray_renderer.h>
#include <argos3/testing/support/golden_text.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/pictures.h>
#include <argos3/testing/support/temporary_folder.h>

#include <FreeImage.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace scene_file_test {

using namespace argos;

namespace {

constexpr SRgba kBlue = {40, 40, 225, 255};

bool HasPovray() {
  return !FindProgram(GetPovrayProgram()).empty();
}

SPovraySettings Small(int width = 160, int height = 120) {
  SPovraySettings settings;
  settings.Width = width;
  settings.Height = height;
  settings.Quality = EPovrayQuality::Draft;
  return settings;
}

SPicture Load(const std::string& path) {
  const std::unique_ptr<FIBITMAP, decltype(&FreeImage_Unload)> bitmap(
      FreeImage_Load(FIF_PNG, path.c_str(), 0), &FreeImage_Unload);
  REQUIRE(bitmap != nullptr);
  SPicture picture;
  picture.Width = static_cast<int>(FreeImage_GetWidth(bitmap.get()));
  picture.Height = static_cast<int>(FreeImage_GetHeight(bitmap.get()));
  for (int row = 0; row < picture.Height; ++row) {
    for (int column = 0; column < picture.Width; ++column) {
      RGBQUAD color;
      REQUIRE(FreeImage_GetPixelColor(bitmap.get(), static_cast<unsigned>(column),
                                      static_cast<unsigned>(picture.Height - 1 - row), &color));
      picture.Pixels.insert(picture.Pixels.end(),
                            {color.rgbRed, color.rgbGreen, color.rgbBlue, 255});
    }
  }
  return picture;
}

// throws if POV-Ray does not accept the scene
SPicture RenderWithPovray(const SScene& scene, const SCameraPlacement& placement,
                          const SPovraySettings& settings, const SSceneExtras& extras = {}) {
  const CTemporaryFolder folder;
  std::size_t numSkipped = 0;
  std::string problem;
  REQUIRE(ReplaceFile(folder.Path("scene.pov"),
                      MakeSceneFile(scene, placement, settings, extras, numSkipped), problem));
  SPovrayJob job;
  job.Width = settings.Width;
  job.Height = settings.Height;
  job.Quality = EPovrayQuality::Draft;
  job.Directory = folder.GetPath();
  CPovrayRenderer renderer(job);
  renderer.Submit("scene.pov");
  renderer.Finish();
  return Load(folder.Path("scene.png"));
}

// the pixels of one colour: how many, their middle and their bounds
struct SSilhouette {
  int Count = 0;
  Eigen::Vector2d Center = Eigen::Vector2d::Zero();
  Eigen::Array2i Least = Eigen::Array2i::Constant(100000);
  Eigen::Array2i Most = Eigen::Array2i::Constant(-1);
};

SSilhouette FindSilhouette(const SPicture& picture, std::size_t channel) {
  SSilhouette found;
  for (int row = 0; row < picture.Height; ++row) {
    for (int column = 0; column < picture.Width; ++column) {
      const std::uint8_t* const pixel = picture.At(column, row);
      const int other = std::max(pixel[(channel + 1) % 3], pixel[(channel + 2) % 3]);
      if (pixel[channel] > 60 && 10 * pixel[channel] > 17 * other) {
        ++found.Count;
        found.Center += Eigen::Vector2d(column, row);
        found.Least = found.Least.min(Eigen::Array2i(column, row));
        found.Most = found.Most.max(Eigen::Array2i(column, row));
      }
    }
  }
  found.Center /= std::max(found.Count, 1);
  return found;
}

// no two of them alike: a mirrored or turned picture would show
SScene MakeColoredScene() {
  SScene scene = MakeEmptyScene();
  scene.ShowGrid = false;
  scene.OfKind(EMeshKind::Box).push_back(MakeInstance({-0.6, 0.3, 0.0}, {0.3, 0.6, 0.4}, kRed));
  scene.OfKind(EMeshKind::Sphere).push_back(MakeInstance({0.6, 0.4, 0.3}, {0.5, 0.5, 0.5}, kGreen));
  scene.OfKind(EMeshKind::Cylinder)
      .push_back(MakeInstance({0.3, -0.5, 0.1}, {0.3, 0.3, 0.5}, kBlue));
  for (std::vector<SMeshInstance>& solids : scene.Meshes) {
    for (SMeshInstance& solid : solids) {
      solid.Material = EMaterial::Matte;
    }
  }
  return scene;
}

std::array<SCameraPlacement, 3> MakeViews() {
  SCameraPlacement tilted;
  tilted.Position = Eigen::Vector3d(2.2, 1.5, 1.4);
  tilted.LookAt = Eigen::Vector3d(0.1, 0.0, 0.1);
  tilted.Up = Eigen::Vector3d(0.5, 0.2, 1.0);
  tilted.FocalLength = 22.0;
  SCameraPlacement parallel = ObliqueView();
  parallel.OrthographicHeight = 2.4;
  return {ObliqueView(), tilted, parallel};
}

// every kind of thing that a scene can hold
SScene MakeFullScene() {
  SScene scene = MakeColoredScene();
  scene.ShowGrid = true;
  scene.OfKind(EMeshKind::Ring).push_back(MakeInstance({0.0, 0.0, 0.4}, {0.5, 0.5, 0.5}, kRed));
  scene.OfKind(EMeshKind::Ring).back().Param = 0.1f;
  for (std::size_t i = 0; i < static_cast<std::size_t>(EMaterial::Count); ++i) {
    for (std::size_t kind = 0; kind < kNumMeshKinds; ++kind) {
      SMeshInstance solid = MakeInstance(
          {-1.5 + 0.3 * static_cast<double>(i), 1.0 + 0.2 * static_cast<double>(kind), 0.2},
          {0.15, 0.1, 0.12}, kGreen);
      solid.Material = static_cast<EMaterial>(i);
      solid.Param = kind == static_cast<std::size_t>(EMeshKind::Cylinder) ? 0.0f : 0.3f;
      solid.Color.A = i % 2 == 0 ? 255 : 100;
      scene.Meshes[kind].push_back(solid);
    }
  }
  SGlow led{{0.0f, -0.5f, 0.1f}, 0.01f, kRed, 3.6f, 0.0f, 1.0f};
  SGlow lamp{{0.5f, -0.5f, 0.6f}, 0.03f, kGreen, 4.5f};
  lamp.IsLamp = true;
  const SGlow off{{0.1f, -0.5f, 0.1f}, 0.01f, {46, 48, 54, 255}};
  const SGlow point{{0.2f, -0.5f, 0.1f}, 0.0f, kBlue, 0.0f, 5.0f};
  // at the rim of the nearer of two robots
  const SGlow rim{{1.0f, -0.5f, 0.1f}, 0.01f, kGreen, 3.6f, 0.0f, 1.0f};
  scene.Glows = {led, lamp, off, point, rim};
  scene.Markers.push_back({{0.0f, -0.5f, 0.1f}, 0.001f});
  scene.Markers.push_back({{0.9f, -0.5f, 0.1f}, 0.1f});
  scene.Markers.push_back({{0.95f, -0.45f, 0.1f}, 0.1f});
  scene.Lines.push_back({{0.0f, 0.0f, 0.5f}, {1.0f, 0.0f, 0.5f}, {200, 0, 0, 120}, 2.0f});
  scene.Lines.push_back({{0.0f, 0.0f, 0.5f}, {0.0f, 0.0f, 0.5f}, kRed, 2.0f});  // no length
  for (const std::array<float, 3>& corner :
       {std::array<float, 3>{0.0f, 0.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}}) {
    scene.Flats.push_back({corner, kRed, 1e-3f});
    scene.TranslucentFlats.push_back({corner, {0, 0, 200, 90}, 1e-3f});
    scene.OverlayFlats.push_back(
        {{40.0f * corner[0] + 3.0f, 40.0f * corner[1] + 3.0f, 0.0f}, kGreen, 0.0f});
  }
  STextStyle style;
  style.Family = "monospace";
  style.Alignment = STextStyle::EAlignment::Center;
  scene.Labels.push_back({{0.0f, 0.0f, 0.3f}, kRed, "id\"}\\ #declare\n\n  \n\xC3\xA4", style});
  style.Family = "Times";
  style.Alignment = STextStyle::EAlignment::Right;
  scene.OverlayLabels.push_back({{5.0f, 20.0f, 0.0f}, {0, 0, 0, 255}, "\\", style});
  scene.OverlayLabels.push_back({{5.0f, 20.0f, 0.0f}, {0, 0, 0, 255}, "", {}});
  return scene;
}

// Each number with 5 digits: libraries may differ in the last ones of a cosine.
std::string RoundNumbers(const std::string& line) {
  std::string rounded;
  for (const char* at = line.c_str(); *at != '\0';) {
    char* end = nullptr;
    const double number = std::strtod(at, &end);
    if (end == at || std::isalpha(static_cast<unsigned char>(*at)) != 0) {
      rounded += *at++;
      continue;
    }
    rounded += fmt::format("{:.5g}", std::abs(number) < 1e-12 ? 0.0 : number);
    at = end;
  }
  return rounded;
}

}  // namespace

TEST_CASE("povray scene: silhouettes are those of the off-screen view", "[povray]") {
  if (!HasPovray()) {
    WARN("POV-Ray is not installed: not tested");
    return;
  }
  const SScene scene = MakeColoredScene();
  const std::array<SCameraPlacement, 3> views = MakeViews();
  for (std::size_t view = 0; view < views.size(); ++view) {
    SPicture offscreen;
    CRenderer(SmallPicture()).Render(scene, views[view], offscreen);
    const SPicture traced = RenderWithPovray(scene, views[view], Small());
    for (std::size_t channel = 0; channel < 3; ++channel) {
      CAPTURE(view, channel);
      const SSilhouette expected = FindSilhouette(offscreen, channel);
      const SSilhouette found = FindSilhouette(traced, channel);
      REQUIRE(expected.Count > 100);
      // pixels at the edge are blends of two colours: about one around the silhouette
      CHECK((found.Center - expected.Center).norm() < 1.5);
      CHECK((found.Least - expected.Least).abs().maxCoeff() <= 2);
      CHECK((found.Most - expected.Most).abs().maxCoeff() <= 2);
      CHECK(std::abs(found.Count - expected.Count) < 0.15 * expected.Count);
    }
  }
}

TEST_CASE("povray scene: POV-Ray accepts everything that a scene can hold", "[povray]") {
  if (!HasPovray()) {
    WARN("POV-Ray is not installed: not tested");
    return;
  }
  const EPovrayQuality quality =
      GENERATE(EPovrayQuality::Draft, EPovrayQuality::Good, EPovrayQuality::Best);
  SPovraySettings settings = Small(32, 24);
  settings.Quality = quality;
  settings.IsDark = quality == EPovrayQuality::Best;
  CHECK_NOTHROW(RenderWithPovray(MakeFullScene(), ObliqueView(), settings));
}

// After an intended change, ARGOS_RENEW_GOLDEN=1 unit_povray_tests replaces the texts; render them
// before they are committed.
TEST_CASE("povray scene: the texts of both looks are those in golden/", "[povray]") {
  struct SCase {
    const char* Name;
    const char* Look;
    EPovrayQuality Quality;
  };
  const SCase c = GENERATE(SCase{"light_draft", "light", EPovrayQuality::Draft},
                           SCase{"light_best", "light", EPovrayQuality::Best},
                           SCase{"dark_good", "dark", EPovrayQuality::Good});
  SPovraySettings settings = Small();
  settings.Quality = c.Quality;
  settings.Look = SLook::FromName(c.Look);
  settings.IsDark = std::string(c.Look) == "dark";
  SScene scene = MakeFullScene();
  std::size_t numSkipped = 0;
  const std::string text =
      MakeSceneFile(scene, ObliqueView(), settings, {{}, "floor.ppm"}, numSkipped);
  CheckGoldenText(InSourceTree("src/testing/unit/plugins/visualizations/povray/golden/" +
                               std::string(c.Name) + ".pov"),
                  text, RoundNumbers);
}

TEST_CASE("povray scene: a model appears at its place", "[povray]") {
  if (!HasPovray()) {
    WARN("POV-Ray is not installed: not tested");
    return;
  }
  SScene scene = MakeEmptyScene();
  scene.ShowGrid = false;
  SMeshInstance place = MakeInstance({0.5, 0.0, 0.0}, {1.0, 1.0, 1.0}, kRed);
  scene.Models.push_back({1, place.ToWorld});
  const std::vector<std::string> models = {"not used, and not valid",
                                           "sphere { 0, 0.3 Argos_Matte(srgb <0.86, 0.1, 0.1>) }"};
  SSceneExtras extras;
  extras.Models = models;
  const SPicture picture = RenderWithPovray(scene, ViewFromAbove(3.0), Small(), extras);
  CHECK(IsReddish(PixelOf(picture, ViewFromAbove(3.0), {0.5, 0.0, 0.3})));
  CHECK_FALSE(IsReddish(PixelOf(picture, ViewFromAbove(3.0), {-0.5, 0.0, 0.0})));
}

TEST_CASE("povray scene: numbers that are not finite are left out and counted", "[povray]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  SScene scene = MakeColoredScene();
  const SPovraySettings settings = Small();
  std::size_t numSkipped = 1;
  MakeSceneFile(scene, ObliqueView(), settings, {}, numSkipped);
  CHECK(numSkipped == 0);
  scene.OfKind(EMeshKind::Box).front().ToWorld[0][3] = nan;
  scene.Glows.push_back({{nan, 0.0f, 0.0f}, 0.01f, kRed});
  scene.Lines.push_back({{0.0f, 0.0f, nan}, {1.0f, 0.0f, 0.5f}, kRed, 2.0f});
  const std::string file = MakeSceneFile(scene, ObliqueView(), settings, {}, numSkipped);
  CHECK(numSkipped == 3);
  CHECK(file.find("nan") == std::string::npos);
  CHECK(file.find("inf") == std::string::npos);
}

TEST_CASE("povray scene: the floor's image has its highest row first", "[povray]") {
  SFloorImage floor;
  floor.Width = 1;
  floor.Height = 2;
  floor.Pixels = std::make_shared<const std::vector<std::uint8_t>>(
      std::vector<std::uint8_t>{'a', 'b', 'c', 255, 'x', 'y', 'z', 255});
  CHECK(MakeFloorFile(floor) == "P6\n1 2\n255\nxyzabc");
}

TEST_CASE("povray scene: finds the lines that tell the error", "[povray]") {
  CHECK(FindPovrayErrors("povray: cannot open the user configuration file\nFile 'a.pov' line 3: "
                         "Parse Error: Undeclared\nFatal error in parser\nCPU time") ==
        "File 'a.pov' line 3: Parse Error: Undeclared\nFatal error in parser");
  CHECK(FindPovrayErrors("something else") == "something else");
}

TEST_CASE("povray scene: lamps reach 0.8 of their height, at least 0.3 m", "[povray]") {
  for (const auto& [height, reach] :
       {std::pair(0.125f, "0.3"), std::pair(0.5f, "0.4"), std::pair(2.0f, "1.6")}) {
    SScene scene = MakeEmptyScene();
    SGlow lamp{{0.0f, 0.0f, height}, 0.03f, kGreen, 4.5f};
    lamp.IsLamp = true;
    scene.Glows = {lamp};
    std::size_t numSkipped = 0;
    CHECK_THAT(MakeSceneFile(scene, ObliqueView(), Small(), {}, numSkipped),
               Catch::Contains(std::string("fade_distance ") + reach + " "));
  }
}

TEST_CASE("povray scene: small LEDs are drawn with 0.75 pixels, signals with 4.4 of 960",
          "[povray]") {
  // 120 pixels of 1/64 m
  SCameraPlacement view = ObliqueView();
  view.OrthographicHeight = 1.875;
  struct SCase {
    float Radius;  // m
    float IsSignal;
    const char* Drawn;  // m
  };
  for (const SCase& c : {SCase{0.03125f, 0.0f, "0.03125"}, SCase{0.0078125f, 0.0f, "0.01171875"},
                         SCase{0.0078125f, 1.0f, "0.0078125"}, SCase{0.001f, 1.0f, "0.00429687"}}) {
    CAPTURE(c.Radius, c.IsSignal);
    SScene scene = MakeEmptyScene();
    scene.Glows = {SGlow{{0.0f, -0.5f, 0.125f}, c.Radius, kRed, 0.0f, 0.0f, c.IsSignal}};
    std::size_t numSkipped = 0;
    CHECK_THAT(MakeSceneFile(scene, view, Small(), {}, numSkipped),
               Catch::Contains(std::string("sphere { <0,-0.5,0.125>, ") + c.Drawn));
  }
}

TEST_CASE("povray scene: edges are rounded by 2 mm, or by 0.12 of a small solid", "[povray]") {
  for (const auto& [size, edge] : {std::pair(0.5, "0.002"), std::pair(0.0078125, "0.0009375")}) {
    SScene scene = MakeEmptyScene();
    scene.OfKind(EMeshKind::Box).push_back(MakeInstance({0, 0, 0}, {size, size, size}, kRed));
    SPovraySettings settings = Small();
    settings.Quality = EPovrayQuality::Best;
    std::size_t numSkipped = 0;
    CHECK_THAT(MakeSceneFile(scene, ObliqueView(), settings, {}, numSkipped),
               Catch::Contains(std::string(edge)));
  }
}

TEST_CASE("povray scene: lines of blanks are no text", "[povray]") {
  SScene scene = MakeEmptyScene();
  scene.OverlayLabels.push_back({{5.0f, 20.0f, 0.0f}, {0, 0, 0, 255}, "one\n \t\n\ntwo", {}});
  std::size_t numSkipped = 0;
  const std::string file = MakeSceneFile(scene, ObliqueView(), Small(), {}, numSkipped);
  std::size_t count = 0;
  const std::string text = "#declare Argos_Line";
  for (std::size_t at = file.find(text); at != std::string::npos; at = file.find(text, at + 1)) {
    ++count;
  }
  CHECK(count == 2);
}

TEST_CASE("povray scene: labels behind the eye, or ten pictures away, are left out", "[povray]") {
  // the picture shows 1 m of height and 4/3 m of width around the origin
  SCameraPlacement view = ViewFromAbove(3.0);
  view.OrthographicHeight = 1.0;
  const auto isDrawn = [](const SCameraPlacement& from, const std::array<float, 3>& position) {
    SScene scene = MakeEmptyScene();
    scene.Labels.push_back({position, kRed, "robot", {}});
    std::size_t numSkipped = 0;
    const std::string file = MakeSceneFile(scene, from, Small(), {}, numSkipped);
    return file.find("#declare Argos_Line") != std::string::npos;
  };
  CHECK(isDrawn(view, {0.0f, 0.0f, 0.0f}));
  // places are shares of the picture from its upper left corner, where 0.5 m is half of its height
  for (const float side : {-1.0f, 1.0f}) {
    CHECK(isDrawn(view, {0.0f, 9.4f * side, 0.0f}));
    CHECK_FALSE(isDrawn(view, {0.0f, 10.6f * side, 0.0f}));
    CHECK(isDrawn(view, {12.5f * side, 0.0f, 0.0f}));
    CHECK_FALSE(isDrawn(view, {14.1f * side, 0.0f, 0.0f}));
  }
  CHECK(isDrawn(ViewFromAbove(3.0), {0.0f, 0.0f, 2.0f}));
  CHECK_FALSE(isDrawn(ViewFromAbove(3.0), {0.0f, 0.0f, 4.0f}));
}

TEST_CASE("povray scene: the look decides how bright sun, sky, lamps and LEDs are", "[povray]") {
  struct SCase {
    const char* Look;
    const char* Sun;
    const char* Fill;
    const char* Lamp;
    const char* LED;  // of one that stands for four
    const char* Panel;
  };
  const SCase c = GENERATE(SCase{"light", "*1 }", "*0.16 ", "*0.6 ", "*1 ", "<1.6,1.6,1.6,0>"},
                           SCase{"dark", "*0.26 }", "*0.05 ", "*1.1 ", "*2.2 ", "<1.1,1.1,1.1,0>"});
  CAPTURE(c.Look);
  SScene scene = MakeEmptyScene();
  SGlow lamp{{0.0f, 0.0f, 1.0f}, 0.03f, kGreen, 4.5f};
  lamp.IsLamp = true;
  const SGlow led{{0.0f, -0.5f, 0.1f}, 0.01f, kRed, 3.6f, 0.0f, 1.0f};
  scene.Glows = {led, led, led, led, lamp};
  SPovraySettings settings = Small();
  settings.Look = SLook::FromName(c.Look);
  settings.IsDark = std::string(c.Look) == "dark";
  settings.MostLights = 1;
  std::size_t numSkipped = 0;
  const std::string file = MakeSceneFile(scene, ObliqueView(), settings, {}, numSkipped);
  CHECK_THAT(file, Catch::Contains(std::string("srgb <1,0.985,0.95>") + c.Sun));
  CHECK_THAT(file, Catch::Contains(std::string("srgb <0.9,0.95,1>") + c.Fill));
  CHECK_THAT(file, Catch::Contains(c.Panel));
  for (const char* factor : {c.Lamp, c.LED}) {
    CAPTURE(factor);
    CHECK_THAT(file, Catch::Contains(std::string(factor) + "fade_distance"));
  }
}

TEST_CASE("povray scene: at most so many lamps, and so many LEDs, are sources of light",
          "[povray]") {
  SScene scene = MakeEmptyScene();
  SGlow lamp{{0.0f, 0.0f, 1.0f}, 0.03f, kGreen, 4.5f};
  lamp.IsLamp = true;
  const SGlow led{{0.0f, -0.5f, 0.1f}, 0.01f, kRed, 3.6f, 0.0f, 1.0f};
  scene.Glows = {led, led, led, led, led, lamp, lamp, lamp};
  SPovraySettings settings = Small();
  // each of the sources stands for so many LEDs
  const auto [most, numLamps, numLEDs, stride] = GENERATE(table<UInt32, size_t, size_t, double>(
      {{0, 0, 0, 1}, {1, 1, 1, 5}, {2, 2, 2, 3}, {3, 3, 2, 2}, {5, 3, 5, 1}, {9, 3, 5, 1}}));
  CAPTURE(most);
  settings.Look = SLook::FromName("light");
  settings.MostLights = most;
  std::size_t numSkipped = 0;
  const std::string file = MakeSceneFile(scene, ObliqueView(), settings, {}, numSkipped);
  const auto count = [&file](const std::string& part) {
    size_t number = 0;
    for (size_t at = file.find(part); at != std::string::npos; at = file.find(part, at + 1)) {
      ++number;
    }
    return number;
  };
  CHECK(count("object { Argos_Cylinder(") == 3);
  CHECK(count("fade_distance 0.8 ") == numLamps);
  CHECK(count("fade_distance ") == numLamps + numLEDs);
  CHECK(count(fmt::format("*{} fade_distance ", 0.5 * std::sqrt(stride))) == numLEDs);
}

TEST_CASE("povray scene: the boundary is four strips across the edges of the arena", "[povray]") {
  SScene scene = MakeEmptyScene();
  scene.ShowBoundary = true;
  scene.ArenaMin = Eigen::Vector2d(-2.0, -1.0);
  scene.ArenaMax = Eigen::Vector2d(4.0, 3.0);
  // pixels of 1/64 m
  SCameraPlacement view = ObliqueView();
  view.OrthographicHeight = 1.875;
  std::size_t numSkipped = 0;
  const std::string file = MakeSceneFile(scene, view, Small(), {}, numSkipped);
  std::vector<std::array<double, 4>> strips;
  for (std::size_t at = file.find("box { <"); at != std::string::npos;
       at = file.find("box { <", at + 1)) {
    std::array<double, 4> strip{};
    if (std::sscanf(file.c_str() + at, "box { <%lf,%lf,0>, <%lf,%lf,0.0002>", &strip[0], &strip[1],
                    &strip[2], &strip[3]) == 4) {
      strips.push_back(strip);
    }
  }
  REQUIRE(strips.size() == 4);
  const double half = -2.0 - strips[0][0];
  CHECK(half > 0.5 / 64.0);
  CHECK(half < 4.0 / 64.0);
  const std::array<std::array<double, 4>, 4> edges = {
      {{-2, -1, 4, -1}, {-2, 3, 4, 3}, {-2, -1, -2, 3}, {4, -1, 4, 3}}};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      CAPTURE(i, k);
      CHECK(strips[i][k] == Approx(edges[i][k] + (k < 2 ? -half : half)));
    }
  }
}

TEST_CASE("povray scene: the sun is as far away as the arena is large, but 3 m at least",
          "[povray]") {
  // of an arena with this middle and side, m
  const auto sunOf = [](const Eigen::Vector2d& middle, double side) {
    SScene scene = MakeEmptyScene();
    scene.ArenaMin = middle - Eigen::Vector2d(0.5 * side, 0.5 * side);
    scene.ArenaMax = middle + Eigen::Vector2d(0.5 * side, 0.5 * side);
    std::size_t numSkipped = 0;
    const std::string file = MakeSceneFile(scene, ObliqueView(), Small(), {}, numSkipped);
    const std::size_t at = file.find("light_source { <");
    REQUIRE(at != std::string::npos);
    Eigen::Vector3d sun;
    REQUIRE(std::sscanf(file.c_str() + at, "light_source { <%lf,%lf,%lf>", &sun.x(), &sun.y(),
                        &sun.z()) == 3);
    return Eigen::Vector3d(sun - Eigen::Vector3d(middle.x(), middle.y(), 0.0));
  };
  const Eigen::Vector3d sun = sunOf({0.0, 0.0}, 10.0);
  CHECK(sun.z() > 0.0);
  CHECK(sun.norm() == Approx(3.0 * std::sqrt(200.0)));
  CHECK((sunOf({20.0, -30.0}, 10.0) - sun).norm() < 1e-9);
  CHECK((sunOf({0.0, 0.0}, 20.0) - 2.0 * sun).norm() < 1e-9);
  CHECK(sunOf({0.0, 0.0}, 0.1).norm() == Approx(3.0));
}

TEST_CASE("povray scene: an image of the floor covers the arena", "[povray]") {
  SScene scene = MakeEmptyScene();
  scene.ArenaMin = Eigen::Vector2d(-2.0, -1.0);
  scene.ArenaMax = Eigen::Vector2d(4.0, 3.0);
  std::size_t numSkipped = 0;
  const auto write = [&](const std::string& floor) {
    SSceneExtras extras;
    extras.FloorFile = floor;
    return MakeSceneFile(scene, ObliqueView(), Small(), extras, numSkipped);
  };
  CHECK_THAT(write("floor.ppm"),
             Catch::Contains("image_map { ppm \"floor.ppm\" gamma srgb once } scale <6,4,1> "
                             "translate <-2,-1,0>"));
  CHECK_THAT(write(""), !Catch::Contains("image_map"));
  scene.Floor.TileSize = {0.5f, 0.25f};
  scene.Floor.IsSmooth = true;
  CHECK_THAT(write("floor.ppm"),
             Catch::Contains("image_map { ppm \"floor.ppm\" gamma srgb interpolate 2 } scale "
                             "<0.5,0.25,1> translate <-2,-1,0>"));
}

TEST_CASE("povray scene: triangles have their corners, and none without an area", "[povray]") {
  SScene scene = MakeEmptyScene();
  const std::array<std::array<float, 3>, 9> corners = {{{0.0f, 0.0f, 0.0f},
                                                        {0.5f, 0.0f, 0.0f},
                                                        {0.0f, 0.5f, 0.0f},
                                                        {0.125f, 0.0f, 0.25f},
                                                        {0.25f, 0.75f, 0.25f},
                                                        {0.0f, 0.625f, 0.25f},
                                                        // on a line
                                                        {0.0f, 0.0f, 0.375f},
                                                        {0.5f, 0.0f, 0.375f},
                                                        {0.875f, 0.0f, 0.375f}}};
  for (const std::array<float, 3>& corner : corners) {
    scene.Flats.push_back({corner, kRed, 0.0f});
  }
  std::size_t numSkipped = 0;
  const std::string file = MakeSceneFile(scene, ObliqueView(), Small(), {}, numSkipped);
  CHECK(numSkipped == 0);
  for (const char* const corner : {"<0,0,0>", "<0.5,0,0>", "<0,0.5,0>", "<0.125,0,0.25>",
                                   "<0.25,0.75,0.25>", "<0,0.625,0.25>"}) {
    CHECK_THAT(file, Catch::Contains(corner));
  }
  CHECK_THAT(file, !Catch::Contains("0.375>"));
}

TEST_CASE("povray scene: triangles that are not finite are left out and counted", "[povray]") {
  const float bad = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t corner = 0; corner < 3; ++corner) {
    CAPTURE(corner);
    SScene scene = MakeEmptyScene();
    for (const std::array<float, 3>& place :
         {std::array<float, 3>{0.0f, 0.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}}) {
      scene.Flats.push_back({place, kRed, 1e-3f});
    }
    std::size_t numSkipped = 0;
    const std::string whole = MakeSceneFile(scene, ObliqueView(), Small(), {}, numSkipped);
    CHECK(numSkipped == 0);
    scene.Flats[corner].Position[1] = bad;
    const std::string rest = MakeSceneFile(scene, ObliqueView(), Small(), {}, numSkipped);
    CHECK(numSkipped == 1);
    CHECK(rest.size() < whole.size());
    CHECK_THAT(rest, !Catch::Contains("nan"));
  }
}

}  // namespace scene_file_test
