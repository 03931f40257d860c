#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <cmath>

namespace argos {

void CPlanarGhosts::Place(CDiscPairs& discPairs, CCrowd& crowd, Real reach, Real longestPath) {
  for (const SGhostDisc& ghost : m_ghosts) {
    m_nearGhost.clear();
    discPairs.ForNear(ghost.X, ghost.Y, ghost.Radius + reach,
                      [this](UInt32 place) { m_nearGhost.push_back(place); });
    for (const UInt32 place : m_nearGhost) {
      PlaceLine(ghost, place, discPairs, crowd);
    }
    PlaceForSolids(ghost, crowd.GetSolids(), reach, longestPath);
  }
}

// A robot that is no disc stays on its side of a face. Objects touch the ghost.
void CPlanarGhosts::PlaceForSolids(const SGhostDisc& ghost, CCrowdSolids& solids, Real reach,
                                   Real longestPath) {
  m_nearGhost.clear();
  solids.ForNear(ghost.X, ghost.Y, ghost.Radius,
                 [this](UInt32 item) { m_nearGhost.push_back(item); });
  for (const UInt32 item : m_nearGhost) {
    const CCrowdSolids::SSolid& solid = solids.GetSolid(item);
    if (solid.Kind == EPlanarKind::Passive) {
      SFootprint disc = {ghost.X, ghost.Y, 1.0, 0.0, 0.0, 0.0, ghost.Radius};
      solids.AddObstacle(item, disc, kSolidReach * reach);
      continue;
    }
    const SDrivenBody& body = m_store.GetDriven()[solid.Slot];
    if (std::hypot(body.Pose.X - ghost.X, body.Pose.Y - ghost.Y) >
        ghost.Radius + body.BoundingRadius + 2.0 * kSolidReach * reach) {
      continue;
    }
    if (const std::optional<SFootprint> face = MakeFace(ghost, body, longestPath)) {
      solids.AddObstacle(item, *face, kSolidReach * reach);
    }
  }
}

// half-way between the ghost and the robot, across the line between their centres
void CPlanarGhosts::PlaceLine(const SGhostDisc& ghost, UInt32 place, CDiscPairs& discPairs,
                              CCrowd& crowd) {
  const CDiscPairs::SDisc& disc = discPairs.GetDiscs()[place];
  const Real dx = ghost.X - disc.X;
  const Real dy = ghost.Y - disc.Y;
  const Real distance = std::hypot(dx, dy);
  if (!(distance > 0.0)) {
    return;
  }
  const Real gap = distance - ghost.Radius - disc.Radius;
  const Real share = (disc.Radius + 0.5 * gap) / distance;
  crowd.AddLine(discPairs, place,
                {dx / distance, dy / distance, disc.X + share * dx, disc.Y + share * dy});
}

// A square whose side is half-way between the ghost and the circle around the robot, across the
// line between their centres; none if they have one centre.
std::optional<SFootprint> CPlanarGhosts::MakeFace(const SGhostDisc& ghost, const SDrivenBody& body,
                                                  Real longestPath) {
  const Real dx = body.Pose.X - ghost.X;
  const Real dy = body.Pose.Y - ghost.Y;
  const Real distance = std::hypot(dx, dy);
  if (!(distance > 0.0)) {
    return std::nullopt;
  }
  const Real gap = distance - ghost.Radius - body.BoundingRadius;
  // so large that no path of the robot leads around it or through it
  const Real half = ghost.Radius + 2.0 * body.BoundingRadius + 2.0 * longestPath;
  const Real toCentre = (ghost.Radius + 0.5 * gap - half) / distance;
  return SFootprint{ghost.X + dx * toCentre,
                    ghost.Y + dy * toCentre,
                    dx / distance,
                    dy / distance,
                    half,
                    half,
                    0.0};
}

}  // namespace argos
