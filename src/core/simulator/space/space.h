#ifndef ARGOS3_CORE_SIMULATOR_SPACE_SPACE_H
#define ARGOS3_CORE_SIMULATOR_SPACE_SPACE_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/datatypes/any.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/vector3.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <typeindex>
#include <unordered_map>
#include <vector>

namespace argos {

class CBodyIndex;
class CControllableEntity;
class CEmbodiedEntity;
class CEntityViews;
class CFloorEntity;
class CLoadErrors;
class CPhysicsEngine;
class CSimulator;
class CThreadPool;
struct STickTimes;

/** What a plug-in keeps for a whole space; see CSpace::GetExtension(). */
class CSpaceExtension {
 public:
  virtual ~CSpaceExtension() = default;
};

/** Makes a CAny that holds a pointer to the entity's exact class. */
using TEntityCast = CAny (*)(CEntity&);

/** Makes the cast of a class known to CSpace::GetEntitiesByType(), once a program. */
template <typename ENTITY>
struct SEntityCast {
  static CAny Cast(CEntity& entity) { return CAny(static_cast<ENTITY*>(&entity)); }
  static const bool kIsRegistered;
};
template <typename ENTITY>
const bool SEntityCast<ENTITY>::kIsRegistered =
    (GetVTable<CEntityViews, CEntity, TEntityCast>().template Add<ENTITY>(&Cast), true);

/**
 * Holds every entity, and runs the tick (tick.cpp).
 *
 * The lists of all entities and the maps by id and by type are views for users, built at the first
 * request and kept up to date from then on (entity_views.h); the tick works on the packed lists.
 */
class CSpace : public CBaseConfigurableResource {
 public:
  typedef std::map<std::string, CAny, std::less<std::string>> TMapPerType;
  typedef std::map<std::string, TMapPerType, std::less<std::string>> TMapPerTypePerId;
  typedef std::function<void(CControllableEntity*)> TControllableEntityIterCBType;

  explicit CSpace(CSimulator& simulator);
  ~CSpace() override;
  CSpace(const CSpace&) = delete;
  CSpace& operator=(const CSpace&) = delete;

  /** Components included. */
  UInt32 GetNumberEntities() const;
  CEntity::TVector& GetEntityVector();
  CEntity::TVector& GetRootEntityVector() { return m_roots; }
  /** By qualified id ("fb0", "fb0.leds_0.led_3"). @throws with the nearest ids if unknown. */
  CEntity& GetEntity(const std::string& id);
  /** Appends the entities whose id matches the POSIX extended regular expression. */
  void GetEntitiesMatching(CEntity::TVector& buffer, const std::string& pattern);
  CEntity::TMap& GetEntityMapPerId();
  TMapPerTypePerId& GetEntityMapPerTypePerId();
  /** Values hold a pointer to the exact class. @throws if there never was an entity of that type.
   */
  TMapPerType& GetEntitiesByType(const std::string& type);
  const TMapPerType& GetEntitiesByType(const std::string& type) const;
  /** @throws CARGoSException if there is no floor. */
  CFloorEntity& GetFloorEntity();
  bool HasFloorEntity() const { return m_floor != nullptr; }
  void SetFloorEntity(CFloorEntity& floor);

  /** Reads `<arena>` and fills it. @throws CARGoSException */
  void Init(TConfigurationNode& tree) override;
  /** The same, collecting every error that can be found in one go. */
  void Init(TConfigurationNode& tree, CLoadErrors& errors);
  /** When everything is loaded: what is enabled now is so again after Reset(). */
  void MarkStart();
  void Reset() override;
  void Destroy() override;
  /** One tick. See tick.cpp. */
  virtual void Update();

  /** Takes a root entity (or notes a component); used by space operations. */
  template <typename ENTITY>
  void AddEntity(ENTITY& entity) {
    static_cast<void>(SEntityCast<ENTITY>::kIsRegistered);
    InsertEntity(entity);
  }
  /** Leaves room in the order of entities, for components that are created later. */
  void SkipIndices(size_t count) { m_nextIndex += static_cast<ssize_t>(count); }
  /** Forgets an entity, then calls Destroy() on it and deletes it; used by space operations. */
  template <typename ENTITY>
  void RemoveEntity(ENTITY& entity) {
    EraseEntity(entity);
  }

  UInt32 GetSimulationClock() const { return m_simulationClock; }
  void SetSimulationClock(UInt32 ticks) { m_simulationClock = ticks; }
  void IncreaseSimulationClock(UInt32 increase = 1) { m_simulationClock += increase; }

  /** m. */
  const CVector3& GetArenaSize() const { return m_arenaSize; }
  void SetArenaSize(const CVector3& size) { m_arenaSize = size; }
  const CVector3& GetArenaCenter() const { return m_arenaCenter; }
  void SetArenaCenter(const CVector3& center) { m_arenaCenter = center; }
  /** Centre -+ size / 2, as of Init(). */
  const CRange<CVector3>& GetArenaLimits() const { return m_arenaLimits; }

