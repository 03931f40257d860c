#ifndef ARGOS3_TESTING_BENCHMARK_BARE_BOX2D_H
#define ARGOS3_TESTING_BENCHMARK_BARE_BOX2D_H

#include <argos3/core/simulator/space/space.h>

#include <memory>

namespace argos::testing {

/**
 * A bare Box2D world of the same discs and walls as a space, for comparison with the engine.
 *
 * In each tick every disc gets the velocity of its robot, so that
 * both worlds have the same traffic.
 */
class CBareBox2D {
 public:
  /** @param substeps of a tick. @param tick length, s. */
  CBareBox2D(CSpace& space, UInt32 substeps, Real tick);
  ~CBareBox2D();

  /** Copies the motion of the robots during the last tick of the space; not part of the timing. */
  void TakeVelocities();
  /** One tick: sets the velocities and steps the world. */
  void Tick();

 private:
  struct SState;
  std::unique_ptr<SState> m_state;
};

}  // namespace argos::testing

#endif
