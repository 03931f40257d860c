#include <argos3/program/progress.h>

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/support/terminal.h>

#include <fmt/format.h>

#include <unistd.h>

#include <atomic>
#include <iostream>
#include <streambuf>
#include <string_view>

namespace argos {

namespace {

constexpr std::chrono::milliseconds kRefreshPeriod(200);
constexpr UInt32 kMaxHours = 100;

bool GoesToTerminal(const CARGoSLog& log, int file) {
  return IsTerminal(file) && !log.IsRedirected();
}

// lines of CLogControl::Notify()
bool AreNoticesOnTerminal() {
  return !LOG.IsRedirected() && GoesToTerminal(LOGERR, STDERR_FILENO);
}

}  // namespace

std::string DescribeProgress(const SProgress& progress) {
  const Real simulated = progress.Ticks * progress.TickLength;
  const bool measured = progress.Ticks > 0 && progress.WallSeconds > 0.0;
  std::string text = fmt::format("tick {}", progress.Ticks);
  if (progress.MaxTicks > 0) {
    text += fmt::format("/{} ({} %)", progress.MaxTicks,
                        UInt64(progress.Ticks) * 100 / progress.MaxTicks);
  }
  if (progress.MaxTicks > 0 && measured) {
    const Real ticksLeft =
        progress.MaxTicks > progress.Ticks ? progress.MaxTicks - progress.Ticks : 0;
    text +=
        fmt::format(", {} left",
                    DescribeDuration(ticksLeft * progress.WallSeconds / progress.Ticks, kMaxHours));
  }
  if (measured) {
    text += fmt::format(", {:.3g} x real time", simulated / progress.WallSeconds);
  }
  return text + fmt::format(", {:.6g} s simulated", simulated);
}

/* The terminal's last line. Bypasses std::cerr, which may have been redirected to a file. */
class CProgressLine::CScreen {
 public:
  void Draw(const std::string& text) {
    if (m_lineIsOpen) {
      return;
    }
    // a line that wraps around could not be erased
    const size_t width = GetTerminalWidth();
    Write("\r\x1b[K" + text.substr(0, width > 1 ? width - 1 : 1));
    m_visible = true;
  }

  void Erase() {
    if (m_visible.exchange(false)) {
      Write("\r\x1b[K");
    }
  }

  /* Called before other output: an unfinished line must not be overwritten. */
  void NoteText(std::string_view text) {
    Erase();
    const size_t lastBreak = text.rfind('\n');
    const bool ended = lastBreak != std::string_view::npos;
    const bool more = HasVisibleText(ended ? text.substr(lastBreak + 1) : text);
    m_lineIsOpen = more || (m_lineIsOpen && !ended);
  }

 private:
  // escape sequences, such as those of coloured logs, occupy no columns
  static bool HasVisibleText(std::string_view text) {
    for (size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '\x1b') {
        return true;
      }
      i = text.find('m', i);
      if (i == std::string_view::npos) {
        break;
      }
    }
    return false;
  }

  static void Write(const std::string& text) {
    if (::write(STDERR_FILENO, text.data(), text.size()) < 0) {
      return;  // the terminal was closed
    }
  }

  // users' code may print on any thread
  std::atomic<bool> m_visible = false;
  std::atomic<bool> m_lineIsOpen = false;
};

/* Replaces a stream's buffer and erases the progress line before any output. */
class CProgressLine::CGuard : public std::streambuf {
 public:
  CGuard(std::ostream& stream, CScreen& screen)
      : m_stream(stream), m_target(stream.rdbuf()), m_screen(screen) {
    stream.rdbuf(this);
  }
  ~CGuard() override {
    // skip a stream that was redirected in the meantime
    if (m_stream.rdbuf() == this) {
      m_stream.rdbuf(m_target);
    }
  }

 protected:
  int_type overflow(int_type character) override {
    if (traits_type::eq_int_type(character, traits_type::eof())) {
      return traits_type::not_eof(character);
    }
    const char text = traits_type::to_char_type(character);
    m_screen.NoteText(std::string_view(&text, 1));
    return m_target->sputc(text);
  }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    if (size > 0) {
      m_screen.NoteText(std::string_view(text, static_cast<size_t>(size)));
    }
    return m_target->sputn(text, size);
  }
  int sync() override { return m_target->pubsync(); }

 private:
  std::ostream& m_stream;
  std::streambuf* m_target;
  CScreen& m_screen;
};

CProgressLine::CProgressLine(CSimulator& simulator, std::optional<Real> logPeriod)
    : m_simulator(simulator),
      m_start(TClock::now()),
      m_nextDrawing(m_start + kRefreshPeriod),
      m_firstTick(simulator.GetSpace().GetSimulationClock()),
      m_logPeriod(logPeriod.value_or(AreNoticesOnTerminal() ? 0.0 : kLogPeriod)),
      m_nextLogLine(m_start + std::chrono::duration<Real>(m_logPeriod)) {
  if (!IsTerminal(STDERR_FILENO)) {
    return;
  }
  m_screen = std::make_unique<CScreen>();
  if (GoesToTerminal(LOG, STDOUT_FILENO)) {
    m_outGuard = std::make_unique<CGuard>(std::cout, *m_screen);
  }
  if (GoesToTerminal(LOGERR, STDERR_FILENO)) {
    m_errGuard = std::make_unique<CGuard>(std::cerr, *m_screen);
  }
}

CProgressLine::~CProgressLine() {
  if (m_screen) {
    m_screen->Erase();
  }
}

void CProgressLine::Update() {
  if (!m_screen && m_logPeriod == 0.0) {
    return;
  }
  const TClock::time_point now = TClock::now();
  if (m_logPeriod > 0.0 && now >= m_nextLogLine) {
    m_nextLogLine = now + std::chrono::duration<Real>(m_logPeriod);
    CLogControl::Notify(Describe(now));
  }
  if (m_screen && now >= m_nextDrawing) {
    m_nextDrawing = now + kRefreshPeriod;
    m_screen->Draw(Describe(now));
  }
}

std::string CProgressLine::Describe(TClock::time_point now) const {
  SProgress progress;
  const UInt32 maxTicks = m_simulator.GetMaxSimulationClock();
  progress.Ticks = m_simulator.GetSpace().GetSimulationClock() - m_firstTick;
  progress.MaxTicks = maxTicks > m_firstTick ? maxTicks - m_firstTick : 0;
  progress.TickLength = m_simulator.GetTickLength();
  progress.WallSeconds = std::chrono::duration<Real>(now - m_start).count();
  return DescribeProgress(progress);
}

}  // namespace argos
