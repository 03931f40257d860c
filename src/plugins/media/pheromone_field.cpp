#include <argos3/plugins/simulator/media/pheromone_field.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <algorithm>

namespace argos {

namespace {

// limit of rX + rY in an explicit step: half of the stability limit, which keeps spots round
constexpr Real kMaxPerStep = 0.25;
constexpr Real kMaxSteps = 4.0;  // explicit steps; more of them cost more than an implicit one
// smaller values are set to 0: denormal numbers would slow the processor down
constexpr Real kNothing = 1e-200;
constexpr Real kMinScale = 1e-30;

constexpr size_t kRowGrain = 16;
constexpr size_t kColumnGrain = 64;
constexpr size_t kRowsAtOnce = 8;  // rows whose eliminations are interleaved

Real Flush(Real value) {
  return value < kNothing ? 0.0 : value;
}

// one row of an explicit step; up and down are the neighbouring rows, or the row itself at a
// border. Opposite neighbours are added first, so that a mirrored field stays bitwise mirrored
void DiffuseRow(const Real* up, const Real* row, const Real* down, Real* __restrict next,
                size_t num, bool isJoined, Real rX, Real rY) {
  const auto diffuse = [&](size_t i, Real left, Real right) {
    const Real here = row[i];
    const Real alongX = rX * ((left + right) - 2.0 * here);
    const Real alongY = rY * ((up[i] + down[i]) - 2.0 * here);
    next[i] = Flush(here + (alongX + alongY));
  };
  for (size_t i = 1; i + 1 < num; ++i) {
    diffuse(i, row[i - 1], row[i + 1]);
  }
  diffuse(0, row[isJoined ? num - 1 : 0], row[num > 1 ? 1 : 0]);
  if (num > 1) {
    diffuse(num - 1, row[num - 2], row[isJoined ? 0 : num - 1]);
  }
}

}  // namespace

CPheromoneField::CPheromoneField(const SGrid& grid, Real evaporation, Real diffusion, Real maximum)
    : m_grid(grid),
      m_evaporation(evaporation),
      m_diffusion(diffusion),
      m_maximum(maximum),
      m_cells(grid.NumX * grid.NumY, 0.0) {}

bool CPheromoneField::Locate(SStencil& stencil, Real x, Real y) const {
  // in cells from the lowest corner; the comparison treats NaN as outside
  const auto toCells = [](Real offset, Real cell, size_t num, bool isJoined) {
    const Real cells = offset / cell;
    const Real all = static_cast<Real>(num);
    return isJoined ? std::min(all, cells - all * std::floor(cells / all)) : cells;
  };
  const Real u = toCells(x - m_grid.MinX, m_grid.CellX, m_grid.NumX, m_grid.JoinsX);
  const Real v = toCells(y - m_grid.MinY, m_grid.CellY, m_grid.NumY, m_grid.JoinsY);
  const bool isInside = u >= 0.0 && v >= 0.0 && u <= static_cast<Real>(m_grid.NumX) &&
                        v <= static_cast<Real>(m_grid.NumY);
  if (!isInside) {
    return false;
  }
  // outside the outermost centres, both points are the border cell
  const auto split = [](Real place, size_t num, bool isJoined, size_t& low, size_t& high,
                        Real& share) {
    if (isJoined) {
      // the last cell is next to the first one
      const Real fromLast = place + 0.5;
      const auto cell = static_cast<size_t>(fromLast);
      low = (cell + num - 1) % num;
      high = cell % num;
      share = fromLast - static_cast<Real>(cell);
      return;
    }
    const Real fromCenter = std::max(0.0, place - 0.5);
    low = std::min(num - 1, static_cast<size_t>(fromCenter));
    high = std::min(num - 1, low + 1);
    share = place < 0.5 ? 0.0 : fromCenter - static_cast<Real>(low);
  };
  size_t i[2];
  size_t j[2];
  Real shareX = 0.0;
  Real shareY = 0.0;
  split(u, m_grid.NumX, m_grid.JoinsX, i[0], i[1], shareX);
  split(v, m_grid.NumY, m_grid.JoinsY, j[0], j[1], shareY);
  for (size_t corner = 0; corner < 4; ++corner) {
    stencil.Cells[corner] = j[corner / 2] * m_grid.NumX + i[corner % 2];
    stencil.Shares[corner] =
        (corner % 2 == 0 ? 1.0 - shareX : shareX) * (corner / 2 == 0 ? 1.0 - shareY : shareY);
  }
  return true;
}

void CPheromoneField::Deposit(Real x, Real y, Real amount) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckShared("CPheromoneField::Deposit()");
  }
  SStencil stencil;
  if (!Locate(stencil, x, y)) {
    return;
  }
  m_isEmpty = false;
  const Real perCell = amount / (m_grid.CellX * m_grid.CellY * m_scale);
  const Real most = m_maximum / m_scale;
  for (size_t corner = 0; corner < 4; ++corner) {
    ARGOS_ASSERT(stencil.Cells[corner] < m_cells.size(),
                 "a deposit is outside the pheromone field");
    Real& cell = m_cells[stencil.Cells[corner]];
    cell = std::min(most, cell + perCell * stencil.Shares[corner]);
  }
}

