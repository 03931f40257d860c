#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_BOX_MODEL_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_BOX_MODEL_H

#include <argos3/plugins/simulator/entities/box_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_stretchable_object_model.h>

namespace argos {

/** A box as a user's model: for models that derive from it. Engines do not need it. */
class CDynamics2DBoxModel : public CDynamics2DStretchableObjectModel {
 public:
  CDynamics2DBoxModel(CDynamics2DEngine& engine, CBoxEntity& entity);
};

}  // namespace argos

#endif
