#ifndef ARGOS3_CAMPAIGN_STATISTICS_CONFIDENCE_INTERVAL_H
#define ARGOS3_CAMPAIGN_STATISTICS_CONFIDENCE_INTERVAL_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** A closed interval; one-sided ones have an infinite bound. */
struct SConfidenceInterval {
  Real Lower;
  Real Upper;
  Real Level;  // of confidence: what was achieved where that can be computed, else what was asked
};

}  // namespace argos

#endif
