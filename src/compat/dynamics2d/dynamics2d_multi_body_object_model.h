#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_MULTI_BODY_OBJECT_MODEL_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_MULTI_BODY_OBJECT_MODEL_H

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

#include <vector>

namespace argos {

/**
 * A user's model that has several bodies.
 *
 * They are rigidly joined, at the offsets at which they were added; one control may be attached, to
 * a body at the origin.
 */
class CDynamics2DMultiBodyObjectModel : public CDynamics2DModel {
 public:
  struct SBody {
    cpBody* Body;
    cpVect OffsetPos; /**< m, in the frame of the origin anchor */
    cpFloat OffsetOrient; /**< rad */
    Real Height; /**< m */

    SBody(cpBody* body, const cpVect& offsetPos, cpFloat offsetOrient, Real height)
        : Body(body), OffsetPos(offsetPos), OffsetOrient(offsetOrient), Height(height) {}
    operator cpBody*() const { return Body; }
    cpBody* operator->() const { return Body; }
  };

  /** @throws CARGoSException if the entity has no component "body". */
  CDynamics2DMultiBodyObjectModel(CDynamics2DEngine& engine, CComposableEntity& entity);

  CComposableEntity& GetComposableEntity() { return m_cEntity; }
  const CComposableEntity& GetComposableEntity() const { return m_cEntity; }

  void Reset() override;

  /** @throws std::out_of_range */
  SBody& GetBody(size_t index) { return m_vecBodies.at(index); }
  const SBody& GetBody(size_t index) const { return m_vecBodies.at(index); }
  size_t GetNumBodies() const { return m_vecBodies.size(); }
  /** In the constructor of the derived class. */
  virtual void AddBody(cpBody* body, const cpVect& offsetPos, cpFloat offsetOrient, Real height);

 protected:
  CComposableEntity& m_cEntity;
  std::vector<SBody> m_vecBodies;
};

}  // namespace argos

#endif
