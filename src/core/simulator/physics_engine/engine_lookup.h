#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_ENGINE_LOOKUP_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_ENGINE_LOOKUP_H

#include <memory>
#include <mutex>
#include <set>
#include <string>

namespace argos {

class CPhysicsEngine;
struct SSimulationContext;

/**
 * Finds the engines of a simulation for users' code.
 *
 * Code written for ARGoS 3 asks for engines that do not exist, or not yet: constructors of loop
 * functions run before engines are created, and often only need the length of a tick. So an unknown
 * id gives a warning, once, and an engine that answers.
 */
class CEngineLookup {
 public:
  explicit CEngineLookup(const SSimulationContext& context) : m_context(context) {}
  ~CEngineLookup();

  /**
   * The engine with that id; if there is none, the only engine; else an engine without bodies,
   * which knows the clock. May be called by several threads.
   */
  CPhysicsEngine& Get(const std::string& id);

 private:
  void Warn(const std::string& id);

  const SSimulationContext& m_context;
  std::mutex m_mutex;  // guards what follows; locked only for ids that do not exist
  std::unique_ptr<CPhysicsEngine> m_standIn;  // null until it is needed
  std::set<std::string> m_reported;  // ids
};

}  // namespace argos

#endif
