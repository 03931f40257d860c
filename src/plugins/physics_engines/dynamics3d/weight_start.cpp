#include <argos3/plugins/simulator/physics_engines/dynamics3d/weight_start.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace argos {

namespace {

// least height of the normal, of length 1, of a contact that bears
constexpr Real kLevel = 0.9;
// m^2, and share of the squares of distances, which are added to these: places in a line, or a
// single one, bear no moment across it
constexpr Real kPoint = 1e-12;
constexpr Real kLine = 1e-6;

}  // namespace

void CWeightStart::Reserve(size_t bodies, size_t contacts) {
  m_heights.reserve(bodies + 1);
  m_order.reserve(bodies + 1);
  m_loads.reserve(bodies + 1);
  m_starts.reserve(bodies + 2);
  m_bearers.reserve(contacts);
}

void CWeightStart::Apply(CImpulseSolver& solver, Real fall) {
  const size_t count = solver.Bodies.size();
  m_order.resize(count);
  std::iota(m_order.begin(), m_order.end(), 0);
  std::sort(m_order.begin(), m_order.end(), [this](UInt32 a, UInt32 b) {
    return m_heights[a] != m_heights[b] ? m_heights[a] > m_heights[b] : a < b;
  });
  m_loads.assign(count, {});
  ListBearers(solver);
  for (const UInt32 body : m_order) {
    if (solver.Bodies[body].InverseMass > 0.0) {
      m_loads[body].Push += fall / solver.Bodies[body].InverseMass;
      HandDown(solver, body);
    }
  }
}

template <typename USE>
void CWeightStart::ForEachBearer(const CImpulseSolver& solver, USE&& use) const {
  for (UInt32 i = 0; i < solver.Blocks.size(); ++i) {
    const CImpulseSolver::SBlock& block = solver.Blocks[i];
    const Real up = block.Directions[0].GetZ();
    const UInt32 above = up > 0.0 ? block.First : block.Second;
    const UInt32 below = up > 0.0 ? block.Second : block.First;
    const bool isLower = below == CImpulseSolver::kGround || m_heights[below] < m_heights[above];
    if (std::abs(up) < kLevel || above == CImpulseSolver::kGround || !isLower) {
      continue;
    }
    use(above, SBearer{i, below, up > 0.0 ? block.FirstArm : block.SecondArm,
                       up > 0.0 ? block.SecondArm : block.FirstArm});
  }
}

void CWeightStart::ListBearers(const CImpulseSolver& solver) {
  m_starts.assign(solver.Bodies.size() + 1, 0);
  ForEachBearer(solver, [this](UInt32 above, const SBearer&) { ++m_starts[above]; });
  // the ends of lists, which become their starts
  std::partial_sum(m_starts.begin(), m_starts.end(), m_starts.begin());
  m_bearers.resize(m_starts.back());
  ForEachBearer(solver, [this](UInt32 above, const SBearer& bearer) {
    m_bearers[--m_starts[above]] = bearer;
  });
}

// The most even impulses that balance the load: linear in the place.
void CWeightStart::HandDown(CImpulseSolver& solver, UInt32 body) {
  const auto begin = m_bearers.begin() + m_starts[body];
  const auto end = m_bearers.begin() + m_starts[body + 1];
  if (begin == end) {
    return;
  }
  const Real count = static_cast<Real>(end - begin);
  CVector3 middle;
  for (auto bearer = begin; bearer != end; ++bearer) {
    middle += bearer->Arm / count;
  }
  Real xx = kPoint;
  Real yy = kPoint;
  Real xy = 0.0;
  for (auto bearer = begin; bearer != end; ++bearer) {
    const CVector3 arm = bearer->Arm - middle;
    xx += (1.0 + kLine) * arm.GetX() * arm.GetX();
    yy += (1.0 + kLine) * arm.GetY() * arm.GetY();
    xy += arm.GetX() * arm.GetY();
  }
  const SLoad& load = m_loads[body];
  const Real x = load.MomentX - load.Push * middle.GetX();
  const Real y = load.MomentY - load.Push * middle.GetY();
  const Real scale = 1.0 / (xx * yy - xy * xy);
  const CVector3 rate(scale * (yy * x - xy * y), scale * (xx * y - xy * x), 0.0);
  const auto shareOf = [&](const SBearer& bearer) {
    return std::max(0.0, load.Push / count + rate.DotProduct(bearer.Arm - middle));
  };
  Real sum = 0.0;
  for (auto bearer = begin; bearer != end; ++bearer) {
    sum += shareOf(*bearer);
  }
  for (auto bearer = begin; bearer != end; ++bearer) {
    CImpulseSolver::SBlock& block = solver.Blocks[bearer->Block];
    const Real impulse = shareOf(*bearer) * load.Push / sum;
    block.Impulses[0] = block.Settled = impulse;
    SLoad& below = m_loads[bearer->Below];
    below.Push += impulse;
    below.MomentX += impulse * bearer->ArmBelow.GetX();
    below.MomentY += impulse * bearer->ArmBelow.GetY();
  }
}

}  // namespace argos
