#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/simulator.h>

using namespace argos;

/* Asks for the clock of the engine in its constructor, before there are engines. */
class CCollectingLoopFunctions : public CLoopFunctions {
 public:
  CCollectingLoopFunctions()
      : m_unRobotsAtStart(GetSpace().GetRootEntityVector().size()),
        m_fTicksPerSecond(
            CSimulator::GetInstance().GetPhysicsEngine("dyn2d").GetInverseSimulationClockTick()),
        m_fTickLength(CSimulator::GetInstance().GetPhysicsEngine("dyn2d").GetSimulationClockTick()),
        m_unResourceTicks(0) {}

  virtual void Init(TConfigurationNode& t_node) {
    Real fSeconds;
    GetNodeAttribute(t_node, "resource_time", fSeconds);
    m_unResourceTicks = static_cast<UInt32>(fSeconds * m_fTicksPerSecond);
    LOG << "engines " << CSimulator::GetInstance().GetPhysicsEngines().size() << std::endl;
    LOG << "iterations " << CSimulator::GetInstance().GetPhysicsEngine("dyn2d").GetIterations()
        << std::endl;
  }

  virtual void PostExperiment() {
    LOG << "robots_at_start " << m_unRobotsAtStart << std::endl;
    LOG << "ticks_per_second " << m_fTicksPerSecond << std::endl;
    LOG << "tick_length " << m_fTickLength << std::endl;
    LOG << "resource_ticks " << m_unResourceTicks << std::endl;
  }

 private:
  size_t m_unRobotsAtStart;
  Real m_fTicksPerSecond;
  Real m_fTickLength;
  UInt32 m_unResourceTicks;
};

REGISTER_LOOP_FUNCTIONS(CCollectingLoopFunctions, "collecting_loop_functions")
