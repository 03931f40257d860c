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
#include <string_view>
#include <typeindex>
#include <unordered_map>
#include <vector>

namespace argos {

class CBodyIndex;
class CControllableEntity;
class CEmbodiedEntity;
class CEntityType;
class CEntityViews;
class CFloorEntity;
class CSimulator;
struct SSimulationContext;

/** Base of the data that a plug-in keeps for a whole space; see CSpace::GetExtension(). */
class CSpaceExtension {
 public:
  virtual ~CSpaceExtension() = default;
};

/** Makes a CAny that holds a pointer to the entity's exact class. */
using TEntityCast = CAny (*)(CEntity&);

/** Registers the cast of a class for CSpace::GetEntitiesByType(), once per program. */
template <typename ENTITY>
struct SEntityCast {
  static CAny Cast(CEntity& entity) { return CAny(static_cast<ENTITY*>(&entity)); }
  static const bool kIsRegistered;
};
template <typename ENTITY>
const bool SEntityCast<ENTITY>::kIsRegistered =
    (GetVTable<CEntityViews, CEntity, TEntityCast>().template Add<ENTITY>(&Cast), true);

/**
 * The registry of all entities of a simulation; owns the root entities.
 *
 * The lists of all entities and the maps by id and by type are views for users, built at the first
 * request and kept up to date from then on (entity_views.h); the tick works on the packed lists.
 */
class CSpace : public CBaseConfigurableResource {
 public:
  typedef std::map<std::string, CAny, std::less<std::string>> TMapPerType;
  typedef std::map<std::string, TMapPerType, std::less<std::string>> TMapPerTypePerId;
  typedef std::function<void(CControllableEntity*)> TControllableEntityIterCBType;

  explicit CSpace(SSimulationContext& context);
  ~CSpace() override;
  CSpace(const CSpace&) = delete;
  CSpace& operator=(const CSpace&) = delete;

  /** Components included. */
  UInt32 GetNumberEntities() const;
  /** Each root entity is followed by its components. */
  CEntity::TVector& GetEntityVector();
  CEntity::TVector& GetRootEntityVector() { return m_roots; }
  /**
   * Calls visit(root, its place in GetRootEntityVector()) for all roots in the order of their
   * creation, which is that of memory.
   */
  void ForRootsAsCreated(const std::function<void(CEntity&, size_t)>& visit) const;
  /** By qualified id ("fb0", "fb0.leds_0.led_3"). @throws with the nearest ids if unknown. */
  CEntity& GetEntity(const std::string& id);
  /** The same, but null if the id is unknown. */
  CEntity* TryGetEntity(const std::string& id);
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

  /**
   * Reads the extents of `<arena>`; the loader then fills it (placement/arena_filling.h).
   * @throws CARGoSException if they are missing or not positive.
   */
  void Init(TConfigurationNode& tree) override;
  /** Called when everything is loaded: Reset() restores what is enabled and set now. */
  void MarkStart();
  /**
   * Sets the clock to 0, and moves all entities and what engines know of them back to the start.
   *
   * Loop functions may call it in a run; outputs then begin another one, as after a reset of the
   * simulator, which also resets random numbers and media, and is exactly repeatable.
   */
  void Reset() override;
  /** The same. @param place  called before entities are reset; may change their initial poses. */
  void Reset(const std::function<void()>& place);
  void Destroy() override;
  /** One tick of the simulation (tick/tick.h). */
  virtual void Update();

  /**
   * Adds a root entity, which the space then owns, or a component; used by space operations.
   * @throws CARGoSException while robots, engines or media are updated; Adopt() is possible then.
   */
  template <typename ENTITY>
  void AddEntity(ENTITY& entity) {
    static_cast<void>(SEntityCast<ENTITY>::kIsRegistered);
    InsertEntity(entity);
  }
  /** Reserves indices in the order of entities, for components that are created later. */
  void SkipIndices(size_t count) { m_nextIndex += static_cast<ssize_t>(count); }
  /**
   * Removes an entity, calls its Destroy() and deletes it; used by space operations.
   * @throws CARGoSException while robots, engines or media are updated; Remove() is possible then.
   */
  template <typename ENTITY>
  void RemoveEntity(ENTITY& entity) {
    EraseEntity(entity);
  }

  UInt32 GetSimulationClock() const { return m_simulationClock; }
  void SetSimulationClock(UInt32 ticks);
  void IncreaseSimulationClock(UInt32 increase = 1) {
    SetSimulationClock(m_simulationClock + increase);
  }

  /** m. */
  const CVector3& GetArenaSize() const;
  void SetArenaSize(const CVector3& size);
  const CVector3& GetArenaCenter() const;
  void SetArenaCenter(const CVector3& center);
  /** Centre -+ size / 2, as of Init(). */
  const CRange<CVector3>& GetArenaLimits() const;

  virtual void AddControllableEntity(CControllableEntity& entity);
  virtual void RemoveControllableEntity(CControllableEntity& entity);
  /**
   * Adds the body to every engine whose region it touches (immovable), or to the first one that
   * contains its origin and accepts it (movable).
   * @throws CARGoSException if no engine accepts it; the text gives the reason of each engine.
   */
  virtual void AddEntityToPhysicsEngine(CEmbodiedEntity& entity);
  /** Removes the body from its engines and from the index. */
  void RemoveEntityFromPhysicsEngines(CEmbodiedEntity& entity);
  /** Calls back for each robot on the pool's threads; in order if there is only one thread. */
  virtual void IterateOverControllableEntities(const TControllableEntityIterCBType& callback);

