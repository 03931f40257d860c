#ifndef ARGOS3_CORE_SIMULATOR_SIMULATOR_H
#define ARGOS3_CORE_SIMULATOR_SIMULATOR_H

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/memory/object_slabs.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace argos {

class CLoadErrors;
class CLoopFunctions;
class CProfiler;
class CSpace;
class CThreadPool;
class CVisualization;
struct STickTimes;

/**
 * One simulation; owns all its parts.
 *
 * A process may contain several simulators, of which at most one is current per thread:
 * GetInstance() returns the calling thread's current one. Programs with several simulators
 * construct them and use each inside a CScope; other programs use GetInstance(), which creates one
 * at the first call.
 */
class CSimulator {
 public:
  CSimulator();
  ~CSimulator();
  CSimulator(const CSimulator&) = delete;
  CSimulator& operator=(const CSimulator&) = delete;

  /**
   * The calling thread's current simulator; the process-wide default one if none was made current.
   */
  static CSimulator& GetInstance();

  /** Makes a simulator the calling thread's current one during the lifetime of the scope. */
  class CScope {
   public:
    explicit CScope(CSimulator& simulator);
    ~CScope();
    CScope(const CScope&) = delete;
    CScope& operator=(const CScope&) = delete;

    /** Keeps the simulator current after the scope: for threads that serve one simulator. */
    void Keep() { m_keep = true; }

   private:
    bool m_keep = false;
    CSimulator* m_previous;
    CRandom::CRegistry* m_previousRegistry;
    CObjectSlabs* m_previousSlabs;
  };

  CSpace& GetSpace() const;
  /** @throws CARGoSException with the nearest ids if there is no such engine. */
  CPhysicsEngine& GetPhysicsEngine(const std::string& id) const;
  CPhysicsEngine::TVector& GetPhysicsEngines() { return m_engines; }
  /** @throws CARGoSException if there is no such medium, or if it is not a T. */
  template <typename T>
  T& GetMedium(const std::string& id) {
    T* medium = dynamic_cast<T*>(&GetMediumBase(id));
    if (medium == nullptr) {
      THROW_ARGOSEXCEPTION("medium \"" << id << "\" is not of the required type");
    }
    return *medium;
  }
  CMedium::TVector& GetMedia() { return m_media; }
  CVisualization& GetVisualization();

  /** The root element of the experiment file. */
  TConfigurationNode& GetConfigurationRoot();
  /** The child of `<controllers>` with that id. @throws CARGoSException with the nearest ids. */
  TConfigurationNode& GetConfigForController(const std::string& id);
  /**
   * Marks the controller or medium @p id as failed during loading, so that errors of its users,
   * which are consequences, are not reported.
   */
  void MarkBroken(const std::string& id);
  /** @throws CAlreadyReported if @p id is marked as failed. */
  void ThrowIfBroken(const std::string& id) const;

  /**
   * Calls @p check when everything from the file and from the loop functions is loaded; immediately
   * if nothing is being loaded. Its exception is reported with the other errors of loading, equal
   * texts once; it is not called if there are others.
   */
  void CheckWhenLoaded(std::function<void()> check);

  /** @throws CARGoSException if profiling is off. */
  CProfiler& GetProfiler();
  bool IsProfiling() const { return m_profiler != nullptr; }

  UInt32 GetRandomSeed() const { return m_randomSeed; }
  /** Overrides the seed of the file; call it before loading. */
  void SetRandomSeed(UInt32 seed);
  /** The first generator of the category "argos". */
  CRandom::CRNG* GetRNG() { return m_rng; }

  const std::string& GetExperimentFileName() const { return m_experimentFileName; }
  void SetExperimentFileName(const std::string& fileName) { m_experimentFileName = fileName; }
  CLoopFunctions& GetLoopFunctions();
  /** The caller keeps ownership; they must exist until Destroy() or until others are set. */
  void SetLoopFunctions(CLoopFunctions& loopFunctions);
  /** In ticks; 0 = unlimited. */
  UInt32 GetMaxSimulationClock() const { return m_maxSimulationClock; }
  /** Overrides the length of the file, before or after loading. @param seconds 0 = unlimited. */
  void SetLength(Real seconds);
  /** As in the file or as set; 0 = main thread only. */
  UInt32 GetNumThreads() const { return m_numThreads; }
  /** Overrides the number of threads of the file; call it before loading. */
  void SetNumThreads(UInt32 threads);
  bool IsRealTimeClock() const { return m_realTimeClock; }
  void SetRealTimeClock(bool realTime) { m_realTimeClock = realTime; }
  /** Length of a tick, s. */
  Real GetTickLength() const { return m_tickLength; }
  /** Overrides an attribute of the file (`--set`); call it before loading. */
  void AddOverride(const std::string& path, const std::string& value);

  /** Ends the experiment at the next check of IsExperimentFinished(). */
  void Terminate() { m_terminated = true; }
  std::string GetInstallationDirectory() const;

  /** Loads from a tree; the document must outlive the experiment. */
  void Load(CConfigurationDocument& document, bool forceNoVisualization = false);
  /**
   * Loads the experiment file of that name.
   * @throws CARGoSException that reports all errors that can be found without running.
   */
  void LoadExperiment(bool forceNoVisualization = false);
  /** Initialises from the loaded document; called by Load(). */
  void Init();
  /** Restores the initial state: the run can be repeated exactly. */
  void Reset();
  /** The same with another seed. */
  void Reset(UInt32 newRandomSeed);
  /**
   * Destroys the experiment; another one may be loaded.
   * @throws the exception of the loop functions' Destroy(), after everything else is destroyed.
   */
  void Destroy();
  /** Runs the visualization until the experiment ends. */
  void Execute();
  /** One tick. */
  void UpdateSpace();
  bool IsExperimentFinished() const;

  /** Called after every tick, for progress displays; an empty function stops it. */
  void SetTickObserver(std::function<void(CSimulator&)> observer) {
    m_tickObserver = std::move(observer);
  }
  /** The threads on which phases run. */
  CThreadPool& GetThreadPool() { return *m_pool; }

 private:
  friend class CPhysicsEngine;
  struct SDefaultTag {};
  explicit CSimulator(SDefaultTag);

  CMedium& GetMediumBase(const std::string& id);
  void ThrowIfLoaded() const;
  static UInt32 SeedFromClock();
  void ApplyOverrides(CLoadErrors& errors);
  void InitFramework(TConfigurationNode& node, CLoadErrors& errors);
  void InitSystem(TConfigurationNode& framework);
  void InitExperiment(TConfigurationNode& framework);
  void InitProfiling(TConfigurationNode& framework);
  void FinishProfiling();
  void InitRandom(TConfigurationNode& experiment);
  void InitControllers(TConfigurationNode& node, CLoadErrors& errors);
  void InitController(TConfigurationNode& node);
  void CreateLoopFunctions(TConfigurationNode& root, CLoadErrors& errors);
  void InitPhysics(TConfigurationNode& node, CLoadErrors& errors);
  void InitMedia(TConfigurationNode& node, CLoadErrors& errors);
  void InitLoopFunctions(TConfigurationNode& root, CLoadErrors& errors);
  void PostSpaceInit(CLoadErrors& errors);
  void InitVisualization(TConfigurationNode& root, CLoadErrors& errors);
  void WarnOfUnreadParts() const;

  CObjectSlabs::TOwner m_slabs;  // of the entities, devices and controllers
  std::string m_experimentFileName;
  std::unique_ptr<CConfigurationDocument> m_ownDocument;
  CConfigurationDocument* m_document = nullptr;
  std::vector<std::pair<std::string, std::string>> m_overrides;
  bool m_forceNoVisualization = false;

  bool m_seedSet = false;  // by the user, before loading
  bool m_seedFromClock = true;  // neither set nor in the file
  UInt32 m_randomSeed = 0;
  CRandom::CRNG* m_rng = nullptr;  // owned by its category
  std::unique_ptr<CRandom::CRegistry> m_ownRegistry;  // null: the process's default one
  CRandom::CRegistry* m_registry = nullptr;

  bool m_threadsSet = false;
  UInt32 m_numThreads = 0;
  bool m_lengthSet = false;
  Real m_length = 0.0;  // s
  Real m_tickLength = 0.1;  // s
  UInt32 m_maxSimulationClock = 0;
  bool m_realTimeClock = false;
  std::atomic<bool> m_terminated{false};  // controllers may end the experiment concurrently

  std::map<std::string, TConfigurationNode*> m_controllerNodes;
  bool m_loading = false;
  std::set<std::string> m_broken;  // ids of parts that failed while loading
  std::vector<std::function<void()>> m_checks;  // called at the end of loading
  std::unique_ptr<CThreadPool> m_pool;
  std::unique_ptr<CSpace> m_space;
  std::unique_ptr<CLoopFunctions> m_ownLoopFunctions;
  CLoopFunctions* m_loopFunctions = nullptr;
  bool m_loopFunctionsReady = false;  // initialised and not destroyed
  std::unique_ptr<CProfiler> m_profiler;
  std::unique_ptr<STickTimes> m_profiledTicks;  // with the profiler
  // vectors for users, with the same objects as the owning ones
  CPhysicsEngine::TVector m_engines;
  CMedium::TVector m_media;
  std::vector<std::unique_ptr<CPhysicsEngine>> m_ownEngines;
  std::vector<std::unique_ptr<CMedium>> m_ownMedia;
  std::unique_ptr<CVisualization> m_visualization;
  std::function<void(CSimulator&)> m_tickObserver;
};

}  // namespace argos

#endif
