#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solids.h>

#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <algorithm>
#include <cmath>

namespace argos {

void CCrowdSolids::Reserve(size_t solids, size_t pairs) {
  m_solids.reserve(solids);
  m_parts.reserve(2 * solids);
  m_solidOf.reserve(2 * solids);
  m_pairs.reserve(pairs);
  m_obstaclePairs.reserve(pairs);
  m_obstacles.reserve(solids);
  m_found.reserve(std::max<size_t>(256, solids));
}

void CCrowdSolids::Find(const CPlanarStore& store, CDiscPairs& discPairs, Real discReach,
                        Real solidReach) {
  m_numDiscs = static_cast<UInt32>(discPairs.GetDiscs().size());
  m_pairs.clear();
  m_obstaclePairs.clear();
  m_obstacles.clear();
  m_period = store.GetSettings().Period;
  List(store);
  if (m_solids.empty()) {
    m_cells.Clear();
    return;
  }
  SPlanarArea area = SPlanarArea::Empty();
  Real sum = 0.0;
  for (const SSolid& solid : m_solids) {
    area.Include(solid.X, solid.Y);
    sum += solid.Shape->Radius;
  }
  m_grid.Cover(area, 2.0 * (sum / static_cast<Real>(m_solids.size()) + solidReach),
               CFramedGrid::AimedCells(m_solids.size()));
  m_cells.List(m_grid, m_parts, 2.0 * solidReach);
  for (UInt32 solid = 0; solid < m_solids.size(); ++solid) {
    PairWithDiscs(solid, discPairs, discReach, solidReach);
    PairWithSolids(solid, solidReach);
    PairWithObstacles(solid, discPairs, solidReach);
  }
  m_pairs.insert(m_pairs.end(), m_obstaclePairs.begin(), m_obstaclePairs.end());
}

void CCrowdSolids::List(const CPlanarStore& store) {
  m_solids.clear();
  m_parts.clear();
  m_solidOf.clear();
  m_numPassive = store.GetPassive().size();
  for (UInt32 slot = 0; slot < store.GetPassive().size(); ++slot) {
    const SPassiveBody& body = store.GetPassive()[slot];
    const bool isAwake =
        body.IsFresh || body.Velocity.X != 0.0 || body.Velocity.Y != 0.0 || body.Velocity.W != 0.0;
    Add(EPlanarKind::Passive, slot, body.Solid, body.Pose, isAwake);
  }
  for (const UInt32 slot : store.GetDrivenSolids()) {
    const SDrivenBody& body = store.GetDriven()[slot];
    Add(EPlanarKind::Driven, slot, *body.Solid, body.Pose, true);
  }
}

UInt32 CCrowdSolids::GetItem(EPlanarKind kind, UInt32 slot) const {
  if (kind == EPlanarKind::Passive) {
    return m_numDiscs + slot;
  }
  const auto found = std::lower_bound(
      m_solids.begin() + static_cast<std::ptrdiff_t>(m_numPassive), m_solids.end(), slot,
      [](const SSolid& solid, UInt32 wanted) { return solid.Slot < wanted; });
  return m_numDiscs + static_cast<UInt32>(found - m_solids.begin());
}

void CCrowdSolids::Add(EPlanarKind kind, UInt32 slot, const SPlanarSolid& shape,
                       const SPlanarPose& pose, bool isAwake) {
  SSolid& solid = m_solids.emplace_back();
  solid.Kind = kind;
  solid.Slot = slot;
  solid.Shape = &shape;
  solid.Cos = pose.HalfCos * pose.HalfCos - pose.HalfSin * pose.HalfSin;
  solid.Sin = 2.0 * pose.HalfSin * pose.HalfCos;
  solid.X = pose.X + solid.Cos * shape.CentreX - solid.Sin * shape.CentreY;
  solid.Y = pose.Y + solid.Sin * shape.CentreX + solid.Cos * shape.CentreY;
  solid.FirstPart = static_cast<UInt32>(m_parts.size());
  solid.IsAwake = isAwake;
  for (const SFootprint& part : shape.Parts) {
    m_parts.push_back(PlaceFootprint(part, pose.X, pose.Y, solid.Cos, solid.Sin));
    m_solidOf.push_back(static_cast<UInt32>(m_solids.size() - 1));
  }
}

void CCrowdSolids::PairWithDiscs(UInt32 number, CDiscPairs& discPairs, Real discReach,
                                 Real solidReach) {
  const SSolid& solid = m_solids[number];
  const size_t numParts = solid.Shape->Parts.size();
  discPairs.ForNear(solid.X, solid.Y, solid.Shape->Radius + solidReach, [&](UInt32 place) {
    const CDiscPairs::SDisc& disc = discPairs.GetDiscs()[place];
    const Real near = disc.Radius + discReach + solidReach;
    const SPlanarVector image = FindNearestImage(m_period, disc.X, disc.Y, solid.X, solid.Y);
    for (UInt32 part = solid.FirstPart; part < solid.FirstPart + numParts; ++part) {
      if (ComputeDistance(m_parts[part], disc.X + image.X, disc.Y + image.Y) <= near) {
        m_pairs.push_back({place, m_numDiscs + number, kNone, part});
        discPairs.SetNear(place);
      }
    }
  });
}

// Lists the parts in a circle, of all images of solids.
void CCrowdSolids::FindPartsNear(Real x, Real y, Real radius) {
  // parts are listed farther than they are
  m_cells.FindImages(m_grid, m_period, x, y, radius, 2.0 * radius, m_found);
}

// Each pair once.
void CCrowdSolids::PairWithSolids(UInt32 number, Real solidReach) {
  const SSolid& solid = m_solids[number];
  FindPartsNear(solid.X, solid.Y, solid.Shape->Radius);
  for (const UInt32 otherPart : m_found) {
    const UInt32 other = m_solidOf[otherPart];
    if (other <= number) {
      continue;
    }
    const SSolid& partner = m_solids[other];
    const Real near = solid.Shape->Radius + partner.Shape->Radius + 2.0 * solidReach;
    const Real dx = m_period.X.Shorten(partner.X - solid.X);
    const Real dy = m_period.Y.Shorten(partner.Y - solid.Y);
    if (dx * dx + dy * dy > near * near) {
      continue;
    }
    const SPlanarVector image = FindNearestImage(m_period, partner.X, partner.Y, solid.X, solid.Y);
    const SFootprint otherPlace = Displace(m_parts[otherPart], image.X, image.Y);
    for (UInt32 part = solid.FirstPart; part < solid.FirstPart + solid.Shape->Parts.size();
         ++part) {
      if (ComputeGap(m_parts[part], otherPlace) <= 2.0 * solidReach) {
        m_pairs.push_back({m_numDiscs + number, m_numDiscs + other, part, otherPart});
      }
    }
  }
}

void CCrowdSolids::PairWithObstacles(UInt32 number, const CDiscPairs& discPairs, Real solidReach) {
  const SSolid& solid = m_solids[number];
  discPairs.FindObstaclesNear(solid.X, solid.Y, solid.Shape->Radius + solidReach, m_found);
  for (const UInt32 obstacle : m_found) {
    for (UInt32 part = solid.FirstPart; part < solid.FirstPart + solid.Shape->Parts.size();
         ++part) {
      if (ComputeGap(m_parts[part], discPairs.GetObstacle(obstacle)) <= solidReach) {
        m_obstaclePairs.push_back({m_numDiscs + number, kNone, part, obstacle});
      }
    }
  }
}

void CCrowdSolids::AddObstacle(UInt32 item, const SFootprint& obstacle, Real reach) {
  const UInt32 number = kFirstOfTick + static_cast<UInt32>(m_obstacles.size());
  m_obstacles.push_back(obstacle);
  SSolid& solid = m_solids[item - m_numDiscs];
  for (UInt32 part = solid.FirstPart; part < solid.FirstPart + solid.Shape->Parts.size(); ++part) {
    const Real gap = ComputeGap(m_parts[part], obstacle);
    if (gap <= reach) {
      m_pairs.push_back({item, kNone, part, number});
      // nothing else wakes a body that a robot of another engine has entered
      solid.IsAwake = solid.IsAwake || gap < 0.0;
    }
  }
}

}  // namespace argos
