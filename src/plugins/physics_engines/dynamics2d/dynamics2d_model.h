#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_MODEL_H

#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>

namespace argos {

class CDynamics2DEngine;
class CEntity;
class CGripperEquippedEntity;
class CTurretEntity;

/** One body of a dynamics2d engine, for the public API: its state is in the engine's arrays. */
class CDynamics2DModel : public CDescribedBodyModel {
 public:
  /** @param wheels  speeds of the left and the right wheel, m/s, if the body has a drive. */
  CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity, const Real* wheels);

  /** Takes the body, at rest, where it is now; its contacts and grips are forgotten. */
  void ConfirmMove() override;
  /** Grippers and turrets of robots. */
  void ComponentAdded(CEntity& component) override;
  void ComponentRemoved(CEntity& component) override;
  /** Of bodies that only turn about the vertical: faster than that of any orientation. */
  void CalculateBoundingBox() override;

 protected:
  /** The body is put there in the next tick, unless it is back by then where it was. */
  void Replace() override;

 private:
  friend class CDynamics2DEngine;

  CDynamics2DEngine& GetDynamics2DEngine() const;
  void SetComponent(CEntity& component, bool isThere);

  CEntity& m_root;  // of the body
  const Real* m_wheels;  // m/s, (left, right); null unless the body has a drive; not owned
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot; null if it has none
  CTurretEntity* m_turret = nullptr;  // of the robot; null if it has none
  SPlanarHandle m_handle;  // where the body is in the engine's arrays
  size_t m_number = 0;  // in the engine's list of models
  bool m_isDisplaced = false;  // is it in the engine's list of those?
};

}  // namespace argos

#endif
