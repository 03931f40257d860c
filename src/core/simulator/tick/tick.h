#ifndef ARGOS3_CORE_SIMULATOR_TICK_TICK_H
#define ARGOS3_CORE_SIMULATOR_TICK_TICK_H

#include <argos3/core/simulator/physics_engine/border_bundles.h>
#include <argos3/core/simulator/tick/look_ahead.h>
#include <argos3/core/utility/threads/phase_cost.h>

namespace argos {

class CSpace;
struct SSimulationContext;
struct STickTimes;

/**
 * One step of a simulation: the robots act, engines move bodies, media are updated, robots sense
 * and are controlled.
 *
 * What is read in a phase is not written in it, and what is written belongs to one robot or one
 * engine: no phase needs a lock, and none depends on the number of threads.
 */
class CTick {
 public:
  explicit CTick(SSimulationContext& context);

  void Run();
  /**
   * How many robots a thread handles in a row; 0 chooses a number by the measured cost.
   */
  void SetGrain(size_t robots);
  /** From now on adds the time of each phase to @p times (not owned); nullptr stops. */
  void SetTimes(STickTimes* times) { m_times = times; }

 private:
  void PlanVisits();
  void Act();
  void CollectGhosts();
  void CollectGhostsOfEngines();
  void UpdatePhysics();
  void TransferBodies();
  void UpdateMedia();
  void SenseAndControl();
  // visits [first, last), on one thread
  void SenseAndControlChunk(size_t first, size_t last, UInt32 thread, UInt64 firstPlace);
  void BeginRecords();
  void TakeRecords(const char* call, bool isDevice);

  // has a cache line of its own, because each thread writes to one of them
  struct alignas(64) SRobotTimes {
    Real Sense = 0.0;  // s
    Real Control = 0.0;  // s
  };

  SSimulationContext& m_context;
  STickTimes* m_times = nullptr;
  std::vector<SRobotTimes> m_robotTimes;  // times of the present phase, by thread
  CPhaseCost m_actCost, m_senseCost;  // cost of the robots in each phase
  CPhaseCost m_ghostCost, m_engineCost, m_mediumCost;
  std::vector<SRobotVisit> m_visits;
  UInt64 m_robotsOfVisits = ~UInt64(0);  // version of the list of robots that m_visits has
  CLookAhead m_lookAhead;
  CBorderBundles m_bundles;
};

}  // namespace argos

#endif
