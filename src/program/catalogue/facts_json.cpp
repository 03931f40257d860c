#include <argos3/program/catalogue/facts_json.h>

#include <argos3/program/catalogue/json_writer.h>
#include <argos3/program/catalogue/manual.h>
#include <argos3/program/catalogue/recorded_grammar.h>

namespace argos {

namespace {

void AddDeclarations(CJsonWriter& json, const std::string& key,
                     const std::vector<SDeclaration>& declarations) {
  json.BeginArray(key);
  for (const SDeclaration& declaration : declarations) {
    json.BeginObject();
    json.Add("code", declaration.Code);
    json.Add("text", declaration.Text);
    json.EndObject();
  }
  json.EndArray();
}

void AddInterface(CJsonWriter& json, const SDeviceFacts& facts) {
  json.BeginObject("interface");
  json.Add("class", facts.Interface);
  json.Add("header", facts.Class.Header);
  json.Add("library", facts.Library);
  json.Add("link", LinkTargetOf(facts.Library));
  json.Add("text", facts.Class.Text);
  AddDeclarations(json, "methods", facts.Class.Methods);
  json.BeginArray("types");
  for (const STypeText& type : facts.Class.Types) {
    json.BeginObject();
    json.Add("name", type.Name);
    json.Add("text", type.Text);
    AddDeclarations(json, "fields", type.Fields);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
}

void AddDevice(CJsonWriter& json, const SDeviceFacts& facts) {
  AddInterface(json, facts);
  json.BeginArray("lua");
  for (const SLuaEntry& entry : facts.Lua) {
    json.BeginObject();
    json.Add("path", entry.Path);
    json.Add("type", entry.Type);
    json.EndObject();
  }
  json.EndArray();
  json.Add("lua_text", facts.Class.Lua);
  json.BeginArray("robots");
  for (const SFit& fit : facts.Robots) {
    json.BeginObject();
    json.Add("robot", fit.Robot);
    json.Add("needs", fit.Part);
    json.EndObject();
  }
  json.EndArray();
}

void AddDevicesOf(CJsonWriter& json, const std::string& robot,
                  const std::vector<SPluginKind>& kinds, CDeviceCatalogue& catalogue) {
  json.BeginArray("devices");
  for (const SPluginKind& kind : kinds) {
    if (kind.Word != "sensors" && kind.Word != "actuators") {
      continue;
    }
    for (const SPluginText& plugin : kind.Plugins) {
      for (const SFit& fit : catalogue.GetFacts(kind.Word, plugin.Label).Robots) {
        if (fit.Robot == robot) {
          json.BeginObject();
          json.Add("kind", kind.Name);
          json.Add("label", plugin.Label);
          json.Add("needs", fit.Part);
          json.EndObject();
        }
      }
    }
  }
  json.EndArray();
}

void AddAttributes(CJsonWriter& json, const SMatch& match, CRecordedGrammar& grammar) {
  const std::string section = CSampleElements::SectionOf(*match.Kind);
  if (section.empty()) {
    return;
  }
  grammar.Record(section, match.Plugin->Label);
  const CManual manual(match.Plugin->Long);
  json.BeginArray("attributes");
  for (const SAttributeFacts& fact : grammar.ListAttributes(section, match.Plugin->Label)) {
    json.BeginObject();
    json.Add("element", fact.Element);
    json.Add("name", fact.Name);
    json.Add("type", fact.Type);
    json.Add("required", fact.IsRequired);
    json.Add("text", manual.TextOf(fact.Element.substr(fact.Element.rfind('/') + 1), fact.Name));
    json.EndObject();
  }
  json.EndArray();
}

void AddPlugin(CJsonWriter& json, const SMatch& match, const std::vector<SPluginKind>& kinds,
               CDeviceCatalogue& catalogue, CRecordedGrammar& grammar) {
  const SPluginText& plugin = *match.Plugin;
  const auto said = [](const std::string& text) { return IsUnsaid(text) ? std::string() : text; };
  const std::string& word = match.Kind->Word;
  json.BeginObject();
  json.Add("kind", match.Kind->Name);
  json.Add("list", word);
  json.Add("label", plugin.Label);
  json.Add("brief", said(plugin.Brief));
  json.Add("author", IsOwnAuthor(plugin.Author) ? std::string() : said(plugin.Author));
  json.Add("version", said(plugin.Version));
  json.Add("status", said(plugin.Status));
  json.Add("library", plugin.Library);
  if (word == "sensors" || word == "actuators") {
    AddDevice(json, catalogue.GetFacts(word, plugin.Label));
  } else if (word == "entities") {
    AddDevicesOf(json, plugin.Label, kinds, catalogue);
  }
  AddAttributes(json, match, grammar);
  json.Add("manual", said(plugin.Long));
  json.EndObject();
}

}  // namespace

std::string WriteJson(const std::string& query, const SAnswer& answer,
                      const std::vector<SPluginKind>& kinds) {
  CDeviceCatalogue catalogue(kinds);
  CRecordedGrammar grammar(catalogue);
  CJsonWriter json;
  json.BeginObject();
  json.Add("query", query);
  json.BeginArray("plugins");
  for (const SPluginKind* const kind : answer.Lists) {
    for (const SPluginText& plugin : kind->Plugins) {
      AddPlugin(json, {kind, &plugin}, kinds, catalogue, grammar);
    }
  }
  for (const SMatch& match : answer.Matches) {
    AddPlugin(json, match, kinds, catalogue, grammar);
  }
  json.EndArray();
  json.BeginArray("suggestions");
  for (const std::string& suggestion : answer.Suggestions) {
    json.Add("", suggestion);
  }
  json.EndArray();
  json.EndObject();
  return json.GetText();
}

}  // namespace argos
