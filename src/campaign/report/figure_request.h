#ifndef ARGOS3_CAMPAIGN_REPORT_FIGURE_REQUEST_H
#define ARGOS3_CAMPAIGN_REPORT_FIGURE_REQUEST_H

#include <argos3/campaign/report/report_data.h>
#include <argos3/campaign/statistics/series_bands.h>

#include <optional>
#include <string>
#include <vector>

namespace argos {

/** What a figure shows, and how it looks. */
struct SFigureRequest {
  std::string Kind; /**< a name of kFigureKinds; empty: not given */
  std::string X, Y, Z, Group; /**< names of metrics, series and factors; empty: not given */
  std::string Where; /**< Lua expression of the factors; empty: all combinations */
  std::string Title, XLabel, YLabel, ZLabel; /**< empty: made from the names */
  std::string File; /**< name of the files, without ending; empty: made from the names */
  bool IsLogarithmic = false; /**< the axis of the metric; scaling: both always are */
  bool IsXLogarithmic = false; /**< the axis of means is logarithmic */
  bool HasDeviationBars = false; /**< means have standard deviations instead of t intervals */
  std::optional<Real> Reference; /**< is drawn with means: a horizontal line */
  std::string ReferenceLabel; /**< empty: none */
  bool ShowsInterval = false; /**< series are means with intervals, not medians with quartiles */
  EEndedRuns EndedRuns = EEndedRuns::Survivors; /**< treats the ends of series */
  UInt32 Width = 640, Height = 400; /**< pixels of the SVG file */
};

/** "survivors", "hold" or "drop". @throws CARGoSException for another text. */
EEndedRuns ParseEndedRuns(const std::string& text);

/** A figure of a kind, with all else as it is by default. */
SFigureRequest MakeRequest(const std::string& kind, const std::string& y, const std::string& x,
                           const std::string& group = "");

/** @throws CARGoSException if an attribute has a wrong value; the text has file and line. */
SFigureRequest MakeFigureRequest(const SCampaign& campaign, const SFigure& figure);

/**
 * Those of the campaign file; if it has none: a boxplot of each metric, and the course of each
 * series, by the first two factors that have several levels.
 */
std::vector<SFigureRequest> ListFigureRequests(const CReportData& data);

}  // namespace argos

#endif