Real CPheromoneField::GetConcentration(Real x, Real y) const {
  SStencil stencil;
  if (!Locate(stencil, x, y)) {
    return 0.0;
  }
  Real sum = 0.0;
  for (size_t corner = 0; corner < 4; ++corner) {
    ARGOS_ASSERT(stencil.Cells[corner] < m_cells.size(),
                 "a reading is outside the pheromone field");
    sum += m_cells[stencil.Cells[corner]] * stencil.Shares[corner];
  }
  return m_scale * sum;
}

void CPheromoneField::Clear() {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckShared("CPheromoneField::Clear()");
  }
  std::fill(m_cells.begin(), m_cells.end(), 0.0);
  m_scale = 1.0;
  m_isEmpty = true;
}

CVector2 CPheromoneField::GetCenter(size_t i, size_t j) const {
  ARGOS_ASSERT(i < m_grid.NumX && j < m_grid.NumY,
               "a pheromone field has no cell (" << i << "," << j << ")");
  return {m_grid.MinX + (static_cast<Real>(i) + 0.5) * m_grid.CellX,
          m_grid.MinY + (static_cast<Real>(j) + 0.5) * m_grid.CellY};
}

void CPheromoneField::SetCell(size_t i, size_t j, Real concentration) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckShared("CPheromoneField::SetCell()");
  }
  if (i >= m_grid.NumX || j >= m_grid.NumY) {
    THROW_ARGOSEXCEPTION("pheromone: there is no cell (" << i << "," << j << ") among "
                                                         << m_grid.NumX << " x " << m_grid.NumY);
  }
  if (!(std::isfinite(concentration) && concentration >= 0.0 && concentration <= m_maximum)) {
    THROW_ARGOSEXCEPTION("pheromone: the concentration of a cell must be in [0,"
                         << m_maximum << "] (1/m^2), got " << concentration);
  }
  m_isEmpty = m_isEmpty && concentration == 0.0;
  m_cells[j * m_grid.NumX + i] = concentration / m_scale;
}

Real CPheromoneField::ComputeTotal() const {
  Real total = 0.0;
  for (size_t j = 0; j < m_grid.NumY; ++j) {
    Real row = 0.0;
    for (size_t i = 0; i < m_grid.NumX; ++i) {
      row += m_cells[j * m_grid.NumX + i];
    }
    total += row;
  }
  return total * m_scale * m_grid.CellX * m_grid.CellY;
}

void CPheromoneField::SElimination::Prepare(Real r, size_t num) {
  R = r;
  Inverse.resize(num);
  Back.resize(num);
  // excess of the diagonal over r; computed as a sum, since for a large r a difference would cancel
  // and lose some of the substance
  Real excess = 1.0;
  for (size_t i = 0; i < num; ++i) {
    if (i > 0) {
      excess = 1.0 + r * (excess * Inverse[i - 1]);
    }
    const bool hasNext = i + 1 < num;
    Inverse[i] = 1.0 / (excess + (hasNext ? r : 0.0));
    Back[i] = hasNext ? r * Inverse[i] : 0.0;
  }
}

void CPheromoneField::PrepareSteps(Real seconds) {
  if (seconds == m_seconds) {
    return;
  }
  m_seconds = seconds;
  m_rX = m_diffusion * seconds / (m_grid.CellX * m_grid.CellX);
  m_rY = m_diffusion * seconds / (m_grid.CellY * m_grid.CellY);
  const Real numSteps = std::ceil((m_rX + m_rY) / kMaxPerStep);
  // the elimination ends at closed borders
  if (numSteps <= kMaxSteps || m_grid.JoinsX || m_grid.JoinsY) {
    m_numExplicit = std::max(1U, static_cast<UInt32>(numSteps));
    m_rX /= m_numExplicit;
    m_rY /= m_numExplicit;
    m_next.resize(m_cells.size());
  } else {
    m_numExplicit = 0;
    m_alongX.Prepare(m_rX, m_grid.NumX);
    m_alongY.Prepare(m_rY, m_grid.NumY);
  }
}

