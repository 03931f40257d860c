#include <argos3/plugins/simulator/visualizations/offscreen/instance_batches.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// diameters on the picture, in pixels
constexpr double kMinDrawnSize = 0.8;  // smaller ones hardly change a pixel
constexpr double kMinDetailSize = 3.5;
constexpr double kMinCasterSize = 1.5;
constexpr double kMinTranslucentSize = 8.0;
// larger ones take the next finer level: an edge of the coarser polygon would be a third of a pixel
// or more, d / 2 (1 - cos(pi / n)), away from its circle
constexpr std::array<double, kNumLevels - 1> kLevelBounds = {6.0, 18.0, 70.0};
// sine of the least height of the sun: a lower one would cast endless shadows
constexpr double kLowestSun = 0.05;

void Clear(CInstanceBatches::TBatches& batches) {
  for (auto& levels : batches) {
    for (std::vector<SMeshInstance>& instances : levels) {
      instances.clear();
    }
  }
}

std::size_t ChooseLevel(double pixels) {
  std::size_t level = 0;
  while (level < kLevelBounds.size() && pixels > kLevelBounds[level]) {
    ++level;
  }
  return level;
}

}  // namespace

Eigen::Matrix3d MakeSunFrame(const Eigen::Vector3d& toSun) {
  // the frame's x axis stays horizontal, so that shadows of walls along x are cut without steps
  Eigen::Vector3d x = Eigen::Vector3d::UnitY().cross(toSun);
  if (x.norm() < 1e-6) {
    x = Eigen::Vector3d::UnitX();
  }
  Eigen::Matrix3d frame;
  frame.row(0) = x.normalized();
  frame.row(1) = toSun.cross(x).normalized();
  frame.row(2) = toSun;
  return frame;
}

SBoundingSphere ComputeBoundingSphere(EMeshKind kind, const SMeshInstance& instance) {
  const bool standsOnBase = kind == EMeshKind::Box || kind == EMeshKind::Cylinder;
  const double centerZ = standsOnBase ? 0.5 : 0.0;
  SBoundingSphere sphere;
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();  // squares of the solid's extents
  for (int row = 0; row < 3; ++row) {
    const auto& entries = instance.ToWorld[static_cast<std::size_t>(row)];
    sphere.Center[row] = entries[3] + centerZ * entries[2];
    const Eigen::Vector3d axes(entries[0], entries[1], entries[2]);
    squares += axes.cwiseProduct(axes);
  }
  // a box and a cylinder reach into the corners of the box of those extents, round ones do not
  sphere.Radius = 0.5 * std::sqrt(standsOnBase ? squares.sum() : squares.maxCoeff());
  return sphere;
}

void CInstanceBatches::Fill(const SScene& scene, const CCamera& camera, int pictureHeight,
                            const Eigen::Vector3d& toSun) {
  Clear(m_opaque);
  Clear(m_casters);
  m_sortKeys.clear();
  m_casterBounds.setEmpty();
  m_depths.setEmpty();
  m_camera = &camera;
  m_sunFrame = MakeSunFrame(toSun);
  const Eigen::Vector2d& extents = camera.GetHalfExtents();
  m_pixelsPerUnit = 0.5 * pictureHeight / extents.y();
  m_sideNorms = Eigen::Vector2d::Ones();
  if (!camera.IsOrthographic()) {
    m_sideNorms = (extents.array().square() + 1.0).sqrt();
  }
  for (std::size_t kind = 0; kind < kNumMeshKinds; ++kind) {
    for (const SMeshInstance& instance : scene.Meshes[kind]) {
      Add(static_cast<EMeshKind>(kind), instance);
    }
  }
  SortTranslucent();
}

void CInstanceBatches::SortTranslucent() {
  std::sort(m_sortKeys.begin(), m_sortKeys.end(), [](const SSortKey& a, const SSortKey& b) {
    if (a.Depth != b.Depth) {
      return a.Depth > b.Depth;
    }
    return a.Kind != b.Kind ? a.Kind < b.Kind : a.Instance < b.Instance;
  });
  m_translucent.clear();
  m_ranges.clear();
  for (const SSortKey& key : m_sortKeys) {
    if (m_ranges.empty() || m_ranges.back().Kind != key.Kind) {
      m_ranges.push_back({key.Kind, m_translucent.size(), 0});
    }
    m_translucent.push_back(*key.Instance);
    ++m_ranges.back().Count;
  }
}

void CInstanceBatches::Add(EMeshKind kind, const SMeshInstance& instance) {
  const SBoundingSphere sphere = ComputeBoundingSphere(kind, instance);
  const Eigen::Vector3d offset = sphere.Center - m_camera->GetPosition();
  const double depth = m_camera->GetForward().dot(offset);
  const Eigen::Vector2d across(std::abs(m_camera->GetRight().dot(offset)),
                               std::abs(m_camera->GetUp().dot(offset)));

  // distance of the centre from the pyramid, or prism, of view, 0 inside
  const bool isParallel = m_camera->IsOrthographic();
  const Eigen::Vector2d toSides =
      (across - (isParallel ? 1.0 : depth) * m_camera->GetHalfExtents()).cwiseQuotient(m_sideNorms);
  const double toView = std::max({toSides.x(), toSides.y(), -depth});
  // distance from the solid to the end of its shadow on the ground
  const double toGround =
      std::max(0.0, sphere.Center.z() + sphere.Radius) / std::max(m_sunFrame(2, 2), kLowestSun);
  if (toView > sphere.Radius + toGround) {
    return;
  }
  const double pixels =
      2.0 * sphere.Radius * m_pixelsPerUnit / (isParallel ? 1.0 : std::max(depth, sphere.Radius));
  if (pixels < (instance.IsDetail > 0.0f ? kMinDetailSize : kMinDrawnSize)) {
    return;
  }
  const std::size_t kindIndex = static_cast<std::size_t>(kind);
  const Eigen::Vector3d inSun = m_sunFrame * sphere.Center;
  const Eigen::Vector3d extent = Eigen::Vector3d::Constant(sphere.Radius);
  m_casterBounds.extend(inSun - extent);
  m_casterBounds.extend(inSun + extent);
  const bool opaque = instance.Color.A == 255 || pixels < kMinTranslucentSize;
  if (opaque && pixels >= kMinCasterSize) {
    // one level coarser than on the picture: shadows have soft borders
    const std::size_t level = ChooseLevel(0.5 * pixels);
    m_casters[kindIndex][level].push_back(instance);
  }
  if (toView > sphere.Radius) {
    return;
  }
  m_depths.extend(Eigen::Matrix<double, 1, 1>(depth - sphere.Radius));
  m_depths.extend(Eigen::Matrix<double, 1, 1>(depth + sphere.Radius));
  if (opaque) {
    m_opaque[kindIndex][ChooseLevel(pixels)].push_back(instance);
  } else if (instance.Color.A > 0) {
    m_sortKeys.push_back({depth, kind, &instance});
  }
}

}  // namespace argos
