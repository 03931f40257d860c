#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <cmath>

namespace argos {

namespace {

// m; tolerance for the height of robots of other engines, which may penetrate their floor slightly
constexpr Real kGhostTolerance = 0.01;

}  // namespace

void ListGhostDiscs(const CPhysicsEngine& engine, Real elevation, std::vector<SGhostDisc>& discs) {
  discs.clear();
  for (const SGhost& ghost : engine.GetGhosts()) {
    const SBodyDescription& description = *ghost.Body->GetBodyDescription();
    if (description.HasDrive() && std::abs(ghost.Position.GetZ() - elevation) <= kGhostTolerance) {
      discs.push_back(
          {ghost.Position.GetX(), ghost.Position.GetY(), description.ComputeBoundingRadius()});
    }
  }
}

}  // namespace argos
