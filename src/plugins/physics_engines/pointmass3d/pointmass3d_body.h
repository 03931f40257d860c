#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_BODY_H

#include <argos3/plugins/simulator/physics_engines/pointmass3d/point_mass_handle.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/robot_body_model.h>

namespace argos {

class CPointMass3DEngine;

/** One body built from its description; its state of motion is in the engine's arrays. */
class CPointMass3DBody final : public CRobotBodyModel {
 public:
  /** What moves it; each kind has its own arrays. */
  enum class EKind : UInt8 { Still, Driver, Flyer };

  CPointMass3DBody(CPointMass3DEngine& engine, CEmbodiedEntity& entity, EKind kind,
                   const CDriveSource& drive);

 protected:
  /** Does nothing: the engine reads the turret in every tick, and has no grips. */
  void ManipulatorChanged() override {}

 private:
  friend class CPointMass3DEngine;

  EKind m_kind;
  SPointMassHandle m_handle;  // in the arrays of its kind; unused if it is still
};

}  // namespace argos

#endif
