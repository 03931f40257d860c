#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>

#include <argos3/plugins/simulator/visualizations/povray/sdl_text.h>

#include <fmt/format.h>

#include <algorithm>

namespace argos {

namespace {

// a parallel projection also shows what is behind its eye; rays begin this many arenas earlier
constexpr double kArenasBack = 4.0;

void AddCamera(SSceneText& file) {
  const CCamera& camera = file.Camera;
  Eigen::Vector3d position = camera.GetPosition();
  if (camera.IsOrthographic()) {
    const double arena = (file.Scene.ArenaMax - file.Scene.ArenaMin).norm();
    position -= (kArenasBack * arena + position.norm()) * camera.GetForward();
  }
  const Eigen::Vector2d extents = 2.0 * camera.GetHalfExtents();
  file.Text += fmt::format(
      "camera {{\n  {}\n  location {}\n  direction {}\n  right {}\n  up {}\n}}\n",
      camera.IsOrthographic() ? "orthographic" : "perspective", ToSdl(position),
      ToSdl(camera.GetForward()), ToSdl(Eigen::Vector3d(extents.x() * camera.GetRight())),
      ToSdl(Eigen::Vector3d(extents.y() * camera.GetUp())));
}

}  // namespace

double SSceneText::ComputePixelSize(double depth) const {
  const double size = 2.0 * Camera.GetHalfExtents().y() / Settings.Height;
  return Camera.IsOrthographic() ? size : size * std::max(depth, 1e-3);
}

double SSceneText::ComputePixelSizeAt(const std::array<float, 3>& point) const {
  return ComputePixelSize(Camera.ComputeDepth({point[0], point[1], point[2]}));
}

std::string MakeSceneFile(const SScene& scene, const SCameraPlacement& placement,
                          const SPovraySettings& settings, const SSceneExtras& extras,
                          std::size_t& numSkipped) {
  const CCamera camera(placement, static_cast<double>(settings.Width) / settings.Height);
  SSceneText file{settings, scene, camera, MakePrologue(settings)};
  AddCamera(file);
  AddLights(file);
  AddGround(extras.FloorFile, file);
  AddSolids(extras, file);
  AddAnnotations(file);
  numSkipped = file.NumSkipped;
  return std::move(file.Text);
}

std::string MakeFloorFile(const SFloorImage& floor) {
  std::string file = fmt::format("P6\n{} {}\n255\n", floor.Width, floor.Height);
  const auto width = static_cast<std::size_t>(floor.Width);
  file.reserve(file.size() + 3 * width * static_cast<std::size_t>(floor.Height));
  for (auto row = static_cast<std::size_t>(floor.Height); row-- > 0;) {
    const std::uint8_t* pixel = floor.Pixels->data() + 4 * width * row;
    for (std::size_t column = 0; column < width; ++column, pixel += 4) {
      file.append(reinterpret_cast<const char*>(pixel), 3);
    }
  }
  return file;
}

}  // namespace argos
