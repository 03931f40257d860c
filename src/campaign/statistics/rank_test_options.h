#ifndef ARGOS3_CAMPAIGN_STATISTICS_RANK_TEST_OPTIONS_H
#define ARGOS3_CAMPAIGN_STATISTICS_RANK_TEST_OPTIONS_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** The hypothesis that a small p value supports. */
enum class EAlternative {
  TwoSided,
  Less,  // x tends to smaller values than y, or than the location
  Greater  // x tends to greater values
};

/** What is taken for the distribution of a statistic under the null hypothesis. */
enum class ENullDistribution {
  Automatic,  // follows R: exact for samples below 50 values without ties (and zeros), else normal
  Normal  // normal approximation with corrections for continuity and ties
};

/** Samples of fewer values get an exact distribution, as in R's wilcox.test(). */
constexpr size_t kExactBelow = 50;

/** Options of Wilcoxon's tests, with the defaults of R's wilcox.test(). */
struct SRankTestOptions {
  EAlternative Alternative = EAlternative::TwoSided;
  Real Location = 0.0;  // null hypothesis: centre of x, of x - y, or shift of x against y
  Real Level = 0.95;  // level of the confidence interval
  ENullDistribution NullDistribution = ENullDistribution::Automatic;
};

}  // namespace argos

#endif
