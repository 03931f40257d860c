#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_PICTURE_SINK_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_PICTURE_SINK_H

#include <argos3/plugins/simulator/visualizations/offscreen/picture.h>

#include <cstdint>
#include <string>

namespace argos {

/**
 * Takes the pictures of runs, one run after the other: into numbered files, or into films.
 *
 * Begin() and Finish() are called by the thread that steps the simulator, Write() by another one,
 * never at the same time.
 */
class CPictureSink {
 public:
  virtual ~CPictureSink() = default;

  /** Prepares the output of a run. @throws CARGoSException if that is not possible. */
  virtual void Begin() = 0;

  /**
   * Takes the next picture; all of a run have the same size.
   * @throws CARGoSException if it cannot be written; the run's output ends, and Finish() does
   *   nothing.
   */
  virtual void Write(const SPicture& picture, std::uint32_t tick) = 0;

  /**
   * Completes the output of the run, after its last picture. Does nothing without Begin().
   * @throws CARGoSException if it cannot be completed.
   */
  virtual void Finish() = 0;

  /**
   * What happens from Begin() on, for the log.
   * @param width, height  of the pictures, pixels. @param every  ticks from picture to picture.
   */
  virtual std::string Describe(int width, int height, std::uint32_t every) const = 0;
};

}  // namespace argos

#endif
