#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_ENGINE_ASSIGNMENT_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_ENGINE_ASSIGNMENT_H

#include <argos3/core/simulator/context/simulation_context.h>

namespace argos {

class CEmbodiedEntity;
class CPhysicsEngine;

/**
 * Decides which engines of a simulation contain a body.
 *
 * An immovable body is in every engine whose region it touches, a movable one in the first that
 * contains its origin and accepts it. Has no state of its own: it reads the engines and the index
 * of its simulation.
 */
class CEngineAssignment {
 public:
  explicit CEngineAssignment(SSimulationContext& context) : m_context(context) {}

  /**
   * Adds a body to its engines and to the index.
   * @param first  unless null, tried before all others.
   * @throws CARGoSException if no engine accepts it; the text gives the reason of each engine.
   */
  void Add(CEmbodiedEntity& body, CPhysicsEngine* first = nullptr) const;
  /** Removes a body from its engines and from the index. */
  void Remove(CEmbodiedEntity& body) const;
  /** Adds an immovable body that has been moved to the engines whose regions it touches now. */
  void ReassignImmovable(CEmbodiedEntity& body) const;
  /**
   * @return true if a movable body of @p engine has been moved into the region of another one. A
   * body outside all regions stays in its engine.
   */
  bool BelongsToAnother(const CEmbodiedEntity& body, CPhysicsEngine& engine) const;
  /** Adds each body of the index to the engines that it belonged to when it was added. */
  void ReturnAll() const;

 private:
  void Return(CEmbodiedEntity& body) const;
  [[noreturn]] void ThrowNoEngine(CEmbodiedEntity& body) const;

  SSimulationContext& m_context;
};

}  // namespace argos

#endif
