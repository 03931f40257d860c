#include <argos3/program/catalogue/facts_json.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/support/json_quoting.h>

#include <set>
#include <utility>

namespace argos {

namespace {

// The lines of a value; all but the first are indented by as much as they are inside it.
using TFields = std::vector<std::pair<std::string, std::string>>;
using TItems = std::vector<std::string>;

std::string Enclosed(char open, const TItems& items, char close) {
  std::string text;
  for (const std::string& item : items) {
    text += text.empty() ? "\n" : ",\n";
    text += item;
  }
  Replace(text, "\n", "\n  ");
  return open + text + (items.empty() ? "" : "\n") + close;
}

std::string Object(const TFields& fields) {
  TItems items;
  for (const auto& [key, value] : fields) {
    items.push_back(QuoteForJson(key) + ": " + value);
  }
  return Enclosed('{', items, '}');
}

template <typename LIST, typename WRITE>
std::string Array(const LIST& list, WRITE&& write) {
  TItems items;
  for (const auto& item : list) {
    items.push_back(write(item));
  }
  return Enclosed('[', items, ']');
}

std::string Declarations(const std::vector<SDeclaration>& declarations) {
  return Array(declarations, [](const SDeclaration& declaration) {
    return Object(
        {{"code", QuoteForJson(declaration.Code)}, {"text", QuoteForJson(declaration.Text)}});
  });
}

std::string Type(const STypeText& type) {
  return Object({{"name", QuoteForJson(type.Name)},
                 {"text", QuoteForJson(type.Text)},
                 {"fields", Declarations(type.Fields)}});
}

std::string LuaEntry(const SLuaEntry& lua) {
  return Object({{"path", QuoteForJson(lua.Path)}, {"type", QuoteForJson(lua.Type)}});
}

std::string Robot(const SFit& fit) {
  return Object({{"robot", QuoteForJson(fit.Robot)}, {"needs", QuoteForJson(fit.Part)}});
}

std::string Device(const SDeviceOfRobot& fit) {
  return Object({{"kind", QuoteForJson(fit.Kind->Name)},
                 {"label", QuoteForJson(fit.Label)},
                 {"needs", QuoteForJson(fit.Part)}});
}

std::string Interface(const SDeviceFacts& facts) {
  return Object({{"class", QuoteForJson(facts.Interface.Name)},
                 {"header", QuoteForJson(facts.Class.Header)},
                 {"library", QuoteForJson(facts.Interface.Library)},
                 {"link", QuoteForJson(LinkTargetOf(facts.Interface.Library))},
                 {"text", QuoteForJson(facts.Class.Text)},
                 {"methods", Declarations(facts.Class.Methods)},
                 {"types", Array(facts.Class.Types, Type)}});
}

std::string Attribute(const std::string& element, const std::string& name,
                      const SAttribute& attribute) {
  return Object({{"element", QuoteForJson(element)},
                 {"name", QuoteForJson(name)},
                 {"type", QuoteForJson(NameOf(attribute.Type))},
                 {"unit", QuoteForJson(attribute.Manual.Unit)},
                 {"default", QuoteForJson(attribute.Manual.Default)},
                 {"required", attribute.IsRequired ? "true" : "false"},
                 {"text", QuoteForJson(attribute.Manual.Text)}});
}

// adds those of an element and all inside it. apart: tags of what has an answer of its own
void AddAttributes(const SElement& element, const std::string& path,
                   const std::set<std::string>& apart, TItems& items) {
  for (const auto& [name, attribute] : element.Attributes) {
    // it is a part of the label
    if (name != "implementation") {
      items.push_back(Attribute(path, name, attribute));
    }
  }
  for (const auto& [name, child] : element.Children) {
    if (apart.count(name.Tag) == 0) {
      AddAttributes(child, path + '/' + name.ToLabel(), apart, items);
    }
  }
}

std::string Attributes(const SElement& element, const std::string& path,
                       const std::set<std::string>& apart = {}) {
  TItems items;
  AddAttributes(element, path, apart, items);
  return Enclosed('[', items, ']');
}

// lists tags of plug-ins that have elements
std::set<std::string> TagsOf(const std::vector<SPluginKind>& kinds) {
  std::set<std::string> tags;
  for (const SMatch& match : AllOf(kinds)) {
    if (!match.Kind->Section.empty()) {
      tags.insert(TagOf(match.Plugin->Label));
    }
  }
  return tags;
}

std::string Plugin(const SMatch& match, CCatalogue& catalogue) {
  const auto& [kind, plugin] = match;
  TFields fields = {{"kind", QuoteForJson(kind->Name)},
                    {"list", QuoteForJson(kind->Word)},
                    {"label", QuoteForJson(plugin->Label)},
                    {"brief", QuoteForJson(plugin->Brief)},
                    {"author", QuoteForJson(IsOwn(*plugin) ? "" : plugin->Author)},
                    {"version", QuoteForJson(plugin->Version)},
                    {"status", QuoteForJson(plugin->Status)},
                    {"library", QuoteForJson(plugin->Library)}};
  if (kind->IsOfDevices()) {
    const SDeviceFacts& facts = catalogue.GetDevices().Describe(*kind, plugin->Label);
    fields.insert(fields.end(), {{"interface", Interface(facts)},
                                 {"lua", Array(facts.Lua, LuaEntry)},
                                 {"lua_text", QuoteForJson(facts.Class.Lua)},
                                 {"robots", Array(facts.Robots, Robot)}});
  } else if (kind->Word == "entities") {
    fields.emplace_back("devices",
                        Array(catalogue.GetDevices().ListDevicesOf(plugin->Label), Device));
  }
  if (const SElement* const element = catalogue.FindElement(match)) {
    // the arena would have those of all robots
    const std::set<std::string> apart =
        kind->Word == "elements" ? TagsOf(catalogue.GetKinds()) : std::set<std::string>();
    fields.emplace_back("attributes", Attributes(*element, TagOf(plugin->Label), apart));
  }
  fields.emplace_back("manual", QuoteForJson(plugin->Long));
  return Object(fields);
}

std::string Element(const SElementMatch& match) {
  const std::string path = DescribePath(match.Path);
  const auto attribute = match.Element->Attributes.find(match.Attribute);
  return Object(
      {{"element", QuoteForJson(path)},
       {"attributes",
        attribute == match.Element->Attributes.end()
            ? Attributes(*match.Element, path)
            : Enclosed('[', {Attribute(path, attribute->first, attribute->second)}, ']')}});
}

}  // namespace

std::string WriteJson(const std::string& query, const SAnswer& answer, CCatalogue& catalogue) {
  std::vector<SMatch> matches = answer.Matches;
  for (const SPluginKind* const kind : answer.Lists) {
    for (const SPluginText& plugin : kind->Plugins) {
      matches.push_back({kind, &plugin});
    }
  }
  const auto describe = [&catalogue](const SMatch& match) { return Plugin(match, catalogue); };
  return Object({{"query", QuoteForJson(query)},
                 {"plugins", Array(matches, describe)},
                 {"elements", Array(answer.Elements, Element)},
                 {"suggestions", Array(answer.Suggestions, QuoteForJson)}}) +
         '\n';
}

}  // namespace argos
