#ifndef ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_TURNOVER_H
#define ARGOS3_TESTING_CONTRACT_PHYSICS_ENGINES_TURNOVER_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/support/experiment.h>

#include <functional>
#include <string>
#include <vector>

namespace argos {

class CLoopFunctions;

/** Adds, removes and moves e-pucks at random, and counts them. */
class CTurnover {
 public:
  /**
   * @param world      with e-pucks whose controller is "diffusion".
   * @param side       of the square in which they are, m.
   * @param perTick    robots that are added, and removed, and moved in each tick.
   */
  CTurnover(CTestWorld& world, Real side, UInt32 perTick);

  void Tick();
  /** None is lost, none is in two engines, and all are in finite places inside the arena. */
  void Check();
  UInt64 GetNumAdded() const { return m_added; }

 private:
  CVector3 DrawPlace();
  size_t DrawRobot();
  CLoopFunctions& GetFunctions();
  void Remove();
  void Add();
  void Move();
  void MoveToFreePlace(CEmbodiedEntity& body);
  size_t CountModels();

  CTestWorld& m_world;
  CSimulator::CScope m_scope;
  CRandomStream m_random{1, "test", "turnover", "places"};
  Real m_reach;  // m, of places in x and y
  UInt32 m_perTick;
  std::vector<std::string> m_ids;
  size_t m_fixed = 0;  // models of bodies that are no robots
  UInt64 m_added = 0;
};

/**
 * Runs ticks for ARGOS_SOAK_MINUTES of wall time, 60 if that is not set, and checks that resident
 * memory grows by at most 2 % and 2 MiB after the first tenth of the time.
 * @param check  called every ten ticks.
 */
void Soak(const std::function<void()>& tick, const std::function<void()>& check);
/** The same for so many minutes of simulated time, without a check. */
void SoakSimulated(UInt32 ticksPerSecond, const std::function<void()>& tick);

}  // namespace argos

#endif
