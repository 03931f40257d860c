#ifndef ARGOS3_COMPAT_DYNAMICS2D_RECORDED_BODIES_H
#define ARGOS3_COMPAT_DYNAMICS2D_RECORDED_BODIES_H

#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/non_copyable.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

/*
 * What users' models of bodies for dynamics2d call: the types, functions and fields of the physics
 * library of ARGoS 3, Chipmunk 6, that such models use.
 *
 * Nothing here computes motion. The calls record bodies and shapes; when a model is added to an
 * engine, the record becomes the body's SBodyDescription. What a description cannot express is
 * refused: such a function throws CARGoSException.
 *
 * Lengths are in m, masses in kg, angles in rad.
 */

namespace argos {
class CDynamics2DGrippable;
class CDynamics2DGripper;
class CDynamics2DVelocityControl;
}  // namespace argos

// NOLINTBEGIN(readability-identifier-naming): names of that library

using cpFloat = argos::Real;
using cpDataPointer = void*;
using cpBool = int;
using cpCollisionType = std::uintptr_t;
using cpGroup = std::uintptr_t;
using cpLayers = unsigned int;

constexpr cpGroup CP_NO_GROUP = 0;
constexpr cpLayers CP_ALL_LAYERS = ~0U;

struct cpVect {
  cpFloat x, y;
};

constexpr cpVect cpvzero = {0.0, 0.0};

inline cpVect cpv(cpFloat x, cpFloat y) {
  return {x, y};
}

/** Bodies and shapes that are added to it exist in the engine. */
struct cpSpace {};

struct cpBody;

/** A solid of a body. Elasticity and friction are accepted; engines have coefficients of their own.
 */
struct cpShape {
  enum class EKind { Circle, Box, Polygon };

  cpBody* body = nullptr;
  cpFloat e = 0.0; /**< elasticity */
  cpFloat u = 0.0; /**< friction */
  cpBool sensor = 0; /**< only for the shape of a gripper */
  cpCollisionType collision_type =
      0; /**< ignored: a gripper or a grippable is found by its object */
  cpGroup group = CP_NO_GROUP; /**< ignored */
  cpLayers layers = CP_ALL_LAYERS; /**< ignored */
  cpDataPointer data = nullptr;

  // the record
  EKind Kind = EKind::Circle;
  bool IsInSpace = false;
  cpVect Offset = cpvzero; /**< of a circle's centre */
  cpFloat Radius = 0.0; /**< of a circle */
  cpVect Size = cpvzero; /**< of a box around the origin of the body */
  std::vector<argos::CVector2> Vertices; /**< of a polygon, frame of the body */
  argos::CDynamics2DGripper* Gripper = nullptr;
  argos::CDynamics2DGrippable* Grippable = nullptr;
};

/** A rigid body. Its pose and velocity are as of the last tick. */
struct cpBody {
  cpVect p = cpvzero; /**< position, world frame */
  cpFloat a = 0.0; /**< angle */
  cpVect rot = {1.0, 0.0}; /**< cosine and sine of the angle */
  cpVect v = cpvzero; /**< m/s, world frame */
  cpFloat w = 0.0; /**< rad/s */
  cpFloat m = 0.0; /**< mass */
  cpFloat i = 0.0; /**< moment of inertia about the origin, kg m^2 */
  cpDataPointer data = nullptr;

  // the record
  bool IsStatic = false;
  bool IsInSpace = false;
  argos::CDynamics2DVelocityControl* Control = nullptr; /**< that is attached now */
  bool IsDescribed = false; /**< true: no shape or control may be added */
  argos::CDynamics2DVelocityControl* Drive = nullptr; /**< the control that was described */
  std::vector<std::unique_ptr<cpShape>> Shapes;
};

/** A motor between two bodies, of a control; others are refused. */
struct cpConstraint {
  cpBody* a = nullptr;
  cpBody* b = nullptr;
  cpFloat maxForce = std::numeric_limits<cpFloat>::infinity(); /**< N, or N m */
  cpFloat errorBias = 0.0; /**< ignored */
  cpFloat maxBias = 0.0; /**< ignored */
  cpDataPointer data = nullptr;
};

/** A pair of shapes that touch. Engines do not report them to users' models. */
struct cpArbiter;

/**
 * New bodies and shapes belong to the model that is being constructed.
 * @throws CARGoSException at other times, or if a mass or moment is not > 0.
 */
