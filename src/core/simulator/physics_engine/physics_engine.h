#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_ENGINE_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_ENGINE_H

#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/simulator/physics_engine/volume.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

#include <map>
#include <string>
#include <vector>

namespace argos {

class CEntity;
class CSimulator;
class CSpace;
class CThreadPool;

/**
 * Owns the bodies of a region of space and moves them.
 *
 * The contract of one tick (called by CSpace, one engine per thread at a time; see UsesThreadPool()
 * for those that share their own work among threads):
 *  1. Update() reads what actuators wrote into the components of this engine's bodies (wheel
 *     speeds, ...), advances them by GetIterations() substeps of GetPhysicsClockTick() seconds, and
 *     writes poses back through CEmbodiedEntity::SetOriginPose(). It touches no other body.
 *  2. Bodies found outside GetVolume() are given to ScheduleEntityForTransfer() during 1 and moved
 *     to their new engine by TransferEntities(), which the space calls serially, engine by engine.
 *
 * An engine builds its bodies from SBodyDescription (CEmbodiedEntity::GetBodyDescription()).
 * Reset() restores the exact state of the engine right after loading: a run repeats bit for bit.
 */
class CPhysicsEngine : public CBaseConfigurableResource {
 public:
  typedef std::vector<CPhysicsEngine*> TVector;
  typedef std::map<std::string, CPhysicsEngine*, std::less<std::string>> TMap;

  CPhysicsEngine();
  ~CPhysicsEngine() override = default;

  /**
   * Reads `id`, `iterations` (substeps per tick, >= 1) and `<boundaries>`.
   * @throws CARGoSException if a value is missing, unparsable or out of range.
   */
  void Init(TConfigurationNode& tree) override;
  void Reset() override {}
  void Destroy() override {}

  /** Advances all bodies by one tick; see the contract above. */
  virtual void Update() = 0;
  /**
   * True of an engine whose Update() spreads its work over the simulator's thread pool: such
   * engines are updated one after the other, not inside a phase. Must not change while a run lasts.
   */
  virtual bool UsesThreadPool() const { return false; }
  /** Called once after the arena is filled. */
  virtual void PostSpaceInit() {}
  /** True if a body with its origin at @p point (m, world frame) belongs here. */
  virtual bool IsPointContained(const CVector3& point);
  virtual size_t GetNumPhysicsModels() = 0;
  /** Adds the body of a root entity. @return false if this engine cannot house it. */
  virtual bool AddEntity(CEntity& entity) = 0;
  /**
   * Why AddEntity() has returned false, and what to change, for the message: a phrase whose subject
   * is the engine.
   */
  virtual std::string ExplainRefusal(CEntity& entity) const;
  /** Removes the body of a root entity. @return false if it is not here. */
  virtual bool RemoveEntity(CEntity& entity) = 0;

  bool IsEntityTransferNeeded() const { return !m_transfers.empty(); }
  bool IsEntityTransferActive() const { return m_volume.IsActive(); }
  virtual void ScheduleEntityForTransfer(CEmbodiedEntity& entity);
  /** Moves the scheduled bodies, in order of entity index, to the engines that contain them. */
  virtual void TransferEntities();

  /**
   * Moves one body of this engine to the engine that contains it, for TransferEntities(); does
   * nothing if it is not here any more.
   */
  virtual void TransferEntity(CEmbodiedEntity& body);

  SVolume& GetVolume() { return m_volume; }
  const SVolume& GetVolume() const { return m_volume; }

  /**
   * Appends every body of this engine that @p ray crosses and that the space's index does not know,
   * because it has no SBodyDescription. Engines that build all bodies from descriptions do nothing.
   */
  virtual void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData& data,
                                        const CRay3& ray) const = 0;
  /**
   * False if CheckIntersectionWithRay() never reports a body that the space's index does not know:
   * rays are then faster.
   */
  virtual bool HasBodiesOutsideIndex() const { return true; }

  /** Length of a tick of the calling thread's simulator, s. */
  static Real GetSimulationClockTick();
  /** Ticks per second of the calling thread's simulator. */
  static Real GetInverseSimulationClockTick();
  static void SetSimulationClockTick(Real seconds);

  /** Substeps per tick, >= 1. */
  UInt32 GetIterations() const { return m_iterations; }
  /** Length of a substep, s. */
  Real GetPhysicsClockTick() const { return m_physicsClockTick; }
  const std::string& GetId() const { return m_id; }
  void SetId(const std::string& id) { m_id = id; }
  CSpace& GetSpace() { return m_cSpace; }
  const CSpace& GetSpace() const { return m_cSpace; }

 protected:
  /** Changes the number of substeps before loading is over (engines with their own default). */
  void SetIterations(UInt32 iterations);

  CSimulator& m_cSimulator;
  CSpace& m_cSpace;

 private:
  std::string m_id;
  SVolume m_volume;
  UInt32 m_iterations = 10;
  Real m_physicsClockTick = 0.0;
  std::vector<CEmbodiedEntity*> m_transfers;
};

}  // namespace argos

#define REGISTER_PHYSICS_ENGINE(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,   \
                                LONG_DESCRIPTION, STATUS)                               \
  REGISTER_SYMBOL(CPhysicsEngine, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#endif
