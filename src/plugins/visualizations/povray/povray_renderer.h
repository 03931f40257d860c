#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_RENDERER_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_RENDERER_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/visualizations/povray/scene_file.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace argos {

/** How scene files become pictures. */
struct SPovrayJob {
  int Width = 1280; /**< pixels */
  int Height = 960; /**< pixels */
  EPovrayQuality Quality = EPovrayQuality::Good;
  std::uint32_t Threads = 0; /**< threads of POV-Ray; 0: one per core */
  std::string Directory = "."; /**< folder of scene files and pictures */
};

/** The environment variable ARGOS_POVRAY; "povray" if it is not set or empty. */
std::string GetPovrayProgram();

/**
 * @param name  of a file without its folder.
 * @throws CARGoSException if POV-Ray cannot open a file with such a name.
 */
void CheckPovrayName(const std::string& name);

/**
 * The arguments of POV-Ray, which runs in the folder of the scene: distributions restrict it to its
 * working directory and a few others.
 * @param scene, picture  names of files in that folder.
 */
std::vector<std::string> MakePovrayArguments(const SPovrayJob& job, const std::string& scene,
                                             const std::string& picture);

/** The lines of POV-Ray's messages that tell what is wrong; all of them if none is marked so. */
std::string FindPovrayErrors(const std::string& messages);

/**
 * Renders scene files with POV-Ray on a thread of its own, one at a time and in order.
 *
 * At most kMaxWaiting files wait; Submit() blocks meanwhile. A picture has its name only when it
 * is complete.
 */
class CPovrayRenderer : private CNonCopyable {
 public:
  static constexpr std::size_t kMaxWaiting = 2;

  explicit CPovrayRenderer(const SPovrayJob& job);
  /** Waits for the picture under way; discards those that wait. */
  ~CPovrayRenderer();

  /**
   * @param scene  name of a file in the job's folder, which ends in ".pov".
   * @throws CARGoSException of an earlier file that POV-Ray could not render.
   */
  void Submit(const std::string& scene);
  /** Waits until all pictures are complete. @throws as Submit(). */
  void Finish();

 private:
  void Run();
  void Render(const std::string& scene) const;
  void ThrowError();

  SPovrayJob m_job;

  // guarded by the mutex
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::deque<std::string> m_waiting;
  bool m_isRendering = false;
  bool m_isClosed = false;
  std::exception_ptr m_error;  // the first one; what follows is discarded

  std::thread m_thread;  // the last member: it uses the others
};

}  // namespace argos

#endif
