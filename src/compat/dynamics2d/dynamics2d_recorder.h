#ifndef ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_RECORDER_H
#define ARGOS3_COMPAT_DYNAMICS2D_DYNAMICS2D_RECORDER_H

#include <argos3/core/simulator/physics_engine/recorded_body.h>

#include <memory>

namespace argos {

class CDynamics2DEngine;

/**
 * Describes the bodies of entities for which users have registered a model for dynamics2d
 * (REGISTER_STANDARD_DYNAMICS2D_OPERATIONS_ON_ENTITY), in every engine.
 *
 * A model needs an engine of its type. In other engines, one that has no bodies stands in.
 */
class CDynamics2DRecorder : public CBodyRecorder {
 public:
  std::unique_ptr<CRecordedBody> Record(CDescribedBodyEngine& engine, CEntity& root) override;

 private:
  // made when it is necessary; models refer to it
  std::shared_ptr<CDynamics2DEngine> m_standIn;
};

}  // namespace argos

#endif
