#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_SINGLE_BODY_OBJECT_MODEL_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_SINGLE_BODY_OBJECT_MODEL_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

namespace argos {

/** A user's model that has one body, at the origin anchor. */
class CDynamics2DSingleBodyObjectModel : public CDynamics2DModel {
 public:
  /** @throws CARGoSException if the entity has no component "body". */
  CDynamics2DSingleBodyObjectModel(CDynamics2DEngine& engine, CComposableEntity& entity);

  CComposableEntity& GetComposableEntity() { return m_cEntity; }
  const CComposableEntity& GetComposableEntity() const { return m_cEntity; }

  void Reset() override;

  /** Null before SetBody(). */
  cpBody* GetBody() { return m_ptBody; }
  const cpBody* GetBody() const { return m_ptBody; }
  /**
   * Once, in the constructor of the derived class.
   * @param height  m, > 0. @throws CARGoSException if it was called before.
   */
  virtual void SetBody(cpBody* body, Real height);

 protected:
  CComposableEntity& m_cEntity;
  cpBody* m_ptBody = nullptr;
};

}  // namespace argos

#endif
