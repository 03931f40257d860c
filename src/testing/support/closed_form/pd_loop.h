#ifndef ARGOS3_TESTING_SUPPORT_CLOSED_FORM_PD_LOOP_H
#define ARGOS3_TESTING_SUPPORT_CLOSED_FORM_PD_LOOP_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos::testing {

/**
 * One axis of a flying body under its own controller, as the specification of the quadrotor's
 * actuators has it: substep by substep, one number after the other.
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
  Real Place = 0.0, Speed = 0.0, Thrust = 0.0, LastError = 0.0;

  /** A substep towards a place. @param substep s. */
  void StepToPlace(Real target, Real substep);
  /** A substep towards a speed: the derivative of the error is that of the substep to come. */
  void StepToSpeed(Real target, Real substep);

 private:
  void Move(Real substep);
  void Push(Real wanted);
};

/**
 * Where a body is that its loop on a place brings from 0 to 1, from rest.
 *
 * By powers of the companion matrix of the recurrence of the deviation d from the target,
 *
 *     d[k+2] = 2 d[k+1] - (1 + a + b) d[k] + b d[k-1],  a = Kp h^2 / m,  b = Kd h / m.
 *
 * @param substeps  of length h since the target changed, > 0; thrust is not limited.
 */
Real ComputeStepResponse(Real a, Real b, UInt32 substeps);

/**
 * How far a body has come, in substeps at full speed, that starts from rest and whose loop on speed
 * brings it nearer to the target by the share @p p in each substep.
 * @param substeps  since the target changed, > 0.
 */
Real ComputeWayToSpeed(Real p, UInt32 substeps);

}  // namespace argos::testing

#endif
