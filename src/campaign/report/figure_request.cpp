#include <argos3/campaign/report/figure_request.h>

#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

#include <map>

namespace argos {

namespace {

UInt32 ParseSide(const std::string& name, const std::string& text) {
  UInt32 side = 0;
  if (ParseNumber(text, side) != ENumberParsing::Ok || side < SFigure::kMinSide ||
      side > SFigure::kMaxSide) {
    THROW_ARGOSEXCEPTION("attribute \"" << name << "\": \"" << text
                                        << "\" is no number of pixels from " << SFigure::kMinSide
                                        << " to " << SFigure::kMaxSide);
  }
  return side;
}

bool ParseScale(const std::string& name, const std::string& text) {
  if (text != "linear" && text != "log") {
    THROW_ARGOSEXCEPTION("attribute \"" << name << "\": \"" << text
                                        << "\" is neither linear nor log");
  }
  return text == "log";
}

bool ParseBars(const std::string& text) {
  if (text != "interval" && text != "deviation") {
    THROW_ARGOSEXCEPTION("attribute \"bars\": \"" << text
                                                  << "\" is neither interval nor deviation");
  }
  return text == "deviation";
}

Real ParseReference(const std::string& text) {
  Real reference = 0.0;
  if (ParseNumber(text, reference) != ENumberParsing::Ok) {
    THROW_ARGOSEXCEPTION("attribute \"reference\": \"" << text << "\" is no finite number");
  }
  return reference;
}

bool ParseBand(const std::string& text) {
  if (text != "quartiles" && text != "interval") {
    THROW_ARGOSEXCEPTION("attribute \"band\": \"" << text
                                                  << "\" is neither quartiles nor interval");
  }
  return text == "interval";
}

void SetAttribute(const std::string& name, const std::string& value, SFigureRequest& request) {
  const std::map<std::string, std::string*> texts = {{"x", &request.X},
                                                     {"y", &request.Y},
                                                     {"z", &request.Z},
                                                     {"group", &request.Group},
                                                     {"title", &request.Title},
                                                     {"xlabel", &request.XLabel},
                                                     {"ylabel", &request.YLabel},
                                                     {"zlabel", &request.ZLabel},
                                                     {"file", &request.File},
                                                     {"where", &request.Where},
                                                     {"reference_label", &request.ReferenceLabel}};
  const auto text = texts.find(name);
  if (text != texts.end()) {
    *text->second = value;
  } else if (name == "width") {
    request.Width = ParseSide(name, value);
  } else if (name == "height") {
    request.Height = ParseSide(name, value);
  } else if (name == "scale") {
    request.IsLogarithmic = ParseScale(name, value);
  } else if (name == "xscale") {
    request.IsXLogarithmic = ParseScale(name, value);
  } else if (name == "band") {
    request.ShowsInterval = ParseBand(value);
  } else if (name == "ended") {
    request.EndedRuns = ParseEndedRuns(value);
  } else if (name == "bars") {
    request.HasDeviationBars = ParseBars(value);
  } else if (name == "reference") {
    request.Reference = ParseReference(value);
  }
}

}  // namespace

EEndedRuns ParseEndedRuns(const std::string& text) {
  if (text == "hold") {
    return EEndedRuns::Hold;
  }
  if (text == "drop") {
    return EEndedRuns::Drop;
  }
  if (text != "survivors") {
    THROW_ARGOSEXCEPTION("attribute \"ended\": \"" << text
                                                   << "\" is none of survivors, hold and drop");
  }
  return EEndedRuns::Survivors;
}

SFigureRequest MakeFigureRequest(const SCampaign& campaign, const SFigure& figure) {
  SFigureRequest request;
  request.Kind = figure.Kind;
  try {
    for (const auto& [name, value] : figure.Attributes) {
      SetAttribute(name, value, request);
    }
  } catch (CARGoSException& error) {
    THROW_ARGOSEXCEPTION_NESTED(campaign.File << ':' << figure.Line << ": <" << figure.Kind << '>',
                                error);
  }
  return request;
}

SFigureRequest MakeRequest(const std::string& kind, const std::string& y, const std::string& x,
                           const std::string& group) {
  SFigureRequest request;
  request.Kind = kind;
  request.X = x;
  request.Y = y;
  request.Group = group;
  return request;
}

// The factor by which the figure is grouped, if it has that many and has a colour for each level.
static std::string FindGroup(const CReportData& data, const std::vector<std::string>& varied,
                             size_t index) {
  const bool isGrouped =
      index < varied.size() && data.GetLevels(data.FindFactor(varied[index])).size() <= kMaxColors;
  return isGrouped ? varied[index] : "";
}

std::vector<SFigureRequest> ListFigureRequests(const CReportData& data) {
  const SCampaign& campaign = data.GetCampaign();
  std::vector<SFigureRequest> requests;
  for (const SFigure& figure : campaign.Figures) {
    requests.push_back(MakeFigureRequest(campaign, figure));
  }
  if (!requests.empty()) {
    return requests;
  }
  std::vector<std::string> varied;
  for (size_t factor = 0; factor < campaign.Factors.size(); ++factor) {
    if (data.GetLevels(factor).size() > 1) {
      varied.push_back(campaign.Factors[factor].Name);
    }
  }
  for (const std::string& metric : data.GetStore().ListMetrics()) {
    if (!varied.empty()) {
      requests.push_back(MakeRequest("boxplot", metric, varied[0], FindGroup(data, varied, 1)));
    }
  }
  for (const std::string& series : data.GetStore().ListSeries()) {
    requests.push_back(MakeRequest("series", series, "", FindGroup(data, varied, 0)));
  }
  return requests;
}

}  // namespace argos
