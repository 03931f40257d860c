#ifndef ARGOS3_CORE_SIMULATOR_CONTEXT_SIMULATION_CONTEXT_H
#define ARGOS3_CORE_SIMULATOR_CONTEXT_SIMULATION_CONTEXT_H

#include <argos3/core/simulator/context/arena.h>
#include <argos3/core/simulator/context/load_state.h>
#include <argos3/core/simulator/context/robot_failures.h>
#include <argos3/core/simulator/context/run_state.h>

#include <functional>
#include <vector>

namespace argos {

class CBodyIndex;
class CFloorPainter;
class CLoopFunctions;
class CMedium;
class CMetrics;
class CPhysicsEngine;
class CSimulator;
class CSpace;
class CThreadPool;

/**
 * What the parts of one simulation share: each part gets the others from here and includes only the
 * headers of those that it uses, so that no part includes the simulator, which owns them all.
 *
 * Parts created by zero-argument factories call CurrentContext() in their constructor.
 */
struct SSimulationContext {
  explicit SSimulationContext(CSimulator& simulator) : Simulator(simulator) {}
  SSimulationContext(const SSimulationContext&) = delete;
  SSimulationContext& operator=(const SSimulationContext&) = delete;

  /** The clock of the space, ticks; defined beside it. */
  UInt32 GetClock() const;

  // valid during the lifetime of the simulator
  CSimulator& Simulator; /**< serves users' code; the core uses the parts below */
  CSpace* Space = nullptr;
  CBodyIndex* Index = nullptr; /**< index of all bodies in the space */
  CMetrics* Metrics = nullptr; /**< metrics of the run; null unless an experiment is loaded */
  std::function<void()> RunTick; /**< one tick; for CSpace::Update() */
  std::function<void()> EndRun; /**< ends the run of the outputs; before CSpace::Reset() */
  CThreadPool* Pool = nullptr; /**< runs phases; has no workers before loading */

  const UInt32* Clock = nullptr; /**< clock of the space, ticks */
  CRunState Run; /**< says what the simulation is doing */
  bool IsSpaceResetting = false; /**< all entities are reset, and afterwards the engines */

  // these belong to the experiment that is loaded
  bool IsReplay = false; /**< there are no controllers, engines, media and loop functions */
  bool IsExactReplay = false; /**< the recording has all bits of the poses */
  CLoadState Loading;
  CRobotFailures RobotFailures;
  Real TickLength = 0.1; /**< s */
  SArena Arena;
  std::vector<CPhysicsEngine*> Engines; /**< have document order */
  std::vector<CMedium*> Media; /**< have document order */
  CLoopFunctions* LoopFunctions = nullptr;
  CFloorPainter* FloorPainter = nullptr; /**< interface of the loop functions for the floor */
};

}  // namespace argos

#endif
