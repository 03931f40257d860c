#ifndef ARGOS3_TESTING_SUPPORT_PICTURES_H
#define ARGOS3_TESTING_SUPPORT_PICTURES_H

#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>

namespace argos {

/* Small scenes, views and what is seen at a place of a picture, for tests of the renderer. */

constexpr SRgba kRed = {220, 30, 30, 255};
constexpr SRgba kGreen = {30, 200, 30, 255};

inline SRenderSettings SmallPicture() {
  SRenderSettings settings;
  settings.Width = 160;
  settings.Height = 120;
  return settings;
}

inline SScene MakeEmptyScene() {
  SScene scene;
  scene.ArenaMin = Eigen::Vector2d(-2.0, -2.0);
  scene.ArenaMax = Eigen::Vector2d(2.0, 2.0);
  return scene;
}

inline SMeshInstance MakeInstance(const Eigen::Vector3d& base, const Eigen::Vector3d& size,
                                  const SRgba& color) {
  SMeshInstance instance;
  for (std::size_t row = 0; row < 3; ++row) {
    instance.ToWorld[row] = {0.0f, 0.0f, 0.0f, static_cast<float>(base[static_cast<int>(row)])};
    instance.ToWorld[row][row] = static_cast<float>(size[static_cast<int>(row)]);
  }
  instance.Color = color;
  return instance;
}

// from the side of negative y, slightly elevated
inline SCameraPlacement ObliqueView() {
  SCameraPlacement placement;
  placement.Position = Eigen::Vector3d(0.0, -3.0, 2.0);
  placement.LookAt = Eigen::Vector3d::Zero();
  placement.FocalLength = 25.0;
  return placement;
}

inline SCameraPlacement ViewFromAbove(double height) {
  SCameraPlacement placement;
  placement.Position = Eigen::Vector3d(0.0, 0.0, height);
  placement.LookAt = Eigen::Vector3d::Zero();
  placement.Up = Eigen::Vector3d::UnitY();
  placement.FocalLength = 25.0;
  return placement;
}

inline const std::uint8_t* PixelOf(const SPicture& picture, const SCameraPlacement& placement,
                                   const Eigen::Vector3d& point) {
  const CCamera camera(placement, static_cast<double>(picture.Width) / picture.Height);
  const Eigen::Vector2d share = camera.Project(point);
  REQUIRE((share.array() >= 0.0 && share.array() < 1.0).all());
  return picture.At(static_cast<int>(share.x() * picture.Width),
                    static_cast<int>(share.y() * picture.Height));
}

inline bool IsReddish(const std::uint8_t* pixel) {
  return pixel[0] > 2 * pixel[1] && pixel[0] > 2 * pixel[2];
}

inline bool IsGreenish(const std::uint8_t* pixel) {
  return pixel[1] > 2 * pixel[0] && pixel[1] > 2 * pixel[2];
}

// the ground and the background are nearly grey in both looks; skylight makes shadows slightly blue
inline bool IsGreyish(const std::uint8_t* pixel) {
  const auto [least, most] = std::minmax({pixel[0], pixel[1], pixel[2]});
  return most - least < 30;
}

inline int Brightness(const std::uint8_t* pixel) {
  return pixel[0] + pixel[1] + pixel[2];
}

}  // namespace argos

#endif
