#ifndef ARGOS3_CORE_SIMULATOR_SIMULATOR_H
#define ARGOS3_CORE_SIMULATOR_SIMULATOR_H

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/loading/run_settings.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/non_copyable.h>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace argos {

class CLoopFunctions;
class CMetrics;
class CProfiler;
class CRunOutput;
class CRunOutputs;
class CSpace;
class CThreadPool;
class CTick;
class CVisualization;
struct SExperimentParts;
struct SReplayRequest;
struct STickTimes;

/**
 * One simulation; owns all its parts.
 *
 * SSimulationContext has what the parts share, SExperimentParts the parts of one experiment. The
 * loader (loading/experiment_loader.h) creates the experiment, CTick runs it.
 *
 * A process may contain several simulators. Programs with several construct them and use each
 * inside a CScope, which makes it the current one of the calling thread; other programs use
 * GetInstance(), which creates one at the first call.
 */
class CSimulator {
 public:
  CSimulator();
  ~CSimulator();
  CSimulator(const CSimulator&) = delete;
  CSimulator& operator=(const CSimulator&) = delete;

  /**
   * The calling thread's current simulator. A thread without one, such as a helper thread of users'
   * code, gets the only simulator of the process that has an experiment (from the start of its
   * loading to the end of Destroy()), of several the one that it has loaded last, and if none has
   * an experiment, the default simulator of the process. May be called by any thread.
   * @throws CARGoSException if several have an experiment, and the thread has loaded none of them.
   */
  static CSimulator& GetInstance();

  /** Makes a simulator the calling thread's current one during the lifetime of the scope. */
  class CScope : private CNonCopyable {
   public:
    explicit CScope(CSimulator& simulator);
    ~CScope();

    /** Keeps the simulator current after the scope: for threads that serve one simulator. */
    void Keep() { m_keep = true; }

   private:
    bool m_keep = false;
    CSimulator* m_previous;
    CRandom::CRegistry* m_previousRegistry;
    CObjectSlabs* m_previousSlabs;
  };

  CSpace& GetSpace() const;
  /**
   * If there is no such engine, warns once and returns the only engine, else an engine without
   * bodies that knows the clock: for code that asks before the engines exist.
   */
  CPhysicsEngine& GetPhysicsEngine(const std::string& id) const;
  CPhysicsEngine::TVector& GetPhysicsEngines() { return m_context.Engines; }
  /** @throws CARGoSException if there is no such medium, or if it is not a T. */
  template <typename T>
  T& GetMedium(const std::string& id) {
    T* medium = dynamic_cast<T*>(&GetMediumBase(id));
    if (medium == nullptr) {
      THROW_ARGOSEXCEPTION("medium \"" << id << "\" is not of the required type");
    }
    return *medium;
  }
  CMedium::TVector& GetMedia() { return m_context.Media; }
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
  bool IsProfiling() const;
  /** From now on adds the time of each phase of a tick to @p times (not owned); nullptr stops. */
  void SetTickTimes(STickTimes* times);

  /**
   * The metrics of the run, which robots and loop functions record.
   * @throws CARGoSException if no experiment is loaded.
   */
  CMetrics& GetMetrics();

  /** The errors of robots that did not end the run, since the experiment was loaded. */
  const CRobotFailures& GetRobotFailures() const;

  UInt32 GetRandomSeed() const { return m_settings.Seed; }
  /** Overrides the seed of the file; call it before loading. */
  void SetRandomSeed(UInt32 seed);
  /**
   * The first generator of the category "argos". @throws CARGoSException in code of robots, which
   * would draw from it in no order.
   */
  CRandom::CRNG* GetRNG();

  const std::string& GetExperimentFileName() const { return m_experimentFileName; }
  void SetExperimentFileName(const std::string& fileName) { m_experimentFileName = fileName; }
  CLoopFunctions& GetLoopFunctions();
  /** The caller keeps ownership; they must exist until Destroy() or until others are set. */
  void SetLoopFunctions(CLoopFunctions& loopFunctions);
  /** In ticks; 0 = unlimited. */
  UInt32 GetMaxSimulationClock() const { return m_settings.MaxClock; }
  /** Overrides the length of the file, before or after loading. @param seconds 0 = unlimited. */
  void SetLength(Real seconds);
  /** As in the file or as set; 0 = main thread only. */
  UInt32 GetNumThreads() const { return m_settings.NumThreads; }
  /** Overrides the number of threads of the file; call it before loading. */
  void SetNumThreads(UInt32 threads);
  bool IsRealTimeClock() const { return m_settings.IsRealTime; }
  void SetRealTimeClock(bool realTime) { m_settings.IsRealTime = realTime; }
  /** Length of a tick, s. */
  Real GetTickLength() const { return m_context.TickLength; }
  /** Overrides an attribute of the file (`--set`); call it before loading. */
  void AddOverride(const std::string& path, const std::string& value);
  /**
   * Adds an element to `<outputs>`, as options of the command line do; call it before loading.
   * @param tag  label of a CRunOutput. @param attributes  names and values.
   */
  void AddOutput(const std::string& tag,
                 const std::vector<std::pair<std::string, std::string>>& attributes);
  /**
   * Adds an output of the program to the experiment that is loaded: it is called after those of the
   * file, which it does not change.
   * @throws CARGoSException if no experiment is loaded.
   */
  void AddOutput(std::unique_ptr<CRunOutput> output);
  /**
   * Adds a film of the run to `<outputs>` (`--video`), in the view of the first `<offscreen>` in
   * `<visualization>`, if there is one; call it before loading.
   * @param file  its extension chooses the format: .mp4, .webm or .gif.
   * @param speed  the attribute "speed"; empty: that of the element, by default 1.
   */
  void AddVideo(const std::string& file, const std::string& speed = "");
  /**
   * Uses a visualization in place of the children of `<visualization>`; call it before loading.
   * @param tag  of a CVisualization. @param attributes  added to those of its element, if any.
   */
  void SetVisualization(const std::string& tag,
                        const std::vector<std::pair<std::string, std::string>>& attributes);
  /** Paths and values of AddOverride(), of the experiment that is loaded. */
  const std::vector<std::pair<std::string, std::string>>& GetOverrides() const {
    return m_settings.Overrides;
  }
  /** The experiment as XML, with overrides. @throws CARGoSException if none is loaded. */
  std::string GetExperimentText() const;
  /** What watches the run; empty without an experiment. */
  const CRunOutputs& GetOutputs() const;

  /** Ends the experiment at the next check of IsExperimentFinished(). */
  void Terminate() { m_terminated = true; }
  /** The same for a program that is asked to end: a visualization does not wait for its user. */
  void Stop();
  bool IsStopped() const { return m_isStopped; }
  std::string GetInstallationDirectory() const;

  /** Loads from a tree; the document must outlive the experiment. */
  void Load(CConfigurationDocument& document, bool forceNoVisualization = false);
  /**
   * Loads the experiment file of that name. Plug-ins that it names are those of libraries linked
   * to the program, or loaded; for the first that is missing, all libraries in ARGOS_PLUGIN_PATH
   * and beside the core library are loaded, once per process.
   * @throws CARGoSException that reports all errors that can be found without running.
   */
  void LoadExperiment(bool forceNoVisualization = false);
  /**
   * Loads a recording instead of an experiment: the run then shows what was recorded, and ticks
   * advance to the next recorded state. Views and outputs are those of the recording's experiment,
   * or of another file.
   * @throws CARGoSException as LoadExperiment().
   */
  void LoadReplay(const SReplayRequest& request, bool forceNoVisualization = false);
  /** Initialises from the loaded document; called by Load(). */
  void Init();
  /**
   * Restores the initial state: the run can be repeated exactly.
   * @throws CARGoSException if robots, engines or media call it (see CRunState).
   */
  void Reset();
  /** The same with another seed. */
  void Reset(UInt32 newRandomSeed);
  /**
   * Resets, and draws the places of `<distribute>` again from the seed: those that loading the
   * experiment with this seed would draw. Later resets keep them. `<arena redistribute="true">`
   * makes each Reset() do it.
   * @throws CARGoSException as Reset(), or if a body has no free place (call it again with another
   *   seed, or Reset()).
   */
  void Redistribute();
  /** The same with another seed. */
  void Redistribute(UInt32 newRandomSeed);
  /**
   * Destroys the experiment; another one may be loaded.
   * @throws CARGoSException in a tick and during Execute(), with the calling robot or hook: nothing
   *   is destroyed then.
   * @throws the first exception of users' Destroy() functions, after everything is destroyed.
   */
  void Destroy();
  /**
   * Runs the visualization until the experiment ends, and finishes its outputs.
   * @throws CARGoSException in a tick.
   */
  void Execute();
  /** One tick, and its outputs. @throws CARGoSException in a tick. */
  void UpdateSpace();
  bool IsReplay() const;
  /** In a replay: shows the first state at this tick or later. @throws CARGoSException */
  void SeekReplay(UInt32 tick);
  bool IsExperimentFinished() const;
  /**
   * For a process that ends within users' code: finishes and destroys the outputs. In a hook of the
   * loop functions, they see the present state; otherwise what was written until then stays.
   * @throws the first exception, after all outputs are destroyed.
   */
  void CompleteOutputs();

  /** Called after every tick, for progress displays; an empty function stops it. */
  void SetTickObserver(std::function<void(CSimulator&)> observer) {
    m_tickObserver = std::move(observer);
  }
  /** For visualizations that pause: the program may stop the run meanwhile. */
  void CallTickObserver();
  /** The threads on which phases run. */
  CThreadPool& GetThreadPool();

 private:
  friend SSimulationContext& CurrentContext();
  struct SDefaultTag {};
  explicit CSimulator(SDefaultTag);

  explicit CSimulator(std::unique_ptr<CRandom::CRegistry> registry);
  CMedium& GetMediumBase(const std::string& id);
  void ResetRun(bool redistributes);
  void ThrowIfLoaded() const;
  void ShowUnseenTick();
  CRandom::CRegistry& GetRegistry() const;

  CObjectSlabs::TOwner m_slabs;  // memory of the entities, devices and controllers
  std::unique_ptr<CRandom::CRegistry> m_ownRegistry;  // null: the process's default one
  SSimulationContext m_context;
  std::unique_ptr<CSpace> m_space;
  std::unique_ptr<CTick> m_tick;
  std::string m_experimentFileName;
  SRunSettings m_settings;
  std::unique_ptr<SExperimentParts> m_experiment;  // never null; its reset is Destroy()
  std::atomic<bool> m_terminated{false};  // controllers may end the experiment concurrently
  bool m_isStopped = false;
  std::function<void(CSimulator&)> m_tickObserver;
};

}  // namespace argos

#endif
