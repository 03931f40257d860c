#include <argos3/plugins/simulator/visualizations/scene/drawing_to_scene.h>

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/plugins/simulator/visualizations/scene/scene_parts.h>
#include <argos3/plugins/simulator/visualizations/scene/triangulation.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace argos {

namespace {

typedef std::vector<Eigen::Vector2d> TCorners;

constexpr std::size_t kRoundCorners = 96;  // a chord of 1 m radius is 0.5 mm off its arc
// shares of the distance by which shapes are above the ground, and above those before them
constexpr double kNearer = 5e-4;
constexpr double kNearerPerShape = 2e-6;
constexpr double kNearest = 2.5e-3;  // lines and points come before it, see the shaders

class CSceneDrawer {
 public:
  CSceneDrawer(const CDrawing& drawing, SScene& scene) : m_drawing(drawing), m_scene(scene) {}

  void AddAll() {
    for (const SDrawnShape& shape : m_drawing.GetShapes()) {
      // faces of solids are not in order, but where they are
      m_nearer = shape.IsFace ? 0.0 : std::min(m_nextNearer, kNearest);
      m_nextNearer += shape.IsFace ? 0.0 : kNearerPerShape;
      if (shape.Kind == SDrawnShape::EKind::Text) {
        AddText(shape);
      } else if (shape.Kind == SDrawnShape::EKind::Polygon) {
        AddArea(PolygonCorners(shape), shape);
      } else if (shape.Kind == SDrawnShape::EKind::Circle) {
        AddArea(CircleCorners(shape), shape);
      } else if (shape.Space == SDrawnShape::ESpace::Overlay) {
        AddToOverlay(shape);
      } else {
        AddToWorld(shape);
      }
    }
  }

 private:
  void AddToWorld(const SDrawnShape& shape) {
    switch (shape.Kind) {
      case SDrawnShape::EKind::Point:
        AddPoint(shape);
        break;
      case SDrawnShape::EKind::Line:
        AddLine(ToEigen(shape.Position), ToEigen(shape.Position + shape.Size), shape);
        break;
      case SDrawnShape::EKind::Cylinder:
        AddSolidOf(EMeshKind::Cylinder, shape);
        break;
      case SDrawnShape::EKind::Box:
        AddSolidOf(EMeshKind::Box, shape);
        break;
      default:  // see AddAll()
        break;
    }
  }

  void AddToOverlay(const SDrawnShape& shape) {
    const Eigen::Vector3d position = ToEigen(shape.Position);
    const Eigen::Vector3d size = ToEigen(shape.Size);
    const Eigen::Vector2d half = 0.5 * size.head<2>();
    switch (shape.Kind) {
      case SDrawnShape::EKind::Point:
        AddFilled(RegularCorners(0.5 * shape.Pixels, kRoundCorners), ToPose(shape), shape);
        break;
      case SDrawnShape::EKind::Line:
        AddStroke(position, position + size, shape);
        break;
      case SDrawnShape::EKind::Cylinder:
        AddFilled(RegularCorners(half.x(), kRoundCorners), ToPose(shape), shape);
        break;
      case SDrawnShape::EKind::Box:
        AddFilled({{-half.x(), -half.y()},
                   {half.x(), -half.y()},
                   {half.x(), half.y()},
                   {-half.x(), half.y()}},
                  ToPose(shape), shape);
        break;
      default:  // see AddAll()
        break;
    }
  }

  static SPose ToPose(const SDrawnShape& shape) {
    return argos::ToPose(shape.Position, shape.Orientation);
  }

  static TCorners RegularCorners(double radius, std::size_t count) {
    TCorners corners(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / count;
      corners[i] = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    }
    return corners;
  }

  static TCorners CircleCorners(const SDrawnShape& shape) {
    return RegularCorners(shape.Size.GetX(), shape.Count == 0 ? kRoundCorners : shape.Count);
  }

  TCorners PolygonCorners(const SDrawnShape& shape) const {
    TCorners corners;
    corners.reserve(shape.Count);
    for (std::size_t i = shape.First; i < std::size_t{shape.First} + shape.Count; ++i) {
      ARGOS_ASSERT(i < m_drawing.GetCorners().size(), "a drawing has no corner number " << i);
      const CVector2& corner = m_drawing.GetCorners()[i];
      corners.emplace_back(corner.GetX(), corner.GetY());
    }
    return corners;
  }

