#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_BODY_H

#include <argos3/core/simulator/physics_engine/described_body_model.h>

namespace argos {

class CEntity;
class CPointMass3DEngine;
class CTurretEntity;

/** m; no body may be farther from the world's origin: positions are good to 1e-7 m there. */
constexpr Real kFarthest = 1e9;

/** One body built from its description; its state is in the engine's arrays. */
class CPointMass3DBody final : public CDescribedBodyModel {
 public:
  /** What moves it; each kind has its own arrays. */
  enum class EKind : UInt8 { Still, Driver, Flyer };

  CPointMass3DBody(CPointMass3DEngine& engine, CEmbodiedEntity& entity, EKind kind);

  /** Turrets of robots. */
  void ComponentAdded(CEntity& component) override;
  void ComponentRemoved(CEntity& component) override;

 protected:
  void Replace() override;

 private:
  friend class CPointMass3DEngine;

  CEntity& m_root;  // of the body
  CTurretEntity* m_turret = nullptr;  // of the robot; null if it has none
  EKind m_kind;
  UInt32 m_slot = 0;  // in the arrays of its kind; unused if it is still
  size_t m_number = 0;  // in the engine's list of bodies
};

}  // namespace argos

#endif
