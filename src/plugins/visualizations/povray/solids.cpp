#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>
#include <argos3/plugins/simulator/visualizations/povray/sdl_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace argos {

namespace {

typedef std::array<std::array<float, 4>, 3> TRows;

constexpr double kMaxEdge = 0.002;  // radius of rounded edges, m
constexpr double kEdgeShare = 0.12;  // share of a solid's smallest size
constexpr float kMinSize = 1e-6f;  // m
constexpr double kGlassFilter = 0.93;  // share of the light that crosses a surface of glass
constexpr float kGlassShare =
    0.998f;  // share of its length, so that it does not touch what holds it

constexpr std::array<const char*, static_cast<std::size_t>(EMaterial::Count)> kMaterialMacros = {
    "Argos_Plastic", "Argos_Matte", "Argos_Metal", "Argos_Glass"};

// splits the matrix of an instance into sizes along its axes and a rigid motion
Eigen::Vector3f TakeSizes(TRows& rows) {
  Eigen::Vector3f sizes;
  for (std::size_t column = 0; column < 3; ++column) {
    const float size = std::hypot(rows[0][column], rows[1][column], rows[2][column]);
    sizes[static_cast<Eigen::Index>(column)] = size;
    for (std::array<float, 4>& row : rows) {
      row[column] /= size;
    }
  }
  return sizes;
}

std::string MakeCylinder(const Eigen::Vector3f& size, float top, double edge) {
  const std::string flatten =
      size.x() == size.y() ? "" : fmt::format(" scale <1,{},1>", ToSdl(size.y() / size.x()));
  const float radius = 0.5f * size.x();
  if (top != 1.0f) {
    return fmt::format("cone {{ <0,0,0>, {}, <0,0,{}>, {}{}", ToSdl(radius), ToSdl(size.z()),
                       ToSdl(radius * top), flatten);
  }
  return fmt::format("object {{ Argos_Cylinder({}, {}, {}){}", ToSdl(radius), ToSdl(size.z()),
                     ToSdl(edge), flatten);
}

// the object up to its material; its closing brace is left out
std::string MakeShape(EMeshKind kind, const Eigen::Vector3f& size, float param, double edge) {
  switch (kind) {
    case EMeshKind::Box:
      return fmt::format("object {{ Argos_Box({}, {}, {}, {})", ToSdl(size.x()), ToSdl(size.y()),
                         ToSdl(size.z()), ToSdl(edge));
    case EMeshKind::Cylinder:
      return MakeCylinder(size, param, edge);
    case EMeshKind::Sphere:
      return fmt::format("sphere {{ <0,0,0>, 0.5 scale <{},{},{}>", ToSdl(size.x()),
                         ToSdl(size.y()), ToSdl(size.z()));
    case EMeshKind::Ring: {
      // the tube's radius is a share of the outer radius, which is 0.5
      const float tube = 0.5f * param;
      return fmt::format("object {{ Argos_Ring({}, {}) scale <{},{},{}>", ToSdl(0.5f - tube),
                         ToSdl(tube), ToSdl(size.x()), ToSdl(size.y()), ToSdl(size.z()));
    }
    case EMeshKind::Count:
      break;
  }
  return "";
}

// rounded edges consist of solids that overlap, which only opaque materials hide
bool HasRoundEdges(EMeshKind kind, const SMeshInstance& instance, const SPovraySettings& settings) {
  return settings.Quality != EPovrayQuality::Draft && instance.Color.A == 255 &&
         instance.Material != EMaterial::Glass &&
         (kind == EMeshKind::Box || kind == EMeshKind::Cylinder);
}

void AddSolid(EMeshKind kind, const SMeshInstance& instance, SSceneText& file) {
  TRows rows = instance.ToWorld;
  if (!IsFinite(rows) || !std::isfinite(instance.Param)) {
    ++file.NumSkipped;
    return;
  }
  Eigen::Vector3f size = TakeSizes(rows);
  if (!(size.minCoeff() > kMinSize)) {
    return;
  }
  const bool isGlass = instance.Material == EMaterial::Glass;
  if (isGlass && kind != EMeshKind::Sphere && kind != EMeshKind::Ring) {
    const float gap = 0.5f * (1.0f - kGlassShare) * size.z();
    for (std::array<float, 4>& row : rows) {
      row[3] += gap * row[2];
    }
    size.z() *= kGlassShare;
  }
  const double edge = HasRoundEdges(kind, instance, file.Settings)
                          ? std::min<double>(kMaxEdge, kEdgeShare * size.minCoeff())
                          : 0.0;
  file.Text += fmt::format(
      "{} {}({}) {} }}\n", MakeShape(kind, size, instance.Param, edge),
      kMaterialMacros[static_cast<std::size_t>(instance.Material)],
      isGlass ? ToSdlFilter(instance.Color, kGlassFilter) : ToSdl(instance.Color), ToSdl(rows));
}

void AddModels(std::span<const std::string> models, SSceneText& file) {
  std::set<std::size_t> used;
  for (const SModelInstance& instance : file.Scene.Models) {
    used.insert(instance.Model);
  }
  for (const std::size_t model : used) {
    file.Text += fmt::format("#declare Argos_Model_{} =\n{}\n", model, models[model]);
  }
  for (const SModelInstance& instance : file.Scene.Models) {
    if (IsFinite(instance.ToWorld)) {
      file.Text +=
          fmt::format("object {{ Argos_Model_{} {} }}\n", instance.Model, ToSdl(instance.ToWorld));
    } else {
      ++file.NumSkipped;
    }
  }
}

}  // namespace

void AddSolids(const SSceneExtras& extras, SSceneText& file) {
  AddModels(extras.Models, file);
  for (std::size_t kind = 0; kind < kNumMeshKinds; ++kind) {
    for (const SMeshInstance& instance : file.Scene.Meshes[kind]) {
      AddSolid(static_cast<EMeshKind>(kind), instance, file);
    }
  }
}

}  // namespace argos
