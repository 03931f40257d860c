#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_MODEL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_PLANAR_MODEL_H

#include <argos3/core/simulator/physics_engine/described_body_model.h>

namespace argos {

class CEntity;
class CGripperEquippedEntity;
class CPlanarEngine;
class CTurretEntity;

/**
 * One body of an engine on a plane, for the public API: what those of all such engines know.
 *
 * The state that moves is in the arrays of the engine.
 */
class CPlanarModel : public CDescribedBodyModel {
 public:
  /** @param wheels  speeds of the left and the right wheel, m/s, if the body has a drive. */
  CPlanarModel(CPlanarEngine& engine, CEmbodiedEntity& entity, const Real* wheels);

  /** Grippers and turrets of robots. */
  void ComponentAdded(CEntity& component) override;
  void ComponentRemoved(CEntity& component) override;
  /** Of bodies that only turn about the vertical: faster than that of any orientation. */
  void CalculateBoundingBox() override;

 protected:
  CEntity& m_root;  // of the body
  const Real* m_wheels;  // m/s, (left, right); null unless the body has a drive; not owned
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot; null if it has none
  CTurretEntity* m_turret = nullptr;  // of the robot; null if it has none

 private:
  friend class CPlanarEngine;

  void SetComponent(CEntity& component, bool isThere);

  size_t m_number = 0;  // in the engine's list of models
};

}  // namespace argos

#endif
