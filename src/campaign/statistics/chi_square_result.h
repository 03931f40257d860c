#ifndef ARGOS3_CAMPAIGN_STATISTICS_CHI_SQUARE_RESULT_H
#define ARGOS3_CAMPAIGN_STATISTICS_CHI_SQUARE_RESULT_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** Result of a test whose statistic is approximately chi-square distributed. */
struct SChiSquareResult {
  Real Statistic;
  size_t DegreesOfFreedom;
  Real PValue;
};

}  // namespace argos

#endif
