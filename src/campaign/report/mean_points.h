#ifndef ARGOS3_CAMPAIGN_REPORT_MEAN_POINTS_H
#define ARGOS3_CAMPAIGN_REPORT_MEAN_POINTS_H

// private: means against a factor or a metric, of the figures "means" and "scaling"

#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/statistics/power_law_fit.h>

#include <string>
#include <vector>

namespace argos {

struct SMeanPoint {
  Real X, Mean, Lower, Upper;
  size_t Count; /**< runs */
};

struct SGroupMeans {
  std::vector<Real> X, Y; /**< (runs) */
  std::vector<SMeanPoint> Points; /**< ascending in x */
  std::vector<SPowerLawSample> Samples; /**< (Points) the runs of each, at its X */
};

/** The means of the metric Y of a figure, with t intervals or deviations, at the levels or values
 * of X. */
struct SMeans {
  bool IsXMetric = false; /**< then a point is a combination, at the mean of its values */
  std::vector<SGroupMeans> Groups;
  /** On a logarithmic y axis: runs that count in means only, and means that are left out. */
  size_t NumRunsNotPositive = 0, NumMeansNotPositive = 0;

  /**
   * On a logarithmic y axis means that are not positive are left out, and bounds of intervals that
   * are not positive end below all other points.
   * @throws CARGoSException if X or Y is unknown, X has levels that are no numbers, there are no
   *   finite values, or, on a logarithmic axis, x is not positive or no mean is positive.
   */
  static SMeans Collect(const CReportData& data, const SFigureRequest& request,
                        const CFigureGroups& groups);

  /** A block of data for each group. */
  std::string MakeData(const SFigureRequest& request, const CFigureGroups& groups) const;
  /** Style, labels, ranges and tics. */
  std::string MakeFrame(const CReportData& data, const SFigureRequest& request) const;
  /** "10 runs" or "8 to 10 runs": of a point. */
  std::string DescribePointCounts() const;
  /** What a caption says about values that a logarithmic axis cannot show; may be empty. */
  std::string DescribeNotPositive() const;
};

/** The plot element of a group's points with error bars. @param key  see CFigureGroups. */
std::string MakePointsPlot(size_t group, const std::string& key);

}  // namespace argos

#endif
