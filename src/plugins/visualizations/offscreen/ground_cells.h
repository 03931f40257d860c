#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GROUND_CELLS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_GROUND_CELLS_H

#include <argos3/plugins/simulator/visualizations/offscreen/instance_batches.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace argos {

constexpr int kGroundCells = 64;  // number along each side of the ground

/** A rectangle of cells: first column, first row, and those after the last ones. */
typedef std::array<float, 4> TGroundArea;

/**
 * Finds the parts of the ground on which shadows may fall: the look-ups in the shadow map are the
 * most expensive part of drawing the ground.
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

  /** Rectangles that do not overlap and contain all shadows. */
  const std::vector<TGroundArea>& GetShaded() const { return m_shaded; }

 private:
  void Mark(const Eigen::AlignedBox2d& area);
  void AddSpans(int row);

  Eigen::AlignedBox2d m_ground;
  std::array<std::uint8_t, kGroundCells * kGroundCells> m_isShaded{};
  std::vector<TGroundArea> m_shaded;
};

}  // namespace argos

#endif
