#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_ENGINE_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_PHYSICS_ENGINE_H

#include <argos3/core/simulator/entity/physics_model.h>
#include <argos3/core/simulator/geometry/volume.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/core/simulator/physics_engine/ray_queries.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace argos {

class CEngineAssignment;
class CEntity;
class CSimulator;
class CSpace;
class CThreadPool;
struct SSimulationContext;

/** How a body moves, independent of the type of its engine; world frame. */
struct SBodyMotion {
  CVector3 Velocity; /**< velocity of the origin anchor, m/s */
  CVector3 Rotation; /**< about the origin anchor, rad/s */
  std::optional<SDriveCommand> Command; /**< the last one of its drive, for engines that know it */
};

/**
 * A movable body of another engine near this one's border, at its pose of the start of the tick.
 *
 * Its own engine moves the body at the same time: read its description, but not its anchors.
 */
struct SGhost {
  CEmbodiedEntity* Body;
  CVector3 Position; /**< position of the origin anchor, m, world frame */
  CQuaternion Orientation;
  bool IsObject; /**< it has neither a drive nor propellers */
};

/**
 * Owns the bodies of a region of space and moves them.
 *
 * The contract of one tick (called by CSpace, one engine per thread at a time; see UsesThreadPool()
 * for engines that spread their own work over threads):
 *  1. Update() reads what actuators wrote into the components of this engine's bodies (wheel
 *     speeds, ...), advances them by GetIterations() substeps of GetPhysicsClockTick() seconds, and
 *     writes poses back through CEmbodiedEntity::SetOriginPose(). It accesses no other body.
 *  2. Bodies found outside GetVolume() are passed to ScheduleEntityForTransfer() during 1 and moved
 *     to their new engine by TransferEntities(), which the space calls serially, engine by engine.
 *
 * doc/space_partitioning.md describes how engines share space: regions, walls, gates, and ghosts,
 * which are bodies of other engines that act as obstacles across a border.
 *
 * An engine builds its bodies from SBodyDescription (CEmbodiedEntity::GetBodyDescription());
 * CDescribedBodyEngine is the base of those that do nothing else. Reset() restores the exact state
 * of the engine right after loading: a run repeats bit for bit.
 */
class CPhysicsEngine : public CBaseConfigurableResource {
 public:
  typedef std::vector<CPhysicsEngine*> TVector;
  typedef std::map<std::string, CPhysicsEngine*, std::less<std::string>> TMap;

  CPhysicsEngine();
  ~CPhysicsEngine() override = default;

  /**
   * Reads `id`, `iterations` (substeps per tick, >= 1), `<boundaries>`, and `ghosts` if
   * CanFeelGhosts().
   * @throws CARGoSException if a value is missing, unparsable or out of range.
   */
  void Init(TConfigurationNode& tree) override;
  void Reset() override {}
  void Destroy() override {}

  /** Advances all bodies by one tick; see the contract above. */
  virtual void Update() = 0;
  /**
   * @return true if Update() spreads its work over the simulator's thread pool. Such engines are
   * updated one after the other, not inside a parallel phase. Constant during a run.
   */
  virtual bool UsesThreadPool() const { return false; }
  /** Called once after the arena is filled. */
  virtual void PostSpaceInit() {}
  /** @return true if this engine owns bodies with their origin at @p point (m, world frame). */
  virtual bool IsPointContained(const CVector3& point);
  /**
   * @return true if an immovable body must be in this engine: if a solid of it is so near to the
   * region that a body of this engine may touch it; for a body without a description, if its origin
   * is in the region.
   */
  virtual bool IsTouchedBy(const CEmbodiedEntity& body);
  /** Lowest and highest z of this engine's bodies, m: of the region, or the height of a plane. */
  virtual std::pair<Real, Real> GetHeightSpan() const;
  virtual size_t GetNumPhysicsModels() = 0;
  /** Adds the body of a root entity. @return false if this engine does not accept it. */
  virtual bool AddEntity(CEntity& entity) = 0;
  /**
   * Why AddEntity() returned false and what to change, for an error message: a phrase whose subject
   * is the engine.
   */
  virtual std::string ExplainRefusal(CEntity& entity) const;
  /** Removes the body of a root entity. @return false if this engine does not have it. */
  virtual bool RemoveEntity(CEntity& entity) = 0;

  bool IsEntityTransferNeeded() const { return !m_transfers.empty(); }
  bool IsEntityTransferActive() const { return m_volume.IsActive(); }
  virtual void ScheduleEntityForTransfer(CEmbodiedEntity& entity);
  /** Transfers the scheduled bodies, in order of entity index, to the engines that contain them. */
  virtual void TransferEntities();

  /**
   * Transfers one body of this engine to the engine that contains it, for TransferEntities(); does
   * nothing if the body is no longer in this engine.
   */
  virtual void TransferEntity(CEmbodiedEntity& body);

  /**
   * Gets the motion that a body of this engine keeps when it is transferred to an engine of another
   * type.
   * @return false if this engine does not provide it.
   */
  virtual bool GetMotion(const CEmbodiedEntity& /*body*/, SBodyMotion& /*motion*/) const {
    return false;
  }
  /** Sets the motion of a body that was just transferred; engines without momentum ignore it. */
  virtual void SetMotion(CEmbodiedEntity& /*body*/, const SBodyMotion& /*motion*/) {}

