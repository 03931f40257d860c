#ifndef ARGOS3_PLUGINS_MEDIA_PHEROMONE_FIELD_H
#define ARGOS3_PLUGINS_MEDIA_PHEROMONE_FIELD_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/vector2.h>

#include <cmath>
#include <vector>

namespace argos {

class CThreadPool;

/**
 * The concentration c(x, y, t) of a substance on a rectangle with closed or joined borders:
 *
 *     dc/dt = diffusion (d2c/dx2 + d2c/dy2) - evaporation c
 *
 * Concentrations are amounts per m^2. Reading is safe on several threads at once, writing is not.
 *
 * Evaporation is exact: it commutes with diffusion, so it is a factor for the whole field.
 * Diffusion is a finite-volume scheme on equal cells. If a few explicit steps per call are
 * stable, or borders are joined, it uses these (forward Euler, five points); otherwise one implicit
 * step along x and one along y (backward Euler, locally one-dimensional: N. N. Yanenko, The Method
 * of Fractional Steps, 1971), stable for any parameters. Both conserve the amount, keep it >= 0, do
 * not increase the maximum, and make the variance of a spot grow by exactly 2 diffusion t along
 * each axis, up to rounding; the implicit step's spot has fatter tails than a Gaussian. Results do
 * not depend on the number of threads. An empty field costs nothing.
 */
class CPheromoneField {
 public:
  /** Equal cells, the first one at the lowest corner. */
  struct SGrid {
    Real MinX = 0.0, MinY = 0.0; /**< m, world frame */
    Real CellX = 1.0, CellY = 1.0; /**< sides of a cell, m */
    size_t NumX = 1, NumY = 1; /**< cells along x and y */
    bool JoinsX = false, JoinsY = false; /**< the two borders across that axis are one line */
  };

  /**
   * @param evaporation  1/s, >= 0.
   * @param diffusion    m^2/s, >= 0.
   * @param maximum      concentration limit of a cell, 1/m^2; deposits above it are lost.
   */
  CPheromoneField(const SGrid& grid, Real evaporation, Real diffusion, Real maximum = HUGE_VAL);

  /**
   * Deposits an amount at a point (m, world frame), distributed bilinearly over the four nearest
   * cells. Deposits outside the rectangle are lost.
   */
  void Deposit(Real x, Real y, Real amount);
  /** The concentration at a point, 1/m^2: bilinear between the centres of cells; 0 outside. */
  Real GetConcentration(Real x, Real y) const;
  /** @param seconds >= 0. */
  void Advance(CThreadPool& pool, Real seconds);
  /** Sets all concentrations to 0. */
  void Clear();

  const SGrid& GetGrid() const { return m_grid; }
  /** Centre of a cell, m, world frame. @param i < GetGrid().NumX. @param j < GetGrid().NumY. */
  CVector2 GetCenter(size_t i, size_t j) const;
  /** The mean concentration in a cell, 1/m^2. */
  Real GetCell(size_t i, size_t j) const {
    ARGOS_ASSERT(i < m_grid.NumX && j < m_grid.NumY,
                 "a pheromone field has no cell (" << i << "," << j << ")");
    return m_scale * m_cells[j * m_grid.NumX + i];
  }
  /**
   * @param concentration in [0,maximum]. @throws CARGoSException if an argument is out of range.
   */
  void SetCell(size_t i, size_t j, Real concentration);
  /** Total amount in the field. */
  Real ComputeTotal() const;

 private:
  // factors of the elimination in a system (1 + 2 r) c[i] - r (c[i-1] + c[i+1]) = b[i], with closed
  // borders
  struct SElimination {
    Real R = 0.0;
    std::vector<Real> Inverse;  // (cells): d[i] = (b[i] + R d[i-1]) Inverse[i]
    std::vector<Real> Back;  // (cells): c[i] = d[i] + Back[i] c[i+1]

    void Prepare(Real r, size_t num);
  };
  // bilinear interpolation at a point: four cells and their weights
  struct SStencil {
    size_t Cells[4];
    Real Shares[4];
  };

  bool Locate(SStencil& stencil, Real x, Real y) const;
  void PrepareSteps(Real seconds);
  void StepExplicitly(CThreadPool& pool);
  void StepImplicitly(CThreadPool& pool);
  void SolveRows(size_t first, size_t last);
  void SolveColumns(size_t first, size_t last);
  void Renormalize(CThreadPool& pool);

  SGrid m_grid;
  Real m_evaporation, m_diffusion, m_maximum;
  Real m_scale = 1.0;  // factor from the stored values to concentrations
  bool m_isEmpty = true;  // all cells are 0
  std::vector<Real> m_cells;  // (NumY, NumX), 1/m^2, to be scaled
  std::vector<Real> m_next;  // (NumY, NumX), target of explicit steps

  // parameters for calls with this duration, s
  Real m_seconds = -1.0;
  UInt32 m_numExplicit = 0;  // 0: one implicit step
  Real m_rX = 0.0, m_rY = 0.0;  // diffusion * step / side^2
  SElimination m_alongX, m_alongY;
};

}  // namespace argos

#endif
