#include <argos3/campaign/scheduling/campaign_progress.h>

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace argos {

namespace {

constexpr std::chrono::milliseconds kRefreshPeriod(200);  // period in a terminal
constexpr std::chrono::seconds kLinePeriod(10);  // elsewhere
constexpr size_t kBarWidth = 20;  // columns

bool IsTerminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && (kind == nullptr || std::string_view(kind) != "dumb");
}

size_t GetTerminalWidth() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string DescribeTime(Real seconds) {
  if (!(seconds < 1000.0 * 3600.0)) {
    return "more than 1000 h";
  }
  const auto whole = static_cast<UInt64>(std::lround(seconds));
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

UInt64 CountAll(const SCampaignProgress& progress) {
  return progress.KnownRuns + progress.Runs + progress.OpenRuns;
}

std::string DrawBar(const SCampaignProgress& progress) {
  const UInt64 finished = progress.KnownRuns + progress.Runs;
  const size_t filled =
      static_cast<size_t>(finished * kBarWidth / std::max<UInt64>(1, CountAll(progress)));
  return fmt::format("[{}{}] ", std::string(filled, '#'), std::string(kBarWidth - filled, '.'));
}

}  // namespace

std::string DescribeCampaignProgress(const SCampaignProgress& progress) {
  const UInt64 finished = progress.KnownRuns + progress.Runs;
  const UInt64 all = CountAll(progress);
  std::string text =
      fmt::format("{}/{} runs ({} %)", finished, all, all > 0 ? finished * 100 / all : 100);
  if (progress.FailedRuns > 0) {
    text += fmt::format(", {} failed", progress.FailedRuns);
  }
  const bool hasRate = progress.Runs > 0 && progress.WallSeconds > 0.0;
  const Real rate = hasRate ? static_cast<Real>(progress.Runs) / progress.WallSeconds : 0.0;
  // a terminal may cut the end of the line
  if (hasRate && progress.OpenRuns > 0) {
    text += fmt::format(", {} left", DescribeTime(static_cast<Real>(progress.OpenRuns) / rate));
  }
  text += fmt::format(", {}/{} combinations complete", progress.CompleteCombinations,
                      progress.Combinations);
  if (hasRate) {
    text += fmt::format(", {:.3g} runs/s", rate);
  }
  return text;
}

CCampaignProgressLine::CCampaignProgressLine(bool isQuiet)
    : m_isQuiet(isQuiet),
      m_isTerminal(IsTerminal()),
      m_next(TClock::now() +
             (m_isTerminal ? TClock::duration(kRefreshPeriod) : TClock::duration(kLinePeriod))) {}

CCampaignProgressLine::~CCampaignProgressLine() {
  Erase();
}

void CCampaignProgressLine::Update(const SCampaignProgress& progress) {
  if (!m_isQuiet && TClock::now() >= m_next) {
    Draw(progress);
  }
}

void CCampaignProgressLine::Finish(const SCampaignProgress& progress) {
  if (m_isQuiet) {
    return;
  }
  Draw(progress);
  if (m_isTerminal) {
    std::fputc('\n', stderr);
    m_isVisible = false;
  }
}

void CCampaignProgressLine::Print(const std::string& text) {
  Erase();
  std::fprintf(stderr, "%s\n", text.c_str());
}

void CCampaignProgressLine::Draw(const SCampaignProgress& progress) {
  const std::string text = DescribeCampaignProgress(progress);
  if (m_isTerminal) {
    // a line that wraps around could not be erased
    const size_t width = std::max<size_t>(2, GetTerminalWidth());
    std::fprintf(stderr, "\r\x1b[K%s", (DrawBar(progress) + text).substr(0, width - 1).c_str());
    std::fflush(stderr);
    m_isVisible = true;
    m_next = TClock::now() + kRefreshPeriod;
  } else {
    std::fprintf(stderr, "%s\n", text.c_str());
    m_next = TClock::now() + kLinePeriod;
  }
}

void CCampaignProgressLine::Erase() {
  if (m_isVisible) {
    std::fputs("\r\x1b[K", stderr);
    m_isVisible = false;
  }
}

}  // namespace argos
