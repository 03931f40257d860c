#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_MODEL_H

#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_body_model.h>

namespace argos {

class CPlanarEngine;

/**
 * One body of a 2D engine, for the public API: the common part of these engines' models.
 *
 * The state of motion is in the arrays of the engine.
 */
class CPlanarModel : public CRobotBodyModel {
 public:
  CPlanarModel(CPlanarEngine& engine, CEmbodiedEntity& entity, const CDriveSource& drive);

  /** For bodies that only turn about the vertical: faster than for any orientation. */
  void CalculateBoundingBox() override;
  /** On the plane of the engine, upright. */
  SBodyPose FindPossiblePose(const SBodyPose& pose) const override;

 protected:
  void ManipulatorChanged() override;
};

}  // namespace argos

#endif
