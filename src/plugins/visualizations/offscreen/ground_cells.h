#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GROUND_CELLS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GROUND_CELLS_H

#include <argos3/plugins/simulator/visualizations/offscreen/instance_batches.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace argos {

constexpr int kGroundCells = 64;  // along each side of the ground

/** Column and row of a cell of the ground. */
typedef std::array<float, 2> TGroundCell;

/**
 * Separates the parts of the ground on which shadows may fall from those that are surely lit: the
 * look-ups in the shadow map are the most expensive part of drawing the ground.
 */
class CGroundCells {
 public:
  /**
   * @param ground   the ground, m.
   * @param casters  solids that may throw shadows.
   * @param toSun    unit vector, world frame, above the horizon.
   * @param blur     reach of a shadow's soft border, m.
   */
  void Fill(const Eigen::AlignedBox2d& ground, const CInstanceBatches::TBatches& casters,
            const Eigen::Vector3d& toSun, double blur);

  const std::vector<TGroundCell>& GetLit() const { return m_lit; }
  /** Cells that contain shadows, or may. */
  const std::vector<TGroundCell>& GetShaded() const { return m_shaded; }

 private:
  void Mark(const Eigen::AlignedBox2d& area);

  Eigen::AlignedBox2d m_ground;
  std::array<std::uint8_t, kGroundCells * kGroundCells> m_isShaded{};
  std::vector<TGroundCell> m_lit;
  std::vector<TGroundCell> m_shaded;
};

}  // namespace argos

#endif
