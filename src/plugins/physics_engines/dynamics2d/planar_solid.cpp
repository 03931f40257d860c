#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_solid.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <algorithm>
#include <cmath>

namespace argos {

SPlanarSolid DescribeSolid(const SBodyDescription& description, const SGroundFriction& friction) {
  SPlanarSolid solid;
  AppendFootprints(description, SPlanarPose(), solid.Parts);
  const CVector3 centre = description.ComputeCentreOfMass();
  solid.CentreX = centre.GetX();
  solid.CentreY = centre.GetY();
  solid.Mass = description.Mass;
  // a described moment below that of the offset of the centre of mass is impossible
  const Real offset = solid.Mass * (solid.CentreX * solid.CentreX + solid.CentreY * solid.CentreY);
  solid.Inertia = std::max(description.GetPlanarInertia(), offset * (1.0 + 1e-3)) - offset;
  for (const SFootprint& part : solid.Parts) {
    solid.Radius =
        std::max(solid.Radius,
                 std::hypot(part.X - solid.CentreX, part.Y - solid.CentreY) + ComputeExtent(part));
  }
  solid.NarrowestHalf = ComputeNarrowestHalf(description);
  solid.Friction = friction;
  return solid;
}

}  // namespace argos