void CPheromoneField::Advance(CThreadPool& pool, Real seconds) {
  const bool spreads = m_diffusion > 0.0 && seconds > 0.0;
  if (spreads) {
    // an empty field, too, allocates before the memory is needed
    PrepareSteps(seconds);
  }
  if (m_isEmpty) {
    return;
  }
  if (spreads) {
    for (UInt32 step = 0; step < m_numExplicit; ++step) {
      StepExplicitly(pool);
    }
    if (m_numExplicit == 0) {
      StepImplicitly(pool);
    }
  }
  m_scale *= std::exp(-m_evaporation * seconds);
  if (m_scale < kMinScale) {
    Renormalize(pool);
  }
}

void CPheromoneField::StepExplicitly(CThreadPool& pool) {
  pool.ParallelFor(m_grid.NumY, kRowGrain, [this](size_t begin, size_t end, UInt32) {
    for (size_t j = begin; j < end; ++j) {
      const Real* const row = m_cells.data() + j * m_grid.NumX;
      const Real* const first = m_grid.JoinsY ? m_cells.data() : row;
      const Real* const last = m_grid.JoinsY ? m_cells.data() + m_cells.size() - m_grid.NumX : row;
      const Real* const up = j > 0 ? row - m_grid.NumX : last;
      const Real* const down = j + 1 < m_grid.NumY ? row + m_grid.NumX : first;
      DiffuseRow(up, row, down, m_next.data() + j * m_grid.NumX, m_grid.NumX, m_grid.JoinsX, m_rX,
                 m_rY);
    }
  });
  m_cells.swap(m_next);
}

void CPheromoneField::StepImplicitly(CThreadPool& pool) {
  const size_t numGroups = (m_grid.NumY + kRowsAtOnce - 1) / kRowsAtOnce;
  pool.ParallelFor(numGroups, 2, [this](size_t begin, size_t end, UInt32) {
    for (size_t group = begin; group < end; ++group) {
      SolveRows(group * kRowsAtOnce, std::min(m_grid.NumY, (group + 1) * kRowsAtOnce));
    }
  });
  pool.ParallelFor(m_grid.NumX, kColumnGrain,
                   [this](size_t begin, size_t end, UInt32) { SolveColumns(begin, end); });
}

// each value depends on the previous one: interleaving several rows hides the latency
void CPheromoneField::SolveRows(size_t first, size_t last) {
  Real* rows[kRowsAtOnce];
  const size_t numRows = last - first;
  for (size_t k = 0; k < numRows; ++k) {
    rows[k] = m_cells.data() + (first + k) * m_grid.NumX;
    rows[k][0] *= m_alongX.Inverse[0];
  }
  for (size_t i = 1; i < m_grid.NumX; ++i) {
    const Real inverse = m_alongX.Inverse[i];
    for (size_t k = 0; k < numRows; ++k) {
      rows[k][i] = Flush((rows[k][i] + m_alongX.R * rows[k][i - 1]) * inverse);
    }
  }
  for (size_t i = m_grid.NumX - 1; i-- > 0;) {
    const Real back = m_alongX.Back[i];
    for (size_t k = 0; k < numRows; ++k) {
      rows[k][i] = Flush(rows[k][i] + back * rows[k][i + 1]);
    }
  }
}

void CPheromoneField::SolveColumns(size_t first, size_t last) {
  const size_t stride = m_grid.NumX;
  Real* row = m_cells.data();
  for (size_t i = first; i < last; ++i) {
    row[i] *= m_alongY.Inverse[0];
  }
  for (size_t j = 1; j < m_grid.NumY; ++j) {
    const Real* const before = row;
    row += stride;
    const Real inverse = m_alongY.Inverse[j];
    for (size_t i = first; i < last; ++i) {
      row[i] = Flush((row[i] + m_alongY.R * before[i]) * inverse);
    }
  }
  for (size_t j = m_grid.NumY - 1; j-- > 0;) {
    const Real* const after = row;
    row -= stride;
    const Real back = m_alongY.Back[j];
    for (size_t i = first; i < last; ++i) {
      row[i] = Flush(row[i] + back * after[i]);
    }
  }
}

void CPheromoneField::Renormalize(CThreadPool& pool) {
  pool.ParallelFor(m_cells.size(), kRowGrain * m_grid.NumX,
                   [this](size_t begin, size_t end, UInt32) {
                     for (size_t k = begin; k < end; ++k) {
                       m_cells[k] = Flush(m_cells[k] * m_scale);
                     }
                   });
  m_scale = 1.0;
  m_isEmpty = std::all_of(m_cells.begin(), m_cells.end(), [](Real cell) { return cell == 0.0; });
}

}  // namespace argos