  /**
   * Time until a new command of a drive takes effect, as a share of a tick, in [0, 1]; until then
   * the robot follows the command of the tick before.
   */
  virtual Real GetVelocityLag() const { return 0.0; }

  /** @return true if the engine stops bodies at walls of the region (SVolume::DescribeWalls()). */
  virtual bool StopsAtWalls() const { return false; }
  /**
   * @return true if bodies that leave the arena through a periodic side come back through the
   * opposite one, and touch each other across it.
   */
  virtual bool CanBePeriodic() const { return false; }
  /** @return true if Update() uses GetGhosts() unless the user sets ghosts="false". */
  virtual bool CanFeelGhosts() const { return false; }
  /** Greatest distance beyond the border at which a ghost's solid matters within a tick, m. */
  virtual Real GetGhostReach() const { return 0.5; }
  /** @return true if there are borders to other engines and bodies behind them are obstacles. */
  bool SeesGhosts() const { return m_feelsGhosts && !m_borders.empty(); }
  /** Finds the ghosts of the next tick. Called by the space while no body moves. */
  void CollectGhosts();
  /** Sorted by number in the space's index. */
  const std::vector<SGhost>& GetGhosts() const { return m_ghosts; }
  /** Borders to other engines, seen from above; set by the simulator after all engines exist. */
  void SetBorders(std::vector<CRay2> borders) { m_borders = std::move(borders); }

  SVolume& GetVolume() { return m_volume; }
  const SVolume& GetVolume() const { return m_volume; }

  /**
   * Appends every body of this engine that @p ray crosses and that is not in the space's index,
   * because it has no SBodyDescription. Engines that build all bodies from descriptions do nothing.
   */
  virtual void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData& data,
                                        const CRay3& ray) const = 0;
  /**
   * @return false if CheckIntersectionWithRay() never reports a body that is not in the space's
   * index; rays are then faster.
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
  /** 'file:line: <tag id="...">' of the engine's element, for messages. */
  const std::string& GetOrigin() const { return m_origin; }
  CSpace& GetSpace() { return m_cSpace; }
  const CSpace& GetSpace() const { return m_cSpace; }
  /** What this engine shares with the other parts of its simulation. */
  const SSimulationContext& GetContext() const { return m_context; }
  /** Decides which of the simulation's engines contain a body. */
  CEngineAssignment GetAssignment() const;

 protected:
  /** Changes the number of substeps during loading, for engines with their own default. */
  void SetIterations(UInt32 iterations);
  /**
   * The engine behind the gate through which a body has left the region; null if there is no gate,
   * or if that engine does not contain the body, because it went around a corner.
   */
  CPhysicsEngine* FindEngineBehindGate(const CEmbodiedEntity& body) const;
  /**
   * The engine that receives a body which has left the region: of FindEngineBehindGate() and then
   * all engines that contain the body, in document order, the first for which
   * accept(CPhysicsEngine&) is true; null if there is none. It is the order in which
   * CSpace::AddEntityToPhysicsEngine() tries them.
   */
  template <typename ACCEPT>
  CPhysicsEngine* FindNextEngine(const CEmbodiedEntity& body, ACCEPT&& accept) const {
    CPhysicsEngine* const behindGate = FindEngineBehindGate(body);
    if (behindGate != nullptr && accept(*behindGate)) {
      return behindGate;
    }
    for (CPhysicsEngine* engine : GetAllEngines()) {
      if (engine->ContainsOriginOf(body) && accept(*engine)) {
        return engine;
      }
    }
    return nullptr;
  }
  /** The same without a condition. */
  CPhysicsEngine* FindNextEngine(const CEmbodiedEntity& body) const {
    return FindNextEngine(body, [](const CPhysicsEngine&) { return true; });
  }

  bool ContainsOriginOf(const CEmbodiedEntity& body);

  CSimulator& m_cSimulator;
  CSpace& m_cSpace;
  /** Bodies of this engine outside of its region, because they are in a bundle: CBorderBundles. */
  std::vector<CEmbodiedEntity*> m_strays;

 private:
  const TVector& GetAllEngines() const;
  void ListNearBorders(Real reach);
  void ListNearStrays(Real reach);

  SSimulationContext& m_context;
  std::string m_id;
  std::string m_origin;
  SVolume m_volume;
  UInt32 m_iterations = 10;
  Real m_physicsClockTick = 0.0;
  std::vector<CEmbodiedEntity*> m_transfers;
  bool m_feelsGhosts = false;
  std::vector<CRay2> m_borders;
  std::vector<UInt32> m_nearBorder;  // numbers of bodies; scratch of CollectGhosts()
  std::vector<SGhost> m_ghosts;  // written by CollectGhosts()
};

}  // namespace argos

#define REGISTER_PHYSICS_ENGINE(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,   \
                                LONG_DESCRIPTION, STATUS)                               \
  REGISTER_SYMBOL(CPhysicsEngine, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/logging/argos_log.h>
#endif

#endif
