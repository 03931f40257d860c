#include <argos3/program/query_plugins.h>

#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/program/catalogue/facts_json.h>
#include <argos3/program/catalogue/facts_text.h>

namespace argos {

SPluginAnswer AnswerQuery(const std::string& query, bool asJson) {
  CCatalogue catalogue;
  const SAnswer answer = catalogue.Find(query);
  return {asJson ? WriteJson(query, answer, catalogue) : WriteText(query, answer, catalogue),
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
