#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>
#include <argos3/plugins/simulator/visualizations/povray/sdl_text.h>

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos {

namespace {

constexpr double kOverlayDepth = 0.02;  // m from the eye
constexpr double kLineHeight = 1.2;  // heights of the letters
constexpr double kContourPixels = 1.0;
constexpr int kBrightSum = 384;  // sum of R, G and B; texts darker than this get a bright contour

// a plane in front of everything, whose points are given in pixels
class COverlayPlane {
 public:
  // share: 1 for what is farthest, less for what covers it; > 0
  COverlayPlane(const SSceneText& file, double share)
      : m_pixel(file.ComputePixelSize(kOverlayDepth * share)) {
    const CCamera& camera = file.Camera;
    m_right = camera.GetRight();
    m_up = camera.GetUp();
    m_forward = camera.GetForward();
    double depth = kOverlayDepth * share;
    if (camera.IsOrthographic()) {
      // texts are in front of the whole arena, which may begin before the eye
      depth -= 2.0 * (file.Scene.ArenaMax - file.Scene.ArenaMin).norm() +
               0.5 * camera.GetPosition().norm();
    }
    m_corner = camera.GetPosition() + depth * m_forward -
               0.5 * m_pixel * file.Settings.Width * m_right +
               0.5 * m_pixel * file.Settings.Height * m_up;
  }

  Eigen::Vector3d At(double x, double y) const {
    return m_corner + m_pixel * (x * m_right - y * m_up);
  }
  // transforms pixels to directions: to the right, upwards and towards the eye
  std::string MatrixAt(double x, double y) const {
    const Eigen::Vector3d origin = At(x, y);
    const Eigen::Vector3d right = m_pixel * m_right;
    const Eigen::Vector3d up = m_pixel * m_up;
    const Eigen::Vector3d back = -m_pixel * m_forward;
    return fmt::format("matrix <{},{},{},{},{},{},{},{},{},{},{},{}>", right.x(), right.y(),
                       right.z(), up.x(), up.y(), up.z(), back.x(), back.y(), back.z(), origin.x(),
                       origin.y(), origin.z());
  }

 private:
  double m_pixel;
  Eigen::Vector3d m_right;
  Eigen::Vector3d m_up;
  Eigen::Vector3d m_forward;
  Eigen::Vector3d m_corner;  // upper left
};

bool IsSameColor(const SRgba& a, const SRgba& b) {
  return a.R == b.R && a.G == b.G && a.B == b.B && a.A == b.A;
}

void AddLine(const SLine& line, SSceneText& file) {
  if (!IsFinite(line.Start) || !IsFinite(line.End)) {
    ++file.NumSkipped;
    return;
  }
  const double start = 0.5 * line.Width * file.ComputePixelSizeAt(line.Start);
  const double end = 0.5 * line.Width * file.ComputePixelSizeAt(line.End);
  if (line.Start != line.End && start > 0.0 && end > 0.0) {
    file.Text += fmt::format("cone {{ {}, {}, {}, {} Argos_Flat({}) }}\n", ToSdl(line.Start), start,
                             ToSdl(line.End), end, ToSdl(line.Color));
  }
}

// one mesh for each sequence of triangles of one colour; place() gives the corners
template <typename PLACE>
void AddTriangles(const std::vector<SFlatVertex>& corners, SSceneText& file, PLACE&& place) {
  const SRgba* color = nullptr;  // colour of the open mesh
  const auto close = [&] {
    if (color != nullptr) {
      file.Text += fmt::format("  Argos_Flat({}) }}\n", ToSdl(*color));
    }
  };
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Eigen::Vector3d a = place(corners[i], i);
    const Eigen::Vector3d b = place(corners[i + 1], i);
    const Eigen::Vector3d c = place(corners[i + 2], i);
    if (!(a.allFinite() && b.allFinite() && c.allFinite())) {
      ++file.NumSkipped;
      continue;
    }
    const double longest = std::max((b - a).squaredNorm(), (c - a).squaredNorm());
    if (!((b - a).cross(c - a).norm() > 1e-9 * longest)) {
      continue;
    }
    if (color == nullptr || !IsSameColor(*color, corners[i].Color)) {
      close();
      color = &corners[i].Color;
      file.Text += "mesh {\n";
    }
    file.Text += fmt::format("  triangle {{ {}, {}, {} }}\n", ToSdl(a), ToSdl(b), ToSdl(c));
  }
  close();
}

// adds flat shapes of the world, nearer to the eye by a share of the distance
void AddFlats(const std::vector<SFlatVertex>& corners, SSceneText& file) {
  const CCamera& camera = file.Camera;
  AddTriangles(corners, file, [&camera](const SFlatVertex& corner, std::size_t) {
    const Eigen::Vector3d point(corner.Position[0], corner.Position[1], corner.Position[2]);
    const Eigen::Vector3d toEye =
        camera.IsOrthographic()
            ? Eigen::Vector3d(-std::abs(camera.ComputeDepth(point)) * camera.GetForward())
            : Eigen::Vector3d(camera.GetPosition() - point);
    return Eigen::Vector3d(point + static_cast<double>(corner.Nearer) * toEye);
  });
}

void AddOverlayFlats(SSceneText& file) {
  const std::vector<SFlatVertex>& corners = file.Scene.OverlayFlats;
  const double count = static_cast<double>(corners.size()) + 1.0;
  AddTriangles(corners, file, [&file, count](const SFlatVertex& corner, std::size_t i) {
    const COverlayPlane plane(file, 1.0 - 0.3 * static_cast<double>(i) / count);
    return plane.At(corner.Position[0], corner.Position[1]);
  });
}

// POV-Ray's own fonts: 1 serif, 2 sans, 3 monospace
int ChooseFont(const STextStyle& style) {
  if (style.Family.find("ono") != std::string::npos ||
      style.Family.find("ourier") != std::string::npos) {
    return 3;
  }
  const bool isSerif = style.Family.find("imes") != std::string::npos || style.Family == "serif";
  return isSerif ? 1 : 2;
}

const char* ChooseShift(STextStyle::EAlignment alignment) {
  switch (alignment) {
    case STextStyle::EAlignment::Left:
      return "0";
    case STextStyle::EAlignment::Center:
      return "-0.5*max_extent(Argos_Line).x";
    case STextStyle::EAlignment::Right:
      return "-max_extent(Argos_Line).x";
  }
  return "0";
}

void AddTextLine(const SLabel& label, std::string_view line, const Eigen::Vector2d& position,
                 SSceneText& file) {
  // a text of blanks has no extent, which is an error of POV-Ray
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
    return;
  }
  file.Text +=
      fmt::format("#declare Argos_Line = text {{ internal {} {} 0.01, 0 scale <{},{},1> }}\n",
                  ChooseFont(label.Style), ToSdlString(line), label.Style.Size, label.Style.Size);
  const char* shift = ChooseShift(label.Style.Alignment);
  const bool isDark = label.Color.R + label.Color.G + label.Color.B < kBrightSum;
  const std::uint8_t shade = isDark ? 255 : 0;
  const SRgba contour = {shade, shade, shade, label.Color.A};
  const COverlayPlane back(file, 0.65);
  const COverlayPlane front(file, 0.6);
  const auto add = [&](const COverlayPlane& plane, const SRgba& color, double x, double y) {
    file.Text +=
        fmt::format("object {{ Argos_Line Argos_Flat({}) translate {}*x {} }}\n", ToSdl(color),
                    shift, plane.MatrixAt(position.x() + x, position.y() + y));
  };
  for (const double side : {-kContourPixels, kContourPixels}) {
    add(back, contour, side, side);
    add(back, contour, side, -side);
  }
  add(front, label.Color, 0.0, 0.0);
}

