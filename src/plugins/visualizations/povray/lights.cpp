#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>
#include <argos3/plugins/simulator/visualizations/povray/sdl_text.h>

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace argos {

namespace {

const Eigen::Vector3d kToSun =
    Eigen::Vector3d(-0.42, -0.38, 0.95).normalized();  // the off-screen view has the same
constexpr double kSunDistance = 3.0;  // diagonals of the arena
constexpr double kSunSize = 0.16;  // width of the area that emits, as a share of its distance
constexpr double kGlowFade = 0.03;  // m at which an LED's light is as bright as its colour
constexpr double kBulbFilter = 0.95;
constexpr double kMinSignalSize = 4.4 / 960.0;  // diameter over the picture's height, as off-screen
constexpr double kMinRobotSize = 5.0 / 960.0;

// intensities, in linear light
struct SLighting {
  double Sun;
  double Fill;
  double LED;
  double Lamp;
  double Halo; /**< opacity at its centre */
  const char* Sky; /**< colour_map from the horizon to the zenith */
  double SoftBox; /**< brightness of the area that metal and glass reflect */
};
constexpr SLighting kLight = {
    1.0, 0.16, 0.5,
    0.6, 0.5,  "[0 srgb <0.97,0.97,0.97>] [0.12 srgb <0.80,0.85,0.91>] [1 srgb <0.50,0.60,0.72>]",
    1.6};
constexpr SLighting kDark = {
    0.26, 0.05, 1.1,
    1.1,  0.6,  "[0 srgb <0.07,0.08,0.095>] [0.2 srgb <0.13,0.15,0.18>] [1 srgb <0.20,0.23,0.29>]",
    1.1};

const SLighting& LightingOf(const SSceneText& file) {
  return file.Settings.IsDark ? kDark : kLight;
}

Eigen::Vector3d ToVector(const std::array<float, 3>& point) {
  return {point[0], point[1], point[2]};
}

// Metal and glass reflect a sky, and a bright panel beside the sun.
void AddSky(SSceneText& file) {
  const SLighting& lighting = LightingOf(file);
  const Eigen::Vector3d panel = Eigen::Vector3d(0.55, -0.45, 0.7).normalized();
  file.Text += fmt::format(
      "sky_sphere {{\n  pigment {{ function {{ min(1, max(0, z)) }} color_map {{ {0} }} }}\n"
      "  pigment {{ function {{ max(0, {2}*x + {3}*y + {4}*z) }} color_map {{ [0.86 srgbt "
      "<1,1,1,1>] [0.90 rgbt <{1},{1},{1},0>] [1 rgbt <{1},{1},{1},0>] }} }}\n}}\n"
      "background {{ color {5} }}\n",
      lighting.Sky, lighting.SoftBox, panel.x(), panel.y(), panel.z(),
      ToSdl(file.Settings.Look.Background));
}

void AddSun(SSceneText& file) {
  const SScene& scene = file.Scene;
  const SLighting& lighting = LightingOf(file);
  const double diagonal = std::max((scene.ArenaMax - scene.ArenaMin).norm(), 1.0);
  const Eigen::Vector2d center = 0.5 * (scene.ArenaMin + scene.ArenaMax);
  const double distance = kSunDistance * diagonal;
  const Eigen::Vector3d position = Eigen::Vector3d(center.x(), center.y(), 0.0) + distance * kToSun;
  const Eigen::Vector3d side =
      kSunSize * distance * kToSun.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d other = kToSun.cross(side);
  const int samples = file.Settings.Quality == EPovrayQuality::Best ? 9 : 5;
  std::string area;
  if (file.Settings.Quality != EPovrayQuality::Draft) {
    area = fmt::format("\n  area_light {}, {}, {}, {} adaptive 1 jitter circular", ToSdl(side),
                       ToSdl(other), samples, samples);
  }
  file.Text += fmt::format("light_source {{ {} srgb <1,0.985,0.95>*{}{} }}\n", ToSdl(position),
                           lighting.Sun, area);
  // light of the sky from the other side
  if (file.Settings.Quality != EPovrayQuality::Draft) {
    return;  // radiosity lights from all sides
  }
  const Eigen::Vector3d fill =
      position - 2.0 * distance * Eigen::Vector3d(kToSun.x(), kToSun.y(), 0.0);
  file.Text += fmt::format("light_source {{ {} srgb <0.9,0.95,1>*{} shadowless }}\n", ToSdl(fill),
                           lighting.Fill);
}

// a soft disc that faces the camera, in front of what glows
void AddHalo(const SGlow& glow, double radius, SSceneText& file) {
  const CCamera& camera = file.Camera;
  const Eigen::Vector3d center = ToVector(glow.Position);
  const Eigen::Vector3d toEye = camera.IsOrthographic()
                                    ? Eigen::Vector3d(-camera.GetForward())
                                    : Eigen::Vector3d((camera.GetPosition() - center).normalized());
  SRgba inner = glow.Color;
  inner.A = static_cast<std::uint8_t>(255.0 * LightingOf(file).Halo);
  SRgba middle = glow.Color;
  middle.A = inner.A / 5;
  SRgba outer = glow.Color;
  outer.A = 0;
  const double reach = radius * glow.HaloScale;
  file.Text += fmt::format(
      "disc {{ <0,0,0>, {}, {} pigment {{ spherical color_map {{ [0 {}] [0.45 {}] [1 {}] }} scale "
      "{} }} finish {{ ambient 0 diffuse 0 emission 1 }} no_shadow no_reflection no_radiosity "
      "translate {} }}\n",
      ToSdl(toEye), reach, ToSdl(outer), ToSdl(middle), ToSdl(inner), reach,
      ToSdl(Eigen::Vector3d(center + 1.2 * radius * toEye)));
}

// a point just outside of the robot that carries an LED: what surrounds the LED would hide it
Eigen::Vector3d ComputeSource(const SGlow& glow, double radius, const SScene& scene) {
  const Eigen::Vector3d position = ToVector(glow.Position);
  const SMarker* nearest = nullptr;
  double least = 0.0;
  for (const SMarker& marker : scene.Markers) {
    const double distance = (ToVector(marker.Position) - position).head<2>().norm();
    if (distance < 1.5 * marker.Radius && (nearest == nullptr || distance < least)) {
      nearest = &marker;
      least = distance;
    }
  }
  if (nearest == nullptr || least < 0.3 * nearest->Radius) {
    return position + Eigen::Vector3d(0.0, 0.0, 1.5 * radius);
  }
  Eigen::Vector3d outward = position - ToVector(nearest->Position);
  outward.z() = 0.0;
  return position + 1.8 * radius * outward.normalized();
}

void AddLamp(const SGlow& lamp, bool isSource, SSceneText& file) {
  const Eigen::Vector3d position = ToVector(lamp.Position);
  const double radius = lamp.Radius;
  // a bulb of glass around what glows, and its socket
  file.Text += fmt::format(
      "union {{\n  sphere {{ <0,0,0>, {} Argos_Glass({}) hollow no_shadow }}\n"
      "  sphere {{ <0,0,0>, {} scale <1,1,1.3> texture {{ pigment {{ color {} }} finish {{ ambient "
      "0 diffuse 0 emission 1.6 }} }} no_shadow }}\n"
      "  object {{ Argos_Cylinder({}, {}, {}) Argos_Metal(srgb <0.72,0.73,0.75>) translate {}*z "
      "no_shadow }}\n  translate {}\n}}\n",
      radius, ToSdlFilter(lamp.Color, kBulbFilter), 0.45 * radius, ToSdl(lamp.Color), 0.42 * radius,
      0.8 * radius, 0.05 * radius, 0.88 * radius, ToSdl(position));
  if (isSource) {
    const bool isDraft = file.Settings.Quality == EPovrayQuality::Draft;
    file.Text += fmt::format(
        "light_source {{ {} color {}*{} fade_distance {} fade_power 2{} }}\n", ToSdl(position),
        ToSdl(lamp.Color), LightingOf(file).Lamp, std::max(0.8 * position.z(), 0.3),
        isDraft ? ""
                : fmt::format(" area_light {0}*x, {0}*y, 3, 3 adaptive 1 jitter circular orient",
                              2.0 * radius));
  }
}

void AddGlow(const SGlow& glow, double radius, SSceneText& file) {
  const bool isLit = glow.HaloScale > 0.0f;
  file.Text += fmt::format("sphere {{ {}, {} {} }}\n", ToSdl(glow.Position), radius,
                           isLit || glow.Pixels > 0.0f || glow.IsSignal == 0.0f
                               ? fmt::format("Argos_Flat({})", ToSdl(glow.Color))
                               : fmt::format("Argos_Plastic({})", ToSdl(glow.Color)));
  if (isLit) {
    AddHalo(glow, radius, file);
  }
}

// an LED that is off: its dark colour, but shaded
bool IsDark(const SGlow& glow) {
  return glow.HaloScale == 0.0f && glow.Pixels == 0.0f && glow.Color.R < 64 && glow.Color.G < 64 &&
         glow.Color.B < 64;
}

double ComputeRadius(const SGlow& glow, const SSceneText& file) {
  const double pixel = file.ComputePixelSizeAt(glow.Position);
  if (glow.Pixels > 0.0f) {
    return 0.5 * glow.Pixels * pixel;
  }
  const double least = glow.IsSignal > 0.0f ? 0.5 * kMinSignalSize * file.Settings.Height : 0.75;
  return std::max<double>(glow.Radius, least * pixel);
}

// sources for at most so many of them, evenly chosen; each stands for several
void AddLEDLights(const std::vector<const SGlow*>& leds, SSceneText& file) {
  const std::size_t most = file.Settings.MostLights;
  if (leds.empty() || most == 0) {
    return;
  }
  const std::size_t stride = (leds.size() + most - 1) / most;
  for (std::size_t i = stride / 2; i < leds.size(); i += stride) {
    const SGlow& led = *leds[i];
    file.Text +=
        fmt::format("light_source {{ {} color {}*{} fade_distance {} fade_power 2 }}\n",
                    ToSdl(ComputeSource(led, led.Radius, file.Scene)), ToSdl(led.Color),
                    LightingOf(file).LED * std::sqrt(static_cast<double>(stride)), kGlowFade);
  }
}

void AddMarkers(SSceneText& file) {
  for (const SMarker& marker : file.Scene.Markers) {
    if (!IsFinite(marker.Position)) {
      continue;  // counted with the robot's solids
    }
    const double least =
        0.5 * kMinRobotSize * file.Settings.Height * file.ComputePixelSizeAt(marker.Position);
    if (marker.Radius < least) {
      file.Text += fmt::format("sphere {{ {}, {} Argos_Flat({}) }}\n", ToSdl(marker.Position),
                               least, ToSdl(file.Settings.Look.Marker));
    }
  }
}

}  // namespace

void AddLights(SSceneText& file) {
  AddSky(file);
  AddSun(file);
  std::vector<const SGlow*> leds;
  std::size_t numLamps = 0;
  for (const SGlow& glow : file.Scene.Glows) {
    if (!IsFinite(glow.Position)) {
      ++file.NumSkipped;
      continue;
    }
    const double radius = ComputeRadius(glow, file);
    if (glow.IsLamp) {
      AddLamp(glow, numLamps++ < file.Settings.MostLights, file);
    } else if (IsDark(glow)) {
      file.Text += fmt::format("sphere {{ {}, {} Argos_Plastic({}) }}\n", ToSdl(glow.Position),
                               radius, ToSdl(glow.Color));
    } else {
      AddGlow(glow, radius, file);
    }
    if (glow.IsSignal > 0.0f) {
      leds.push_back(&glow);
    }
  }
  AddLEDLights(leds, file);
  AddMarkers(file);
}

}  // namespace argos
