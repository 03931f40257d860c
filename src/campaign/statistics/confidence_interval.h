#ifndef ARGOS3_CAMPAIGN_STATISTICS_CONFIDENCE_INTERVAL_H
#define ARGOS3_CAMPAIGN_STATISTICS_CONFIDENCE_INTERVAL_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** A closed interval; one-sided ones have an infinite bound. */
struct SConfidenceInterval {
  Real Lower;
  Real Upper;
  Real Level;  // level of confidence: the achieved one, or the requested one if that is unknown
};

}  // namespace argos

#endif
