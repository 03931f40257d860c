#ifndef ARGOS3_TESTING_SUPPORT_CLOSED_FORM_PD_LOOP_H
#define ARGOS3_TESTING_SUPPORT_CLOSED_FORM_PD_LOOP_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos::testing {

/**
 * One axis of a flying body with its controller, as specified for the actuators of the quadrotor: a
 * scalar loop over substeps, each of constant thrust.
 */
struct SPDLoop {
  // the body
  Real Inertia = 1.0;  // kg or kg m^2
  Real Proportional = 0.0, Derivative = 0.0;  // of the loop in use
  Real MaxThrust = 1000.0;  // N or N m
  Real Weight = 0.0;  // N, along the axis
  bool IsAngle = false;
  Real Lowest = -std::numeric_limits<Real>::infinity();  // m
  Real Highest = std::numeric_limits<Real>::infinity();  // m
  // its state
  Real Place = 0.0, Speed = 0.0;

  /** A substep of the position loop. @param substep s. */
  void StepToPlace(Real target, Real substep);
  /** A substep of the speed loop. */
  void StepToSpeed(Real target, Real substep);

 private:
  Real ComputePlaceError(Real target, Real place) const;
  template <typename CONTROL>
  void Step(Real substep, CONTROL&& control);
};

/**
 * Position of a body that its position loop moves from 0 to 1, starting from rest.
 *
 * Computed by powers of the matrix of the midpoint rule for d'' = -(Kp d + Kd d') / m.
 *
 * @param a, b      Kp h^2 / m and Kd h / m.
 * @param substeps  of length h since the change of the target, > 0; thrust is not limited.
 */
Real ComputeStepResponse(Real a, Real b, UInt32 substeps);

/**
 * Path of a body, in units of a substep at full speed, that starts from rest and whose speed loop
 * reduces the error at the rate @p p per substep, by the midpoint rule.
 * @param substeps  since the change of the target, > 0.
 */
Real ComputeWayToSpeed(Real p, UInt32 substeps);

/** The same as ComputeStepResponse() in continuous time. @param time s, since the step. */
Real ComputeContinuousResponse(const SPDLoop& loop, Real time);
/** Path after a step of the ordered speed from 0 to 1 in continuous time. @param time s. */
Real ComputeContinuousWay(const SPDLoop& loop, Real time);

}  // namespace argos::testing

#endif