  // filled or as an outline
  void AddArea(const TCorners& corners, const SDrawnShape& shape) {
    const SPose pose = ToPose(shape);
    if (shape.IsFilled) {
      AddFilled(corners, pose, shape);
      return;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector3d start = pose * ToPoint(corners[i]);
      const Eigen::Vector3d end = pose * ToPoint(corners[(i + 1) % corners.size()]);
      if (shape.Space == SDrawnShape::ESpace::Overlay) {
        AddStroke(start, end, shape);
      } else {
        AddLine(start, end, shape);
      }
    }
  }

  void AddFilled(const TCorners& corners, const SPose& pose, const SDrawnShape& shape) {
    for (const std::size_t corner : Triangulate(corners)) {
      AddCorner(pose * ToPoint(corners[corner]), shape);
    }
  }

  // a line over the picture is a rectangle
  void AddStroke(const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                 const SDrawnShape& shape) {
    const Eigen::Vector3d along = (end - start).normalized() * 0.5 * shape.Pixels;
    const Eigen::Vector3d across(-along.y(), along.x(), 0.0);
    const std::array<Eigen::Vector3d, 4> corners = {start - along - across, end + along - across,
                                                    end + along + across, start - along + across};
    for (const std::size_t corner : {0, 1, 2, 0, 2, 3}) {
      AddCorner(corners[corner], shape);
    }
  }

  void AddCorner(const Eigen::Vector3d& position, const SDrawnShape& shape) {
    std::vector<SFlatVertex>& flats = shape.Space == SDrawnShape::ESpace::Overlay
                                          ? m_scene.OverlayFlats
                                      : shape.Color.GetAlpha() == 255 ? m_scene.Flats
                                                                      : m_scene.TranslucentFlats;
    flats.push_back({ToFloats(position), ToRgba(shape.Color), static_cast<float>(m_nearer)});
  }

  void AddLine(const Eigen::Vector3d& start, const Eigen::Vector3d& end, const SDrawnShape& shape) {
    SLine line;
    line.Start = ToFloats(start);
    line.End = ToFloats(end);
    line.Color = ToRgba(shape.Color);
    line.Width = static_cast<float>(shape.Pixels);
    m_scene.Lines.push_back(line);
  }

  void AddPoint(const SDrawnShape& shape) {
    SGlow point;
    point.Position = ToFloats(ToEigen(shape.Position));
    point.Color = ToRgba(shape.Color);
    point.Pixels = static_cast<float>(shape.Pixels);
    m_scene.Glows.push_back(point);
  }

  // meshes of solids stand on their base
  void AddSolidOf(EMeshKind kind, const SDrawnShape& shape) {
    const Eigen::Vector3d size = ToEigen(shape.Size);
    SPose pose = ToPose(shape);
    pose.Translation = pose * Eigen::Vector3d(0.0, 0.0, -0.5 * size.z());
    m_scene.OfKind(kind).push_back(MakeSolid(pose, size, shape.Color));
  }

  void AddText(const SDrawnShape& shape) {
    std::vector<SLabel>& labels =
        shape.Space == SDrawnShape::ESpace::Overlay ? m_scene.OverlayLabels : m_scene.Labels;
    labels.push_back({ToFloats(ToEigen(shape.Position)), ToRgba(shape.Color),
                      std::string(m_drawing.GetText(shape)), m_drawing.GetStyles()[shape.Style]});
  }

  static Eigen::Vector3d ToPoint(const Eigen::Vector2d& corner) {
    return {corner.x(), corner.y(), 0.0};
  }

  const CDrawing& m_drawing;
  SScene& m_scene;
  double m_nearer = kNearer;  // that of the present shape
  double m_nextNearer = kNearer + kNearerPerShape;  // that of the next shape drawn in order
};

}  // namespace

void AddDrawing(const CDrawing& drawing, SScene& scene) {
  CSceneDrawer(drawing, scene).AddAll();
}

}  // namespace argos
