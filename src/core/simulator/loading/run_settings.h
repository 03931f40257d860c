#ifndef ARGOS3_CORE_SIMULATOR_LOADING_RUN_SETTINGS_H
#define ARGOS3_CORE_SIMULATOR_LOADING_RUN_SETTINGS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/** How an experiment is run: from its file, unless the program that runs it has set something else.
 */
struct SRunSettings {
  /** Of NumThreads. Each thread costs a stack; no machine has more cores. */
  static constexpr UInt32 kMaxThreads = 1024;

  /** An element of `<outputs>`. */
  struct SOutput {
    std::string Tag;
    std::vector<std::pair<std::string, std::string>> Attributes;
    bool IsCopy = false; /**< copies the first element of this tag in `<visualization>`, if any */
    std::vector<std::string> NotCopied; /**< attributes that the copy does not have */
  };

  std::vector<std::pair<std::string, std::string>> Overrides; /**< `--set`: path and value */
  std::vector<SOutput> Outputs; /**< added to those of the file */
  std::optional<SOutput> Visualization; /**< the only child of `<visualization>` */
  bool ForceNoVisualization = false;

  bool IsSeedSet = false; /**< the program has set it */
  bool IsSeedFromClock = true; /**< neither set nor in the file: each Reset() draws another */
  UInt32 Seed = 0;

  bool AreThreadsSet = false; /**< the program has set it */
  UInt32 NumThreads = 0; /**< 0 = main thread only */

  bool IsLengthSet = false; /**< the program has set it */
  Real Length = 0.0; /**< s; 0 = unlimited */
  UInt32 MaxClock = 0; /**< ticks; 0 = unlimited */
  bool IsRealTime = false;

  /** @throws CARGoSException if it is not a length, or has more ticks than can be counted. */
  void SetLength(Real seconds, Real tickLength);
  void DrawSeedFromClock();
  /** Clears what the program has set, which applies to one experiment; values stay readable. */
  void ForgetWhatWasSet();
};

}  // namespace argos

#endif