cpBody* cpBodyNew(cpFloat mass, cpFloat moment);
/** A body that does not move, for immovable entities. */
cpBody* cpBodyNewStatic();
void cpBodySetAngle(cpBody* body, cpFloat angle);
cpBody* cpSpaceAddBody(cpSpace* space, cpBody* body);
cpShape* cpSpaceAddShape(cpSpace* space, cpShape* shape);
cpShape* cpSpaceAddStaticShape(cpSpace* space, cpShape* shape);

/** Take back what was added, in the constructor of a model; later they have no effect. */
void cpSpaceRemoveBody(cpSpace* space, cpBody* body);
void cpSpaceRemoveShape(cpSpace* space, cpShape* shape);
void cpSpaceRemoveStaticShape(cpSpace* space, cpShape* shape);

/** For destructors of models, without effect: the engine owns bodies and shapes. */
inline void cpBodyFree(cpBody* /*body*/) {}
inline void cpShapeFree(cpShape* /*shape*/) {}
/** The same for constraints, of which there are none but those of controls. */
inline void cpSpaceRemoveConstraint(cpSpace* /*space*/, cpConstraint* /*constraint*/) {}
inline void cpConstraintFree(cpConstraint* /*constraint*/) {}

inline void cpShapeSetElasticity(cpShape* shape, cpFloat elasticity) {
  shape->e = elasticity;
}
inline void cpShapeSetFriction(cpShape* shape, cpFloat friction) {
  shape->u = friction;
}
inline void cpShapeSetSensor(cpShape* shape, cpBool sensor) {
  shape->sensor = sensor;
}
inline void cpShapeSetCollisionType(cpShape* shape, cpCollisionType type) {
  shape->collision_type = type;
}
inline void cpShapeSetGroup(cpShape* shape, cpGroup group) {
  shape->group = group;
}
inline void cpShapeSetLayers(cpShape* shape, cpLayers layers) {
  shape->layers = layers;
}
inline void cpShapeSetUserData(cpShape* shape, cpDataPointer data) {
  shape->data = data;
}

/** Moments about the origin of the body, kg m^2. */
cpFloat cpMomentForCircle(cpFloat mass, cpFloat innerRadius, cpFloat outerRadius, cpVect offset);
cpFloat cpMomentForBox(cpFloat mass, cpFloat width, cpFloat height);
cpFloat cpMomentForPoly(cpFloat mass, int count, const cpVect* vertices, cpVect offset);

/** @throws CARGoSException if a size is not > 0, or a polygon has no area. */
cpShape* cpCircleShapeNew(cpBody* body, cpFloat radius, cpVect offset);
cpShape* cpBoxShapeNew(cpBody* body, cpFloat width, cpFloat height);
cpShape* cpPolyShapeNew(cpBody* body, int count, const cpVect* vertices, cpVect offset);

namespace argos::detail {
/** @throws CARGoSException that names the call. */
[[noreturn]] void RefuseCall(const char* function);
}  // namespace argos::detail

// functions that cannot be recorded
#define ARGOS_REFUSED_CALL(RESULT, FUNCTION)          \
  template <typename... ARGUMENTS>                    \
  [[noreturn]] RESULT FUNCTION(const ARGUMENTS&...) { \
    ::argos::detail::RefuseCall(#FUNCTION);           \
  }

ARGOS_REFUSED_CALL(cpConstraint*, cpDampedRotarySpringNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpDampedSpringNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpGearJointNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpGrooveJointNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpPinJointNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpPivotJointNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpPivotJointNew2)
ARGOS_REFUSED_CALL(cpConstraint*, cpRatchetJointNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpRotaryLimitJointNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpSimpleMotorNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpSlideJointNew)
ARGOS_REFUSED_CALL(cpConstraint*, cpSpaceAddConstraint)
ARGOS_REFUSED_CALL(cpShape*, cpSegmentShapeNew)
ARGOS_REFUSED_CALL(void, cpBodyApplyForce)
ARGOS_REFUSED_CALL(void, cpBodyApplyImpulse)
ARGOS_REFUSED_CALL(void, cpSpaceAddCollisionHandler)

#undef ARGOS_REFUSED_CALL

// NOLINTEND(readability-identifier-naming)

namespace argos {

/**
 * Owns the bodies that one model records. While a scope exists, new bodies of its thread belong to
 * its recording.
 */
class CBodyRecording {
 public:
  class CScope : private CNonCopyable {
   public:
    explicit CScope(CBodyRecording& recording);
    ~CScope();

   private:
    CBodyRecording* m_previous;
  };

  cpBody& AddBody();

 private:
  std::vector<std::unique_ptr<cpBody>> m_bodies;
};

}  // namespace argos

#endif
