#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_PIPELINE_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_FRAME_PIPELINE_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/visualizations/scene/camera.h>
#include <argos3/plugins/simulator/visualizations/offscreen/picture.h>
#include <argos3/plugins/simulator/visualizations/offscreen/renderer.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace argos {

/**
 * Draws and writes frames while the simulation goes on: one thread draws, another one encodes and
 * writes, both in the order of the frames.
 *
 * The number of frames under way is bounded: Acquire() waits until the oldest one is written. So
 * memory is bounded, and pictures are the same as if each was written before the next tick.
 */
class CFramePipeline : private CNonCopyable {
 public:
  /** A frame under way; its memory is reused. */
  struct SFrame {
    SScene Scene;
    SCameraPlacement Placement;
    std::uint32_t Tick = 0;
    SPicture Picture; /**< set by the drawing thread */
  };
  typedef std::function<void(const SPicture&, std::uint32_t tick)> TWrite;

  /**
   * Starts the threads, and makes the renderer, which belongs to the drawing thread.
   * @param write  encodes and writes a picture; called on the writing thread.
   * @throws CARGoSException as CRenderer's constructor.
   */
  CFramePipeline(const SRenderSettings& settings, TWrite write);
  /** Writes the frames that were submitted, unless an earlier one failed. */
  ~CFramePipeline();

  /**
   * A frame to be filled; waits until there is one. One that was not submitted is taken back.
   * @throws whatever drawing or writing an earlier frame threw; the frames after it are discarded.
   */
  SFrame& Acquire();
  /** Hands over the frame acquired last. */
  void Submit();
  /** Waits until all frames are written. @throws as Acquire(). */
  void Finish();

  const std::string& DescribeDriver() const { return m_driver; }

 private:
  static constexpr std::size_t kNumFrames = 4;

  void Draw(const SRenderSettings& settings);
  void Write();
  // the oldest frame of a queue; null at the end
  SFrame* Take(std::deque<SFrame*>& queue, const bool& isOver);
  void Pass(SFrame* frame, std::deque<SFrame*>& queue);
  void Fail();
  // gives back a frame whose filling failed
  void Abandon();
  void ThrowError(std::unique_lock<std::mutex>& lock);

  TWrite m_write;
  std::string m_driver;
  std::array<SFrame, kNumFrames> m_frames;
  SFrame* m_acquired = nullptr;

  // the rest is guarded by the mutex
  std::mutex m_mutex;
  std::condition_variable m_changed;
  std::deque<SFrame*> m_free;
  std::deque<SFrame*> m_toDraw;
  std::deque<SFrame*> m_toWrite;
  bool m_isReady = false;  // the renderer was made, or could not be made
  bool m_isClosed = false;  // no more frames will be submitted
  bool m_isDrawn = false;  // none will be drawn either
  std::exception_ptr m_error;  // the first one, until it is thrown
  std::atomic<bool> m_hasFailed = false;  // the frames after the error are discarded

  std::thread m_drawer;
  std::thread m_writer;
};

}  // namespace argos

#endif
