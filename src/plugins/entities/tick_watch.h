#ifndef ARGOS3_PLUGINS_ENTITIES_TICK_WATCH_H
#define ARGOS3_PLUGINS_ENTITIES_TICK_WATCH_H

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>

namespace argos {

/**
 * Detects whether a component's Update() is the first of a tick (after physics) or results from a
 * move by command. For the sources of components.
 */
class CTickWatch {
 public:
  CTickWatch() : m_space(CurrentSpace()), m_tick(m_space.GetSimulationClock()) {}

  /** @return true at the first call in a tick. */
  bool IsNewTick() {
    const UInt32 tick = m_space.GetSimulationClock();
    const bool isNew = tick != m_tick;
    m_tick = tick;
    return isNew;
  }
  /** Tick length, s. */
  Real GetTickLength() const { return m_space.GetSimulator().GetTickLength(); }
  /** Call it when the clock restarts. */
  void Reset() { m_tick = 0; }

 private:
  CSpace& m_space;
  UInt32 m_tick;
};

}  // namespace argos

#endif
