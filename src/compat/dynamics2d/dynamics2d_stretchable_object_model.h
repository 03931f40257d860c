#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_STRETCHABLE_OBJECT_MODEL_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_STRETCHABLE_OBJECT_MODEL_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_gripping.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_single_body_object_model.h>

#include <memory>
#include <optional>

namespace argos {

/** A user's model of an object that can be pushed, against friction with the ground. */
class CDynamics2DStretchableObjectModel : public CDynamics2DSingleBodyObjectModel {
 public:
  using CDynamics2DSingleBodyObjectModel::CDynamics2DSingleBodyObjectModel;

  void UpdateFromEntityStatus() override {}

  /** kg; 0, the default: that of the body. */
  Real GetMass() const { return m_fMass; }
  void SetMass(Real mass) { m_fMass = mass; }
  /** Null if grippers cannot hold the object. */
  CDynamics2DGrippable* GetGrippable() { return m_grippable.get(); }
  const CDynamics2DGrippable* GetGrippable() const { return m_grippable.get(); }
  /** Takes ownership. */
  void SetGrippable(CDynamics2DGrippable* grippable) { m_grippable.reset(grippable); }
  /**
   * Friction with the ground, in engines with friction of their own. In the constructor of the
   * derived class.
   * @param maxBias   ignored.
   * @param maxForce  N, >= 0.
   */
  void SetLinearFriction(Real maxBias, Real maxForce);
  /** @param maxBias ignored. @param maxForce N m, >= 0. */
  void SetAngularFriction(Real maxBias, Real maxForce);

 protected:
  Real m_fMass = 0.0;

 private:
  void Describe(SBodyDescription& description) const override;

  std::unique_ptr<CDynamics2DGrippable> m_grippable;
  std::optional<Real> m_friction;  // N
  std::optional<Real> m_angularFriction;  // N m
};

}  // namespace argos

#endif
