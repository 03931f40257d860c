#ifndef DYNAMICS2D_BEETLE_MODEL_H
#define DYNAMICS2D_BEETLE_MODEL_H

namespace argos {
class CBeetleEntity;
class CWheeledEntity;
class CDynamics2DBeetleModel;
}  // namespace argos

#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_differentialsteering_control.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_single_body_object_model.h>

namespace argos {

class CDynamics2DBeetleModel : public CDynamics2DSingleBodyObjectModel {
 public:
  CDynamics2DBeetleModel(CDynamics2DEngine& c_engine, CBeetleEntity& c_beetle);
  virtual ~CDynamics2DBeetleModel();

  virtual void Reset();
  virtual void UpdateFromEntityStatus();

 private:
  CBeetleEntity& m_cBeetle;
  CWheeledEntity& m_cWheeledEntity;

  CDynamics2DDifferentialSteeringControl m_cDiffSteering;
  /* in place of a part that not every beetle has */
  cpConstraint* m_ptTail = nullptr;

  /* left and right, m/s */
  const Real* m_pfWheelVelocity;
};

}  // namespace argos

#endif
