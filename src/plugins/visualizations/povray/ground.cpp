#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>
#include <argos3/plugins/simulator/visualizations/povray/sdl_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace argos {

namespace {

constexpr double kMinCellSize = 14.0;  // pixels; finer grids are left out
constexpr double kGridPixels = 1.3;  // width of its lines
constexpr double kBoundaryPixels = 2.6;
constexpr double kReach = 2.5;  // extent of the ground around the arena, in diagonals of the arena
constexpr double kOutsideStep = 1.0;  // m between lines around the arena, at least
constexpr double kOutsideDepth = 0.0004;  // m that the ground around the arena lies lower

// m between lines, and their opacity, 0 to 255
struct SGridLevel {
  double Step;
  std::uint8_t Opacity;
};
constexpr std::array<SGridLevel, 3> kGrid = {{{0.1, 70}, {1.0, 130}, {10.0, 190}}};

std::string MakeStripes(const SRgba& color, const SGridLevel& level, double width, char axis) {
  SRgba line = color;
  line.A = level.Opacity;
  SRgba clear = color;
  clear.A = 0;
  const double share = width / level.Step;
  return fmt::format(
      "  texture {{ pigment {{ gradient {} color_map {{ [0 {}] [{} {}] [{} {}] [1 {}] }} scale {} "
      "translate -{}*{} }} finish {{ diffuse 0.8 }} }}\n",
      axis, ToSdl(line), share, ToSdl(line), share, ToSdl(clear), ToSdl(clear), level.Step,
      0.5 * width, axis);
}

// leastStep: m; finer grids are left out
std::string MakeGrid(const SSceneText& file, double pixel, double leastStep) {
  std::string text;
  if (file.Scene.ShowGrid) {
    for (const SGridLevel& level : kGrid) {
      if (level.Step >= std::max(kMinCellSize * pixel, leastStep)) {
        for (const char axis : {'x', 'y'}) {
          text += MakeStripes(file.Settings.Look.GridLine, level, kGridPixels * pixel, axis);
        }
      }
    }
  }
  return text;
}

std::string MakeBase(const std::string& floorFile, const SSceneText& file) {
  const SScene& scene = file.Scene;
  if (floorFile.empty()) {
    return fmt::format(
        "  texture {{ pigment {{ color {} }} finish {{ diffuse 0.8 specular 0.06 roughness 0.06 }} "
        "}}\n",
        ToSdl(file.Settings.Look.Ground));
  }
  const std::array<float, 2>& tile = scene.Floor.TileSize;
  const bool isRepeated = tile[0] > 0.0f;
  const Eigen::Vector2d size = isRepeated ? Eigen::Vector2d(tile[0], tile[1])
                                          : Eigen::Vector2d(scene.ArenaMax - scene.ArenaMin);
  return fmt::format(
      "  texture {{ pigment {{ image_map {{ ppm {} gamma srgb{}{} }} scale <{},{},1> translate "
      "<{},{},0> }} finish {{ diffuse 0.8 specular 0.06 roughness 0.06 }} }}\n",
      ToSdlString(floorFile), isRepeated ? "" : " once",
      scene.Floor.IsSmooth ? " interpolate 2" : "", size.x(), size.y(), scene.ArenaMin.x(),
      scene.ArenaMin.y());
}

// fades into the horizon, where nothing is lit by the sun any more
void AddSurroundings(const Eigen::Vector2d& center, const std::string& grid, SSceneText& file) {
  const double reach = kReach * (file.Scene.ArenaMax - file.Scene.ArenaMin).norm();
  const SRgba color = file.Settings.Look.GroundOutside;
  SRgba clear = color;
  clear.A = 0;
  file.Text += fmt::format(
      "disc {{ <{0},{1},-{2}>, z, {3}\n  texture {{ pigment {{ spherical color_map {{ [0 {4}] [0.6 "
      "{5}] [1 {5}] }} scale {3} translate <{0},{1},0> }} finish {{ diffuse 0.85 }} }}\n{6}}}\n",
      center.x(), center.y(), kOutsideDepth, reach, ToSdl(clear), ToSdl(color), grid);
}

void AddBoundary(SSceneText& file, double width) {
  const Eigen::Vector2d least = file.Scene.ArenaMin;
  const Eigen::Vector2d most = file.Scene.ArenaMax;
  const double half = 0.5 * width;
  const auto addStrip = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    file.Text += fmt::format("box {{ <{},{},0>, <{},{},0.0002> Argos_Matte({}) no_shadow }}\n",
                             from.x() - half, from.y() - half, to.x() + half, to.y() + half,
                             ToSdl(file.Settings.Look.Boundary));
  };
  addStrip(least, {most.x(), least.y()});
  addStrip({least.x(), most.y()}, most);
  addStrip(least, {least.x(), most.y()});
  addStrip({most.x(), least.y()}, most);
}

}  // namespace

void AddGround(const std::string& floorFile, SSceneText& file) {
  const SScene& scene = file.Scene;
  const Eigen::Vector2d center = 0.5 * (scene.ArenaMin + scene.ArenaMax);
  const double pixel = file.ComputePixelSizeAt(
      {static_cast<float>(center.x()), static_cast<float>(center.y()), 0.0f});
  const std::string grid = MakeGrid(file, pixel, 0.0);
  AddSurroundings(center, MakeGrid(file, pixel, kOutsideStep), file);
  file.Text += fmt::format("box {{ <{},{},-0.0008>, <{},{},0>\n{}{}}}\n", scene.ArenaMin.x(),
                           scene.ArenaMin.y(), scene.ArenaMax.x(), scene.ArenaMax.y(),
                           MakeBase(floorFile, file), grid);
  if (scene.ShowBoundary) {
    AddBoundary(file, kBoundaryPixels * pixel);
  }
}

}  // namespace argos
