#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_PARTS_POOL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_PARTS_POOL_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <memory>
#include <vector>

namespace argos {

/**
 * Parts in ODE that free robots have given back, disabled, for the next ones that become active:
 * ODE allocates memory for each part. A robot gets parts of its own description.
 */
class CPartsPool {
 public:
  CPartsPool() = default;
  ~CPartsPool();
  CPartsPool(const CPartsPool&) = delete;
  CPartsPool& operator=(const CPartsPool&) = delete;

  /** Moves the parts of a robot here. @param most  spare parts to keep; others are destroyed. */
  void Return(SRigidBody& robot, size_t most);
  /** Moves parts to a robot that has none. @return false if there are none for it. */
  bool Take(SRigidBody& robot);
  /** Destroys all parts; before their ODE world is. */
  void Clear();
  size_t GetSize() const { return m_size; }

 private:
  struct SKind {
    // keeps the description alive, so that no other one gets its address
    std::shared_ptr<const SBodyDescription> Description;
    std::vector<SRigidParts> Spares;
  };

  SKind& GetKind(const SRigidBody& robot);

  std::vector<SKind> m_kinds;  // in order of their first robots
  size_t m_size = 0;  // of all kinds
};

}  // namespace argos

#endif
