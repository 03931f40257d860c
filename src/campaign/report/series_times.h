#ifndef ARGOS3_CAMPAIGN_REPORT_SERIES_TIMES_H
#define ARGOS3_CAMPAIGN_REPORT_SERIES_TIMES_H

// private: the axis of time of figures

#include <argos3/campaign/design/campaign.h>

#include <string>

namespace argos {

/** @return 0 if runs differ in it, or the experiment has none; then times are ticks. */
Real FindTicksPerSecond(const SCampaign& campaign);

/** "time (s)", or "time (ticks)" if @p ticksPerSecond is 0. */
std::string MakeTimeLabel(Real ticksPerSecond);

}  // namespace argos

#endif
