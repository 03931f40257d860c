#include <argos3/plugins/simulator/visualizations/scene/camera_framing.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace argos {

namespace {

constexpr double kObliqueElevation = 52.0;  // degrees above the horizon
constexpr double kMinHalfSize = 0.05;  // m, of what a picture shows
constexpr int kCentringSteps = 20;

const std::vector<std::string>& GetViewNames() {
  static const std::vector<std::string> names = {"oblique", "top", "side", "front", "corner"};
  return names;
}

}  // namespace

SView SView::FromName(const std::string& name) {
  SView view;
  if (name == "oblique") {
    const double elevation = kObliqueElevation * std::numbers::pi / 180.0;
    view.ToEye = Eigen::Vector3d(0.0, -std::cos(elevation), std::sin(elevation));
  } else if (name == "top") {
    view.ToEye = Eigen::Vector3d::UnitZ();
    view.Up = Eigen::Vector3d::UnitY();
  } else if (name == "side") {
    view.ToEye = -Eigen::Vector3d::UnitY();
  } else if (name == "front") {
    view.ToEye = Eigen::Vector3d::UnitX();
  } else if (name == "corner") {
    view.ToEye = Eigen::Vector3d(-1.0, -1.0, 1.0).normalized();
  } else {
    THROW_ARGOSEXCEPTION("There is no view \"" << name
                                               << "\"; there are oblique, top, side, front, corner"
                                               << DidYouMean(name, GetViewNames()));
  }
  return view;
}

CCameraFraming::CCameraFraming(const SView& view, double aspectRatio, double margin)
    : m_view(view), m_aspectRatio(aspectRatio), m_margin(margin), m_forward(-view.ToEye) {
  SCameraPlacement placement;
  placement.Position = view.ToEye;
  placement.Up = view.Up;
  placement.FocalLength = view.FocalLength;
  const CCamera camera(placement, aspectRatio);
  const std::array<Eigen::Vector3d, 4> outward = {camera.GetRight(), -camera.GetRight(),
                                                  camera.GetUp(), -camera.GetUp()};
  for (std::size_t i = 0; i < m_sides.size(); ++i) {
    m_sides[i].Outward = outward[i];
    m_sides[i].Slope =
        view.IsOrthographic ? 0.0 : camera.GetHalfExtents()[i < 2 ? 0 : 1] / (1.0 + margin);
    m_sides[i].Supports.fill(-std::numeric_limits<double>::infinity());
    m_sides[i].Points.fill(Eigen::Vector3d::Zero());
  }
}

void CCameraFraming::Extend(const Eigen::Vector3d& point) {
  const double depth = m_forward.dot(point);
  m_least = m_isEmpty ? depth : std::min(m_least, depth);
  m_most = m_isEmpty ? depth : std::max(m_most, depth);
  m_isEmpty = false;
  for (SSide& side : m_sides) {
    for (std::size_t i = 0; i < side.Supports.size(); ++i) {
      const double slope = side.Slope * (1.0 - 0.5 * static_cast<double>(i));
      const double support = side.Outward.dot(point) - slope * depth;
      if (support > side.Supports[i]) {
        side.Supports[i] = support;
        side.Points[i] = point;
      }
    }
  }
}

void CCameraFraming::Extend(const Eigen::Vector3d& least, const Eigen::Vector3d& most) {
  for (const double x : {least.x(), most.x()}) {
    for (const double y : {least.y(), most.y()}) {
      for (const double z : {least.z(), most.z()}) {
        Extend(Eigen::Vector3d(x, y, z));
      }
    }
  }
}

double CCameraFraming::ComputeAcross(const SSide& high, const SSide& low, double depth) const {
  // all positions between these show all points
  const double least = high.Supports[0] + high.Slope * depth;
  const double most = -low.Supports[0] - low.Slope * depth;
  double across = 0.5 * (least + most);
  for (int step = 0; step < kCentringSteps; ++step) {
    // tangents of the angles at which the outermost points are seen
    double highest = -std::numeric_limits<double>::infinity();
    double lowest = -highest;
    for (const SSide* side : {&high, &low}) {
      for (const Eigen::Vector3d& point : side->Points) {
        const double ahead = std::max(m_forward.dot(point) - depth, kMinHalfSize);
        const double tangent = (high.Outward.dot(point) - across) / ahead;
        highest = std::max(highest, tangent);
        lowest = std::min(lowest, tangent);
      }
    }
    const double middle = 0.5 * (m_least + m_most) - depth;
    across = std::clamp(across + 0.5 * (highest + lowest) * middle, std::min(least, most),
                        std::max(least, most));
  }
  return across;
}

SCameraPlacement CCameraFraming::ComputePlacement() const {
  if (m_isEmpty) {
    CCameraFraming cube(m_view, m_aspectRatio, m_margin);
    cube.Extend(Eigen::Vector3d::Constant(-kMinHalfSize), Eigen::Vector3d::Constant(kMinHalfSize));
    return cube.ComputePlacement();
  }
  SCameraPlacement placement;
  placement.FocalLength = m_view.FocalLength;
  placement.Up = m_sides[2].Outward;
  if (m_view.IsOrthographic) {
    return ComputeParallel(placement);
  }
  const double depth =
      std::min({-0.5 * (m_sides[0].Supports[0] + m_sides[1].Supports[0]) / m_sides[0].Slope,
                -0.5 * (m_sides[2].Supports[0] + m_sides[3].Supports[0]) / m_sides[2].Slope,
                m_least - kMinHalfSize});
  placement.Position = ComputeAcross(m_sides[0], m_sides[1], depth) * m_sides[0].Outward +
                       ComputeAcross(m_sides[2], m_sides[3], depth) * m_sides[2].Outward +
                       depth * m_forward;
  placement.LookAt = placement.Position + (0.5 * (m_least + m_most) - depth) * m_forward;
  return placement;
}

SCameraPlacement CCameraFraming::ComputeParallel(SCameraPlacement placement) const {
  const auto size = [this](std::size_t side) {
    return std::max(m_sides[side].Supports[0] + m_sides[side + 1].Supports[0], kMinHalfSize);
  };
  const auto middle = [this](std::size_t side) {
    return 0.5 * (m_sides[side].Supports[0] - m_sides[side + 1].Supports[0]);
  };
  placement.OrthographicHeight = (1.0 + m_margin) * std::max(size(2), size(0) / m_aspectRatio);
  // the distance does not matter, as long as everything is ahead of the eye
  const double depth = m_least - placement.OrthographicHeight;
  placement.Position =
      middle(0) * m_sides[0].Outward + middle(2) * m_sides[2].Outward + depth * m_forward;
  placement.LookAt = placement.Position + (0.5 * (m_least + m_most) - depth) * m_forward;
  return placement;
}

}  // namespace argos
