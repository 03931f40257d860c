#include <argos3/plugins/simulator/visualizations/offscreen/ground_cells.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// The shadow of a solid is inside that of the box around it.
Eigen::AlignedBox2d ComputeShadow(EMeshKind kind, const SMeshInstance& instance,
                                  const Eigen::Vector2d& slope) {
  const bool standsOnBase = kind == EMeshKind::Box || kind == EMeshKind::Cylinder;
  const double base = standsOnBase ? 0.0 : -0.5;
  Eigen::AlignedBox2d shadow;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector4d inSolid((corner & 1) - 0.5, ((corner >> 1) & 1) - 0.5,
                                  base + (corner >> 2), 1.0);
    Eigen::Vector3d point;
    for (int row = 0; row < 3; ++row) {
      const auto& entries = instance.ToWorld[static_cast<std::size_t>(row)];
      point[row] = Eigen::Vector4f(entries.data()).cast<double>().dot(inSolid);
    }
    shadow.extend(point.head<2>() - slope * std::max(point.z(), 0.0));
  }
  return shadow;
}

}  // namespace

void CGroundCells::Fill(const Eigen::AlignedBox2d& ground,
                        const CInstanceBatches::TBatches& casters, const Eigen::Vector3d& toSun,
                        double blur) {
  m_ground = ground;
  m_isShaded.fill(0);
  const Eigen::Vector2d slope = toSun.head<2>() / toSun.z();
  const Eigen::Vector2d border = Eigen::Vector2d::Constant(blur);
  for (std::size_t kind = 0; kind < kNumMeshKinds; ++kind) {
    for (const std::vector<SMeshInstance>& instances : casters[kind]) {
      for (const SMeshInstance& instance : instances) {
        const Eigen::AlignedBox2d shadow =
            ComputeShadow(static_cast<EMeshKind>(kind), instance, slope);
        Mark(Eigen::AlignedBox2d(shadow.min() - border, shadow.max() + border));
      }
    }
  }
  m_shaded.clear();
  for (int row = 0; row < kGroundCells; ++row) {
    AddSpans(row);
  }
}

// each span of shaded cells continues the rectangle below it if that has the same columns
void CGroundCells::AddSpans(int row) {
  const auto isShaded = [&](int column) {
    return m_isShaded[static_cast<std::size_t>(row) * kGroundCells +
                      static_cast<std::size_t>(column)] != 0;
  };
  const auto y = static_cast<float>(row);
  for (int first = 0; first < kGroundCells; ++first) {
    if (!isShaded(first)) {
      continue;
    }
    int end = first;
    while (end < kGroundCells && isShaded(end)) {
      ++end;
    }
    const auto left = static_cast<float>(first);
    const auto right = static_cast<float>(end);
    const auto below = std::find_if(m_shaded.begin(), m_shaded.end(), [&](const TGroundArea& area) {
      return area[0] == left && area[2] == right && area[3] == y;
    });
    if (below != m_shaded.end()) {
      (*below)[3] = y + 1.0f;
    } else {
      m_shaded.push_back({left, y, right, y + 1.0f});
    }
    first = end;
  }
}

void CGroundCells::Mark(const Eigen::AlignedBox2d& area) {
  const auto toCells = [this](const Eigen::Vector2d& point) {
    const Eigen::Vector2d share = (point - m_ground.min()).cwiseQuotient(m_ground.sizes());
    return Eigen::Vector2i(
        (share * kGroundCells).array().floor().max(-1.0).min(kGroundCells).cast<int>());
  };
  const Eigen::Vector2i first = toCells(area.min()).cwiseMax(0);
  const Eigen::Vector2i last = toCells(area.max()).cwiseMin(kGroundCells - 1);
  for (int row = first.y(); row <= last.y(); ++row) {
    for (int column = first.x(); column <= last.x(); ++column) {
      m_isShaded[static_cast<std::size_t>(row) * kGroundCells + static_cast<std::size_t>(column)] =
          1;
    }
  }
}

}  // namespace argos