  virtual void AddControllableEntity(CControllableEntity& entity);
  virtual void RemoveControllableEntity(CControllableEntity& entity);
  /**
   * Gives the body to every engine whose region it touches (immovable), or to the first one that
   * contains its origin and accepts (movable). @throws CARGoSException that says of each engine why
   * not, if none takes it.
   */
  virtual void AddEntityToPhysicsEngine(CEmbodiedEntity& entity);
  /** The same, but @p first, unless null, is asked before all others. */
  void AddEntityToPhysicsEngine(CEmbodiedEntity& entity, CPhysicsEngine* first);
  /** An immovable body has been put elsewhere: it may touch other regions. */
  void RehouseImmovable(CEmbodiedEntity& entity);
  /** Takes the body out of its engines and out of the index. */
  void RemoveEntityFromPhysicsEngines(CEmbodiedEntity& entity);
  /** Calls back for each robot, on the pool's threads, or in order if there is one. */
  virtual void IterateOverControllableEntities(const TControllableEntityIterCBType& callback);

  /** Robots in order of their addition. */
  const std::vector<CControllableEntity*>& GetControllableEntities() const { return m_robots; }
  CSimulator& GetSimulator() { return m_cSimulator; }
  /** Where every body is, for sensors and placement. */
  CBodyIndex& GetBodyIndex() { return *m_bodyIndex; }
  const CBodyIndex& GetBodyIndex() const { return *m_bodyIndex; }
  /**
   * True if an engine has bodies that the index does not know: rays must then ask all engines. As
   * of the start of the phase in which robots sense.
   */
  bool AreBodiesOutsideIndex() const { return m_areBodiesOutsideIndex; }
  /** Own random generator, for placement. */
  CRandom::CRNG& GetRNG();
  /** While probing, robots get no controller: the loader only wants to know their bodies. */
  bool IsProbing() const { return m_probing; }
  void SetProbing(bool probing) { m_probing = probing; }
  /** Starts to add up the time of each phase in @p times (not owned); nullptr stops. */
  void SetTickTimes(STickTimes* times) { m_tickTimes = times; }
  /** Adds a root entity; if that fails, nothing of it stays. @throws CARGoSException */
  void TakeOver(std::unique_ptr<CEntity> entity);
  /** Makes the entity that an XML element describes and adds it; nothing stays if that fails. */
  CEntity& CreateEntity(TConfigurationNode& node);
  /** 64-bit digest of the state of every entity and medium, in order. */
  UInt64 ComputeDigest() const;

  /**
   * The EXTENSION of this space, made when first asked for: what the entities and devices of a
   * plug-in share, without the core knowing it. Lives until Destroy(), after all entities.
   *
   * Takes a look-up and may allocate: ask once, while nothing acts or senses in parallel, and keep
   * the reference.
   * @tparam EXTENSION  derives from CSpaceExtension; has a constructor without arguments.
   */
  template <typename EXTENSION>
  EXTENSION& GetExtension() {
    std::unique_ptr<CSpaceExtension>& extension = m_extensions[typeid(EXTENSION)];
    if (extension == nullptr) {
      extension = std::make_unique<EXTENSION>();
    }
    return static_cast<EXTENSION&>(*extension);
  }

 private:
  void InsertEntity(CEntity& entity);
  void EraseEntity(CEntity& entity);
  CEntity* TryGetEntity(const std::string& id);
  [[noreturn]] void ThrowNoEngine(CEmbodiedEntity& body);
  void FillArena(TConfigurationNode& tree, CLoadErrors& errors);
  void InitArena(TConfigurationNode& tree);

  // phases of the tick, see tick.cpp
  void Act(CThreadPool& pool);
  void CollectGhosts(CThreadPool& pool);
  void UpdatePhysics(CThreadPool& pool);
  void TransferBodies();
  void ReturnBodiesToEngines();
  void UpdateMedia(CThreadPool& pool);
  void SenseAndControl(CThreadPool& pool);

  CSimulator& m_cSimulator;
  UInt32 m_simulationClock = 0;
  CVector3 m_arenaSize;
  CVector3 m_arenaCenter;
  CRange<CVector3> m_arenaLimits;
  CFloorEntity* m_floor = nullptr;
  CRandom::CRNG* m_rng = nullptr;  // owned by its category
  STickTimes* m_tickTimes = nullptr;

  CEntity::TVector m_roots;  // owned, in order of addition
  std::unordered_map<std::string, CEntity*> m_rootById;  // look-up only, never iterated
  std::vector<CControllableEntity*> m_robots;  // in order of addition
  ssize_t m_nextIndex = 0;
  bool m_probing = false;
  std::unique_ptr<CEntityViews> m_views;  // the lists and maps for users
  std::unique_ptr<CBodyIndex> m_bodyIndex;
  bool m_areBodiesOutsideIndex = true;
  std::unordered_map<std::type_index, std::unique_ptr<CSpaceExtension>>
      m_extensions;  // look-up only, never iterated
};

}  // namespace argos

#include <argos3/core/simulator/space/space_operations.h>

#endif
