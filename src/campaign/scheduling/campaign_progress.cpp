#include <argos3/campaign/scheduling/campaign_progress.h>

#include <argos3/support/terminal.h>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace argos {

namespace {

constexpr std::chrono::milliseconds kRefreshPeriod(200);  // period in a terminal
constexpr std::chrono::seconds kLinePeriod(10);  // elsewhere
constexpr size_t kBarWidth = 20;  // columns
constexpr UInt32 kMaxHours = 1000;

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
    text += fmt::format(", {} left",
                        DescribeDuration(static_cast<Real>(progress.OpenRuns) / rate, kMaxHours));
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
      m_isTerminal(IsTerminal(STDERR_FILENO)),
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