  /** Robots in the order of root entities. */
  const std::vector<CControllableEntity*>& GetControllableEntities() const { return m_robots; }
  /** Changes whenever that list changes. */
  UInt64 GetVersionOfControllableEntities() const { return m_robotsVersion; }
  /**
   * The most robots that sense in a row before they are controlled: few enough that the data that
   * sensing has loaded is still in the cache for control.
   */
  static constexpr size_t kRobotsPerChunk = 64;
  /**
   * What a tick reads of fewer robots fits into the second-level cache of most processors, wherever
   * it is in memory.
   */
  static constexpr size_t kFewRobots = 500;
  CSimulator& GetSimulator();
  /** What the parts of the simulation share. */
  SSimulationContext& GetContext() { return m_context; }
  /** The index of all bodies, for sensors and placement. */
  CBodyIndex& GetBodyIndex() { return *m_bodyIndex; }
  const CBodyIndex& GetBodyIndex() const { return *m_bodyIndex; }
  /**
   * True if an engine has bodies that the index does not contain: rays must then be tested by all
   * engines. Updated at the start of the phase in which robots sense.
   */
  bool AreBodiesOutsideIndex() const { return m_areBodiesOutsideIndex; }
  void SetBodiesOutsideIndex(bool exist) { m_areBodiesOutsideIndex = exist; }
  /** Own random generator, for placement. */
  CRandom::CRNG& GetRNG();
  /**
   * Adds a root entity; deletes it if that fails. While robots, engines or media are updated it is
   * added at the end of the tick, with its controller (CRunState). @throws CARGoSException
   */
  void Adopt(std::unique_ptr<CEntity> entity);
  /**
   * Removes and deletes a root entity; at the end of the tick while robots, engines or media are
   * updated. @throws CARGoSException if one robot requests it twice in a tick.
   */
  void Remove(CEntity& root);
  /** @throws CARGoSException while robots, engines or media are updated. */
  void CheckMayChange() const;
  /**
   * Notes, on any thread, that a root entity is to be disabled and to leave its engines and media
   * at the end of the tick; it keeps its place in the lists. Reset() takes it back.
   */
  void QuarantineLater(CEntity& root);
  /**
   * Adds a type of entities that the experiment file describes.
   * @param tag  of such entities.
   * @throws CARGoSException if there are already entities of that tag.
   */
  void AddEntityType(const std::string& tag, std::unique_ptr<CEntityType> type);
  /** @return true if a plug-in or the experiment file describes entities of that tag. */
  bool HasEntityType(const std::string& tag) const;
  /** The tags of all entities that may be created. */
  std::vector<std::string> GetEntityTypes() const;
  /**
   * Creates an entity by its tag, neither initialised nor added.
   * @throws CARGoSException with the nearest tags if there is none.
   */
  std::unique_ptr<CEntity> MakeEntity(const std::string& tag) const;
  /** Creates and adds the entity that an XML element describes, see Adopt(). @throws
   * CARGoSException
   */
  CEntity& CreateEntity(TConfigurationNode& node);
  /**
   * Gives root entities, and their robots, the order of the list of their indices. Others keep
   * their places in the space's lists. Indices stay those of the order of addition, in which a tick
   * visits robots.
   */
  void OrderRoots(const std::vector<ssize_t>& indices);
  /** Allocates what the space itself needs for so many more root entities. */
  void ReserveRoots(size_t number);
  /** Creates the entity without its controller, and destroys it. @throws as CreateEntity() */
  void TryEntity(TConfigurationNode& node);
  /** 64-bit digest of the state of every entity and medium, in order. */
  UInt64 ComputeDigest() const;

  /**
   * The EXTENSION of this space, created at the first call: data that the entities and devices of a
   * plug-in share and that the core does not know. It is destroyed by Destroy(), after all
   * entities.
   *
   * The call is a look-up and may allocate: call it once, while no robot acts or senses in
   * parallel, and keep the reference.
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
  void AdoptNow(std::unique_ptr<CEntity> entity);
  void RemoveNow(CEntity& root);
  void QuarantineNow(CEntity& root);
  void TakeBackQuarantined();
  void RemoveLastRoot();
  void ResetEntities(const std::function<void()>& place);
  CEntity* TryGetRoot(const std::string& id, ssize_t index) const;

  SSimulationContext& m_context;
  UInt32 m_simulationClock = 0;
  CFloorEntity* m_floor = nullptr;

  std::map<std::string, std::unique_ptr<CEntityType>> m_entityTypes;  // by tag; outlive entities
  CEntity::TVector m_roots;  // have the order of addition, or of OrderRoots()
  // keys are the ids in the entities themselves; never iterated
  std::unordered_map<std::string_view, std::unique_ptr<CEntity>> m_rootById;
  std::vector<CControllableEntity*> m_robots;  // have the order of m_roots
  UInt64 m_robotsVersion = 0;
  ssize_t m_nextIndex = 0;
  std::unique_ptr<CEntityViews> m_views;  // the lists and maps for users
  std::unique_ptr<CBodyIndex> m_bodyIndex;
  bool m_areBodiesOutsideIndex = true;
  std::unordered_map<std::type_index, std::unique_ptr<CSpaceExtension>>
      m_extensions;  // look-up only, never iterated
};

}  // namespace argos

#include <argos3/core/simulator/space/space_operations.h>

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/medium/medium.h>
#endif

#endif
