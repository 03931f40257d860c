#ifndef ARGOS3_CAMPAIGN_REPORT_FIGURE_PARTS_H
#define ARGOS3_CAMPAIGN_REPORT_FIGURE_PARTS_H

// private: what the kinds of figures share

#include <argos3/campaign/report/figures.h>

#include <optional>
#include <string>
#include <vector>

namespace argos {

/** The levels of a figure's group; one without name if there is none. */
class CFigureGroups {
 public:
  /** @throws CARGoSException if the factor is unknown, or has more levels than there are colours.
   */
  CFigureGroups(const CReportData& data, const std::string& factor);

  size_t GetCount() const { return m_factor ? m_data.GetLevels(*m_factor).size() : 1; }
  size_t GetGroup(size_t combination) const;
  /** "robots = 5"; empty if there is no group. */
  std::string GetTitle(size_t group) const;
  /** ` title '...'` or ` notitle`, of a plot element. */
  std::string MakeKey(size_t group, const std::string& addition = "") const;

 private:
  const CReportData& m_data;
  std::optional<size_t> m_factor;
};

/** @throws CARGoSException if a name is missing. */
void RequireName(const SFigureRequest& request, const char* attribute, const std::string& value);
/** @throws CARGoSException if the axis of a metric is logarithmic, and a value is not positive. */
void RequirePositive(const std::string& metric, Real value);

/** The label of a metric or a series with its unit, unless the request has one. */
std::string MakeMetricLabel(const CReportData& data, const std::string& name, bool isSeries,
                            const std::string& wanted);

/**
 * Commands for a linear y axis that shows values from @p low to @p high, with space above. If no
 * value is negative, it begins at 0, or, if more than half of it would be empty, above.
 */
std::string MakeValueAxis(Real low, Real high);

/** " Runs at all levels of speed are taken together."; empty if no varied factor is left. */
std::string DescribePooled(const CReportData& data, const std::vector<std::string>& shown);

/** "10 runs" or "8 to 10 runs". */
std::string DescribeCounts(const std::vector<size_t>& counts);

SFigureDraft MakeBoxplot(const CReportData& data, const SFigureRequest& request);
SFigureDraft MakeSeriesFigure(const CReportData& data, const SFigureRequest& request);
SFigureDraft MakeDifferenceFigure(const CReportData& data, const SFigureRequest& request);
SFigureDraft MakeMeansFigure(const CReportData& data, const SFigureRequest& request);
SFigureDraft MakeScalingFigure(const CReportData& data, const SFigureRequest& request);
SFigureDraft MakeHeatmap(const CReportData& data, const SFigureRequest& request);

}  // namespace argos

#endif
