#include <argos3/core/simulator/physics_engine/flight_loop.h>

#include <algorithm>

namespace argos {

Real ComputePositionLoopBound(const SControlGains& gains, Real inertia) {
  return gains.Derivative * inertia /
         (gains.Proportional * inertia + gains.Derivative * gains.Derivative);
}

Real ComputeSpeedLoopBound(const SControlGains& gains, Real inertia) {
  return 2.0 * (inertia + gains.Derivative) / gains.Proportional;
}

Real ComputeSpeedGain(const SControlGains& gains, Real inertia) {
  return gains.Proportional * inertia / (inertia + gains.Derivative);
}

Real ComputeFlightBound(const SBodyDescription& body) {
  const SPropellersDescription& propellers = *body.Propellers;
  const Real inertia = body.GetPlanarInertia();
  return std::min({ComputePositionLoopBound(propellers.Position, body.Mass),
                   ComputePositionLoopBound(propellers.Yaw, inertia),
                   ComputeSpeedLoopBound(propellers.Velocity, body.Mass),
                   ComputeSpeedLoopBound(propellers.YawRate, inertia)});
}

}  // namespace argos
