#include <argos3/plugins/simulator/physics_engines/planar/proximity_filter.h>

#include <algorithm>
#include <cmath>

namespace argos {

void CProximityFilter::Reserve(size_t numDiscs) {
  m_pairs.Reserve(numDiscs);
  m_marks.reserve(numDiscs);
}

void CProximityFilter::Clear(size_t numDiscs) {
  m_pairs.Start(numDiscs);
  for (UInt32 number = 0; number < numDiscs; ++number) {
    m_pairs.LeaveOut(number);
  }
  m_marks.assign(numDiscs, Free);
}

void CProximityFilter::MarkAll(CThreadPool& pool) {
  m_pairs.Find(pool, m_margin);
  const std::vector<CDiscPairs::SDisc>& discs = m_pairs.GetDiscs();
  for (const CDiscPairs::SPart& part : m_pairs.GetParts()) {
    for (const CDiscPairs::SPair& pair : part.Pairs) {
      const CDiscPairs::SDisc& a = discs[pair.A];
      const CDiscPairs::SDisc& b = discs[pair.B];
      const Real dx = b.X - a.X;
      const Real dy = b.Y - a.Y;
      const Real distance = std::sqrt(dx * dx + dy * dy);
      Raise(a.Number, distance, a.Radius + b.Radius);
      Raise(b.Number, distance, a.Radius + b.Radius);
    }
    for (const CDiscPairs::SObstaclePair& pair : part.ObstaclePairs) {
      const CDiscPairs::SDisc& disc = discs[pair.Disc];
      Raise(disc.Number, ComputeDistance(m_pairs.GetObstacle(pair.Obstacle), disc.X, disc.Y),
            disc.Radius);
    }
  }
}

void CProximityFilter::MarkNear(Real x, Real y, Real reach, std::vector<UInt32>* met) {
  m_pairs.ForNear(x, y, reach, [&](UInt32 place) {
    const CDiscPairs::SDisc& disc = m_pairs.GetDiscs()[place];
    const Real dx = disc.X - x;
    const Real dy = disc.Y - y;
    const Real distance = std::sqrt(dx * dx + dy * dy);
    Raise(disc.Number, distance, reach + disc.Radius);
    if (met != nullptr && distance <= reach + disc.Radius) {
      met->push_back(disc.Number);
    }
  });
}

void CProximityFilter::Raise(UInt32 number, Real distance, Real reach) {
  if (distance <= reach) {
    m_marks[number] = Active;
  } else if (distance <= reach + m_margin) {
    m_marks[number] = std::max<UInt8>(m_marks[number], Guarded);
  }
}

}  // namespace argos
