#include "dynamics2d_beetle_model.h"

#include <argos3/plugins/simulator/entities/wheeled_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

#include "beetle_entity.h"

namespace argos {

enum BEETLE_WHEELS { BEETLE_LEFT_WHEEL = 0, BEETLE_RIGHT_WHEEL = 1 };

CDynamics2DBeetleModel::CDynamics2DBeetleModel(CDynamics2DEngine& c_engine, CBeetleEntity& c_beetle)
    : CDynamics2DSingleBodyObjectModel(c_engine, c_beetle),
      m_cBeetle(c_beetle),
      m_cWheeledEntity(m_cBeetle.GetWheeledEntity()),
      m_cDiffSteering(c_engine, BEETLE_MAX_FORCE, BEETLE_MAX_TORQUE, BEETLE_WHEEL_DISTANCE,
                      c_beetle.GetConfigurationNode()),
      m_pfWheelVelocity(m_cWheeledEntity.GetWheelVelocities()) {
  cpSpace* ptSpace = GetDynamics2DEngine().GetPhysicsSpace();
  /* the body, where the robot is */
  cpBody* ptBody = cpSpaceAddBody(
      ptSpace,
      cpBodyNew(BEETLE_MASS, cpMomentForCircle(BEETLE_MASS, 0.0f, BEETLE_RADIUS, cpvzero)));
  const CVector3& cPosition = GetEmbodiedEntity().GetOriginAnchor().Position;
  ptBody->p = cpv(cPosition.GetX(), cPosition.GetY());
  CRadians cXAngle, cYAngle, cZAngle;
  GetEmbodiedEntity().GetOriginAnchor().Orientation.ToEulerAngles(cZAngle, cYAngle, cXAngle);
  cpBodySetAngle(ptBody, cZAngle.GetValue());
  /* its shape */
  cpShape* ptShape = cpSpaceAddShape(ptSpace, cpCircleShapeNew(ptBody, BEETLE_RADIUS, cpvzero));
  ptShape->e = 0.0;
  ptShape->u = 0.7;
  ptShape->collision_type = CDynamics2DEngine::SHAPE_NORMAL;
  ptShape->layers = CDynamics2DEngine::LAYER_NORMAL;
  /* the wheels */
  m_cDiffSteering.AttachTo(ptBody);
  SetBody(ptBody, BEETLE_HEIGHT);
}

CDynamics2DBeetleModel::~CDynamics2DBeetleModel() {
  m_cDiffSteering.Detach();
  cpSpace* ptSpace = GetDynamics2DEngine().GetPhysicsSpace();
  if (m_ptTail != nullptr) {
    cpSpaceRemoveConstraint(ptSpace, m_ptTail);
    cpConstraintFree(m_ptTail);
  }
}

void CDynamics2DBeetleModel::Reset() {
  CDynamics2DSingleBodyObjectModel::Reset();
  m_cDiffSteering.Reset();
}

void CDynamics2DBeetleModel::UpdateFromEntityStatus() {
  if ((m_pfWheelVelocity[BEETLE_LEFT_WHEEL] != 0.0f) ||
      (m_pfWheelVelocity[BEETLE_RIGHT_WHEEL] != 0.0f)) {
    m_cDiffSteering.SetWheelVelocity(m_pfWheelVelocity[BEETLE_LEFT_WHEEL],
                                     m_pfWheelVelocity[BEETLE_RIGHT_WHEEL]);
  } else {
    m_cDiffSteering.Reset();
  }
}

REGISTER_STANDARD_DYNAMICS2D_OPERATIONS_ON_ENTITY(CBeetleEntity, CDynamics2DBeetleModel);

}  // namespace argos
