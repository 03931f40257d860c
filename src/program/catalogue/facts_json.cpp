#include <argos3/program/catalogue/facts_json.h>

#include <argos3/core/utility/text/utf8.h>

#include <fmt/format.h>

#include <set>
#include <string_view>
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
    items.push_back(JsonQuoted(key) + ": " + value);
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
    return Object({{"code", JsonQuoted(declaration.Code)}, {"text", JsonQuoted(declaration.Text)}});
  });
}

std::string Type(const STypeText& type) {
  return Object({{"name", JsonQuoted(type.Name)},
                 {"text", JsonQuoted(type.Text)},
                 {"fields", Declarations(type.Fields)}});
}

std::string LuaEntry(const SLuaEntry& lua) {
  return Object({{"path", JsonQuoted(lua.Path)}, {"type", JsonQuoted(lua.Type)}});
}

std::string Robot(const SFit& fit) {
  return Object({{"robot", JsonQuoted(fit.Robot)}, {"needs", JsonQuoted(fit.Part)}});
}

std::string Device(const SDeviceOfRobot& fit) {
  return Object({{"kind", JsonQuoted(fit.Kind->Name)},
                 {"label", JsonQuoted(fit.Label)},
                 {"needs", JsonQuoted(fit.Part)}});
}

std::string Interface(const SDeviceFacts& facts) {
  return Object({{"class", JsonQuoted(facts.Interface.Name)},
                 {"header", JsonQuoted(facts.Class.Header)},
                 {"library", JsonQuoted(facts.Interface.Library)},
                 {"link", JsonQuoted(LinkTargetOf(facts.Interface.Library))},
                 {"text", JsonQuoted(facts.Class.Text)},
                 {"methods", Declarations(facts.Class.Methods)},
                 {"types", Array(facts.Class.Types, Type)}});
}

std::string Attribute(const std::string& element, const std::string& name,
                      const SAttribute& attribute) {
  return Object({{"element", JsonQuoted(element)},
                 {"name", JsonQuoted(name)},
                 {"type", JsonQuoted(NameOf(attribute.Type))},
                 {"unit", JsonQuoted(attribute.Manual.Unit)},
                 {"default", JsonQuoted(attribute.Manual.Default)},
                 {"required", attribute.IsRequired ? "true" : "false"},
                 {"text", JsonQuoted(attribute.Manual.Text)}});
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
  TFields fields = {{"kind", JsonQuoted(kind->Name)},
                    {"list", JsonQuoted(kind->Word)},
                    {"label", JsonQuoted(plugin->Label)},
                    {"brief", JsonQuoted(plugin->Brief)},
                    {"author", JsonQuoted(IsOwn(*plugin) ? "" : plugin->Author)},
                    {"version", JsonQuoted(plugin->Version)},
                    {"status", JsonQuoted(plugin->Status)},
                    {"library", JsonQuoted(plugin->Library)}};
  if (kind->IsOfDevices()) {
    const SDeviceFacts& facts = catalogue.GetDevices().Describe(*kind, plugin->Label);
    fields.insert(fields.end(), {{"interface", Interface(facts)},
                                 {"lua", Array(facts.Lua, LuaEntry)},
                                 {"lua_text", JsonQuoted(facts.Class.Lua)},
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
  fields.emplace_back("manual", JsonQuoted(plugin->Long));
  return Object(fields);
}

std::string Element(const SElementMatch& match) {
  const std::string path = DescribePath(match.Path);
  const auto attribute = match.Element->Attributes.find(match.Attribute);
  return Object(
      {{"element", JsonQuoted(path)},
       {"attributes",
        attribute == match.Element->Attributes.end()
            ? Attributes(*match.Element, path)
            : Enclosed('[', {Attribute(path, attribute->first, attribute->second)}, ']')}});
}

}  // namespace

std::string JsonQuoted(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = CountUtf8Bytes(std::string_view(text).substr(at));
    const char c = text[at];
    if (size == 0) {
      quoted += "\\ufffd";
    } else if (size > 1) {
      quoted += text.substr(at, size);
    } else if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
    at += size == 0 ? 1 : size;
  }
  return quoted + '"';
}

std::string WriteJson(const std::string& query, const SAnswer& answer, CCatalogue& catalogue) {
  std::vector<SMatch> matches = answer.Matches;
  for (const SPluginKind* const kind : answer.Lists) {
    for (const SPluginText& plugin : kind->Plugins) {
      matches.push_back({kind, &plugin});
    }
  }
  const auto describe = [&catalogue](const SMatch& match) { return Plugin(match, catalogue); };
  return Object({{"query", JsonQuoted(query)},
                 {"plugins", Array(matches, describe)},
                 {"elements", Array(answer.Elements, Element)},
                 {"suggestions", Array(answer.Suggestions, JsonQuoted)}}) +
         '\n';
}

}  // namespace argos
