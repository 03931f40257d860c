#include <argos3/plugins/simulator/visualizations/offscreen/frame_pipeline.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/threads/signal_stack.h>

#include <exception>
#include <new>
#include <utility>

namespace argos {

CFramePipeline::CFramePipeline(const SRenderSettings& settings, TWrite write)
    : m_write(std::move(write)) {
  for (SFrame& frame : m_frames) {
    m_free.push_back(&frame);
  }
  m_drawer = std::thread([this, settings] { Draw(settings); });
  m_writer = std::thread([this] { Write(); });
  std::unique_lock lock(m_mutex);
  m_changed.wait(lock, [this] { return m_isReady; });
  if (m_error != nullptr) {
    m_isClosed = true;
    m_changed.notify_all();
    lock.unlock();
    m_drawer.join();
    m_writer.join();
    std::rethrow_exception(m_error);
  }
}

CFramePipeline::~CFramePipeline() {
  {
    const std::lock_guard lock(m_mutex);
    m_isClosed = true;
  }
  m_changed.notify_all();
  m_drawer.join();
  m_writer.join();
}

CFramePipeline::SFrame& CFramePipeline::Acquire() {
  std::unique_lock lock(m_mutex);
  Abandon();
  m_changed.wait(lock, [this] { return !m_free.empty(); });
  ThrowError(lock);
  m_acquired = m_free.front();
  m_free.pop_front();
  return *m_acquired;
}

void CFramePipeline::Submit() {
  Pass(std::exchange(m_acquired, nullptr), m_toDraw);
}

void CFramePipeline::Finish() {
  std::unique_lock lock(m_mutex);
  Abandon();
  m_changed.wait(lock, [this] { return m_free.size() == kNumFrames; });
  ThrowError(lock);
}

void CFramePipeline::Draw(const SRenderSettings& settings) {
  CSignalStack::Use();
  const CRunningCodeScope running(
      {"a picture is drawn with OpenGL, whose driver crashes if it has too little memory", nullptr,
       "off-screen view", nullptr});
  std::optional<CRenderer> renderer;
  try {
    renderer.emplace(settings);
    m_driver = renderer->DescribeDriver();
  } catch (...) {
    Fail();
  }
  {
    const std::lock_guard lock(m_mutex);
    m_isReady = true;
  }
  m_changed.notify_all();
  while (SFrame* const frame = Take(m_toDraw, m_isClosed)) {
    try {
      if (!m_hasFailed) {
        renderer->Render(frame->Scene, frame->Placement, frame->Picture);
      }
    } catch (...) {
      Fail();
    }
    Pass(frame, m_toWrite);
  }
  {
    const std::lock_guard lock(m_mutex);
    m_isDrawn = true;
  }
  m_changed.notify_all();
}

void CFramePipeline::Write() {
  CSignalStack::Use();
  const CRunningCodeScope running({"a picture is encoded", nullptr, "off-screen view", nullptr});
  while (SFrame* const frame = Take(m_toWrite, m_isDrawn)) {
    try {
      if (!m_hasFailed) {
        m_write(frame->Picture, frame->Tick);
      }
    } catch (...) {
      Fail();
    }
    Pass(frame, m_free);
  }
}

CFramePipeline::SFrame* CFramePipeline::Take(std::deque<SFrame*>& queue, const bool& isOver) {
  std::unique_lock lock(m_mutex);
  m_changed.wait(lock, [&] { return !queue.empty() || isOver; });
  if (queue.empty()) {
    return nullptr;
  }
  SFrame* const frame = queue.front();
  queue.pop_front();
  return frame;
}

void CFramePipeline::Pass(SFrame* frame, std::deque<SFrame*>& queue) {
  {
    const std::lock_guard lock(m_mutex);
    queue.push_back(frame);
  }
  m_changed.notify_all();
}

void CFramePipeline::Fail() {
  std::exception_ptr error = std::current_exception();
  try {
    throw;
  } catch (const std::bad_alloc&) {
    error = std::make_exception_ptr(
        CARGoSException("the off-screen view has not enough memory to draw a picture"));
  } catch (...) {
    // it says what is wrong itself
  }
  const std::lock_guard lock(m_mutex);
  if (m_error == nullptr) {
    m_error = error;
  }
  m_hasFailed = true;
}

void CFramePipeline::Abandon() {
  if (m_acquired != nullptr) {
    m_free.push_back(std::exchange(m_acquired, nullptr));
  }
}

void CFramePipeline::ThrowError(std::unique_lock<std::mutex>& lock) {
  if (m_error != nullptr) {
    // another run may use the frames again
    m_changed.wait(lock, [this] { return m_free.size() == kNumFrames; });
    m_hasFailed = false;
    std::rethrow_exception(std::exchange(m_error, nullptr));
  }
}

}  // namespace argos
