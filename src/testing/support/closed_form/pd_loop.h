#ifndef ARGOS3_TESTING_SUPPORT_CLOSED_FORM_PD_LOOP_H
#define ARGOS3_TESTING_SUPPORT_CLOSED_FORM_PD_LOOP_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos::testing {

/**
 * One axis of a flying body with its controller, as specified for the actuators of the quadrotor: a
 * scalar loop over substeps.
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

  /** A substep of the position loop. @param substep s. */
  void StepToPlace(Real target, Real substep);
  /** A substep of the speed loop: the derivative of the error is that of the coming substep. */
  void StepToSpeed(Real target, Real substep);

 private:
  void Move(Real substep);
  void Push(Real wanted);
};

/**
 * Position of a body that its position loop moves from 0 to 1, starting from rest.
 *
 * Computed by powers of the companion matrix of the recurrence of the deviation d from the target,
 *
 *     d[k+2] = 2 d[k+1] - (1 + a + b) d[k] + b d[k-1],  a = Kp h^2 / m,  b = Kd h / m.
 *
 * @param substeps  of length h since the change of the target, > 0; thrust is not limited.
 */
Real ComputeStepResponse(Real a, Real b, UInt32 substeps);

/**
 * Path of a body, in units of a substep at full speed, that starts from rest and whose speed loop
 * reduces the error by the share @p p in each substep.
 * @param substeps  since the change of the target, > 0.
 */
Real ComputeWayToSpeed(Real p, UInt32 substeps);

}  // namespace argos::testing

#endif
