#include <argos3/program/query_plugins.h>

#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/program/catalogue/answer.h>
#include <argos3/program/catalogue/device_facts.h>
#include <argos3/program/catalogue/facts_json.h>
#include <argos3/program/catalogue/facts_text.h>
#include <argos3/program/catalogue/plugin_kinds.h>
#include <argos3/program/catalogue/text_layout.h>

#include <vector>

namespace argos {

namespace {

std::string WriteText(const std::string& query, const SAnswer& answer,
                      const std::vector<SPluginKind>& kinds) {
  if (!answer.IsFound()) {
    return DescribeNothing(query, answer);
  }
  std::string text;
  for (const SPluginKind* const kind : answer.Lists) {
    text += DescribeList(*kind);
  }
  if (!answer.Matches.empty()) {
    CDeviceCatalogue catalogue(kinds);
    for (const SMatch& match : answer.Matches) {
      text += text.empty() ? "" : std::string(kTextWidth - 2, '=') + '\n';
      text += DescribePlugin(match, kinds, catalogue);
    }
  }
  if (!answer.Others.empty()) {
    const std::string others = JoinItems(answer.Others);
    text += Wrapped("See also: " + others, 0, 2);
  }
  return text;
}

}  // namespace

SPluginAnswer AnswerQuery(const std::string& query, bool asJson) {
  const std::vector<SPluginKind> kinds = ListPluginKinds();
  const SAnswer answer = FindAnswer(query, kinds);
  return {asJson ? WriteJson(query, answer, kinds) : WriteText(query, answer, kinds),
          answer.IsFound()};
}

std::string DescribePlugins(const std::string& query) {
  return AnswerQuery(query).Text;
}

void PrintPlain(const std::string& text) {
  const bool colored = LOG.IsColoredOutput();
  LOG.DisableColoredOutput();
  LOG << text;
  LOG.Flush();
  if (colored) {
    LOG.EnableColoredOutput();
  }
}

bool QueryPlugins(const std::string& query, bool asJson) {
  const SPluginAnswer answer = AnswerQuery(query, asJson);
  PrintPlain(answer.Text);
  return answer.IsFound;
}

}  // namespace argos