// position: of the first base line, pixels
void AddText(const SLabel& label, Eigen::Vector2d position, SSceneText& file) {
  if (!(label.Style.Size > 0.0)) {
    return;
  }
  std::string_view text = label.Text;
  while (true) {
    const std::size_t end = text.find('\n');
    AddTextLine(label, text.substr(0, end), position, file);
    if (end == std::string_view::npos) {
      return;
    }
    text.remove_prefix(end + 1);
    position.y() += kLineHeight * label.Style.Size;
  }
}

}  // namespace

void AddAnnotations(SSceneText& file) {
  const SScene& scene = file.Scene;
  for (const SLine& line : scene.Lines) {
    AddLine(line, file);
  }
  AddFlats(scene.Flats, file);
  AddFlats(scene.TranslucentFlats, file);
  const Eigen::Vector2d size(file.Settings.Width, file.Settings.Height);
  for (const SLabel& label : scene.Labels) {
    const Eigen::Vector2d place =
        file.Camera.Project({label.Position[0], label.Position[1], label.Position[2]});
    // labels behind the eye, or far outside of the picture, are not visible
    if (place.allFinite() && place.cwiseAbs().maxCoeff() < 10.0) {
      AddText(label, place.cwiseProduct(size), file);
    }
  }
  AddOverlayFlats(file);
  for (const SLabel& label : scene.OverlayLabels) {
    if (IsFinite(label.Position)) {
      AddText(label, {label.Position[0], label.Position[1]}, file);
    }
  }
}

}  // namespace argos
