#ifndef ARGOS3_CAMPAIGN_SCHEDULING_CAMPAIGN_PROGRESS_H
#define ARGOS3_CAMPAIGN_SCHEDULING_CAMPAIGN_PROGRESS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <chrono>
#include <string>

namespace argos {

/** How far a campaign is. */
struct SCampaignProgress {
  size_t Combinations = 0; /**< number in the campaign */
  size_t CompleteCombinations = 0;
  UInt64 KnownRuns = 0; /**< stored before */
  UInt64 Runs = 0; /**< finished now */
  UInt64 FailedRuns = 0; /**< number of Runs that failed */
  UInt64 OpenRuns = 0; /**< runs without result; an estimate */
  Real WallSeconds = 0.0; /**< time since the start */
};

/**
 * "45/120 runs (37 %), 2 failed, 0:06 left, 3/12 combinations complete, 12.3 runs/s".
 * Without a run, the rate and the time left are omitted.
 */
std::string DescribeCampaignProgress(const SCampaignProgress& progress);

/**
 * Prints the progress on the standard error: a line with a bar that is redrawn in place if that is
 * a terminal, otherwise a line from time to time.
 */
class CCampaignProgressLine : private CNonCopyable {
 public:
  /** @param isQuiet  prints nothing. */
  explicit CCampaignProgressLine(bool isQuiet);
  /** Erases the line in a terminal. */
  ~CCampaignProgressLine();

  /** Draws if it is time to. */
  void Update(const SCampaignProgress& progress);
  /** Draws once more, and leaves the line there. */
  void Finish(const SCampaignProgress& progress);
  /** Prints a line of text; the progress comes below it. */
  void Print(const std::string& text);

 private:
  using TClock = std::chrono::steady_clock;

  void Draw(const SCampaignProgress& progress);
  void Erase();

  bool m_isQuiet;
  bool m_isTerminal;
  bool m_isVisible = false;
  TClock::time_point m_next;
};

}  // namespace argos

#endif
