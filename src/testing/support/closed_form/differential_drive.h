#ifndef ARGOS3_TESTING_SUPPORT_CLOSED_FORM_DIFFERENTIAL_DRIVE_H
#define ARGOS3_TESTING_SUPPORT_CLOSED_FORM_DIFFERENTIAL_DRIVE_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos::testing {

/** A pose on the plane, world frame. */
struct SPose {
  Real X = 0.0, Y = 0.0;  // m
  Real Yaw = 0.0;  // rad
};

/**
 * Pose of a differential-drive robot after a time with constant wheel speeds and
 * wheels that roll without slipping.
 *
 * @param start               pose at the beginning; the origin is midway between the wheels.
 * @param left, right         ground speeds of the wheels, m/s, positive ahead.
 * @param interwheelDistance  m, > 0.
 * @param duration            s.
 *
 * Source: Thrun, Burgard, Fox, Probabilistic Robotics (2005), ch. 5, velocity motion model, with
 *         v = (right + left) / 2 and w = (right - left) / interwheelDistance.
 */
SPose IntegrateDifferentialDrive(const SPose& start, Real left, Real right, Real interwheelDistance,
                                 Real duration);

}  // namespace argos::testing

#endif
