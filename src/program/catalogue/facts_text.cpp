#include <argos3/program/catalogue/facts_text.h>

#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/text_layout.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace argos {

namespace {

constexpr size_t kIndent = 2;
constexpr size_t kTextIndent = 6;
// column of the units behind fields of types
constexpr size_t kUnitColumn = 40;

std::string Joined(const std::vector<std::string>& texts) {
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string BriefOf(const SPluginText& plugin) {
  return plugin.Brief.empty() ? "(no description)" : plugin.Brief;
}

// "A sensor.", or what users' plug-ins say of themselves: "A sensor by A. Author, version 1.5."
std::string DescribeOrigin(const SMatch& match) {
  const SPluginText& plugin = *match.Plugin;
  const std::string& name = match.Kind->Name;
  const bool isPlural = name.back() == 's';
  const bool hasVowel = std::string("aeiou").find(name.front()) != std::string::npos;
  std::string text = name;
  if (!isPlural) {
    text.insert(0, hasVowel ? "An " : "A ");
  }
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (!IsOwn(plugin)) {
    text += plugin.Author.empty() ? "" : " by " + plugin.Author;
    text += plugin.Version.empty() ? "" : ", version " + plugin.Version;
  }
  const bool isUsable = plugin.Status.empty() || plugin.Status == "Usable";
  return text + (isUsable ? "" : ", status: " + plugin.Status) + ".\n";
}

std::string DescribeLibrary(const std::string& library) {
  const std::string target = LinkTargetOf(library);
  const std::string file = library.substr(library.rfind('/') + 1);
  return target.empty() ? library : target + " (" + file + ")";
}

std::string DescribeDeclaration(const SDeclaration& declaration, size_t indent) {
  const std::string line = std::string(indent, ' ') + declaration.Code;
  const std::string& text = declaration.Text;
  const bool isShort = text.find('\n') == std::string::npos && line.size() < kUnitColumn - 1 &&
                       kUnitColumn + text.size() <= kTextWidth;
  if (text.empty()) {
    return Wrapped(declaration.Code, indent, 4);
  }
  if (isShort) {
    return line + std::string(kUnitColumn - line.size(), ' ') + text + '\n';
  }
  return Wrapped(declaration.Code, indent, 4) + Wrapped(text, indent + 4);
}

std::string DescribeClass(const SDeviceFacts& facts) {
  std::string text = "IN C++\n\n";
  if (facts.Interface.Name.empty()) {
    return text + "  The device has no control interface: controllers cannot use it.\n\n";
  }
  text += "  " + facts.Interface.Name + '\n';
  text += facts.Class.Text.empty() ? "" : Wrapped(facts.Class.Text, kIndent);
  text += facts.Class.Header.empty()
              ? Wrapped("Its header is not known; ARGOS_INCLUDE_PATH may list its folder.", kIndent)
              : "\n  #include <" + facts.Class.Header + ">\n";
  text += "  link " + DescribeLibrary(facts.Interface.Library) + '\n';
  text += facts.Class.Methods.empty() ? "" : "\n";
  for (const SDeclaration& method : facts.Class.Methods) {
    text += DescribeDeclaration(method, kIndent);
  }
  for (const STypeText& type : facts.Class.Types) {
    text +=
        '\n' + Wrapped(type.Text.empty() ? type.Name : type.Name + ": " + type.Text, kIndent, 2);
    for (const SDeclaration& field : type.Fields) {
      text += DescribeDeclaration(field, kTextIndent);
    }
  }
  return text + '\n';
}

// shows a robot's table, and what the header says
std::string DescribeLua(const SDeviceFacts& facts) {
  const std::string& comment = facts.Class.Lua;
  std::string text = "IN LUA\n\n";
  if (facts.Lua.empty() && comment.empty()) {
    return text + "  Nothing.\n\n";
  }
  size_t longest = 0;
  for (const SLuaEntry& entry : facts.Lua) {
    longest = entry.Type == "function" ? longest : std::max(longest, entry.Path.size());
  }
  for (const SLuaEntry& entry : facts.Lua) {
    text += entry.Type == "function"
                ? fmt::format("  {}()\n", entry.Path)
                : fmt::format("  {:{}}  {}\n", entry.Path, longest, entry.Type);
  }
  text += facts.Lua.empty() || comment.empty() ? "" : "\n";
  return text + (comment.empty() ? "" : Wrapped(comment, kIndent)) + '\n';
}

std::string DescribeRobots(const SDeviceFacts& facts) {
  std::string text = "ROBOTS\n\n";
  if (facts.Robots.empty()) {
    // the innermost cause is the last line
    std::string cause = facts.Problem.substr(facts.Problem.rfind('\n') + 1);
    Replace(cause, "[FATAL] ", "");
    return text + Wrapped("None of the loaded libraries: " + cause, kIndent) + '\n';
  }
  std::vector<std::string> robots;
  std::map<std::string, std::vector<std::string>> needy;  // indexed by the part that they need
  for (const SFit& fit : facts.Robots) {
    robots.push_back(fit.Robot);
    if (!fit.Part.empty()) {
      needy[fit.Part].push_back(fit.Robot);
    }
  }
  text += Wrapped(Joined(robots), kIndent);
  for (const auto& [part, some] : needy) {
    text += Wrapped((some.size() == robots.size() ? "each" : Joined(some)) + " with <" + part +
                        "> inside the robot's element",
                    kIndent);
  }
  return text + '\n';
}

std::string DescribeDevicesOf(const std::string& robot, CDevices& devices) {
  std::string text;
  const SPluginKind* previous = nullptr;
  for (const SDeviceOfRobot& device : devices.ListDevicesOf(robot)) {
    if (device.Kind != previous) {
      text += (text.empty() ? "" : "\n") + StringToUpperCase(device.Kind->Word) + " THAT FIT\n\n";
      previous = device.Kind;
    }
    text += "  " + device.Label +
            (device.Part.empty() ? "" : ", with <" + device.Part + "> in its element") + '\n';
  }
  return text.empty() ? "" : text + '\n';
}

std::string DescribeList(const SPluginKind& kind) {
  std::string text = kind.Header + "\n\n";
  for (const SPluginText& plugin : kind.Plugins) {
    text += "   [ " + plugin.Label + " ]\n" + Wrapped(BriefOf(plugin), kTextIndent) + '\n';
  }
  return text;
}

std::string DescribePlugin(const SMatch& match, CCatalogue& catalogue) {
  const SPluginText& plugin = *match.Plugin;
  std::string text = "[ " + plugin.Label + " ]\n" + Wrapped(BriefOf(plugin), 0) + '\n' +
                     Wrapped(DescribeOrigin(match), 0) + '\n';
  if (match.Kind->IsOfDevices()) {
    const SDeviceFacts& facts = catalogue.GetDevices().Describe(*match.Kind, plugin.Label);
    text += DescribeClass(facts) + DescribeLua(facts) + DescribeRobots(facts);
  } else if (!IsOwn(plugin) && !plugin.Library.empty()) {
    text += Wrapped("In the library " + plugin.Library, 0, kIndent) + '\n';
  }
  if (match.Kind->Word == "entities") {
    text += DescribeDevicesOf(plugin.Label, catalogue.GetDevices());
  }
  if (!plugin.Long.empty()) {
    text += "IN EXPERIMENT FILES\n\n" + WrappedManual(plugin.Long) + '\n';
    if (plugin.Long.find("ATTRIBUTES") != std::string::npos) {
      text += WrappedManual(kRangesDocumentation) + '\n';
    }
  }
  for (const SPluginKind& kind : catalogue.GetKinds()) {
    text += kind.Of == plugin.Label ? DescribeList(kind) : "";
  }
  return text;
}

std::string DescribeAttribute(const std::string& name, const SAttribute& attribute) {
  return fmt::format("  {}  {}{}\n", name, NameOf(attribute.Type),
                     attribute.IsRequired ? ", required" : "") +
         (attribute.Manual.Text.empty() ? "" : Wrapped(attribute.Manual.Text, kTextIndent));
}

std::string DescribeAttributes(const SElementMatch& match) {
  std::string text;
  for (const auto& [name, attribute] : match.Element->Attributes) {
    if (match.Attribute.empty() || match.Attribute == name) {
      text += DescribeAttribute(name, attribute);
    }
  }
  std::vector<std::string> children;
  for (const auto& [name, child] : match.Element->Children) {
    children.push_back('<' + name.Tag + '>');
  }
  if (match.Attribute.empty() && !children.empty()) {
    text += Wrapped("may contain " + Joined(children), kIndent, kIndent);
  }
  return text.empty() ? "  It has no attributes.\n" : text;
}

// elements of which the same is said are named together
std::string DescribeElements(const std::string& query, const std::vector<SElementMatch>& matches) {
  std::vector<std::pair<std::string, std::vector<std::string>>> groups;
  for (const SElementMatch& match : matches) {
    const std::string text = DescribeAttributes(match);
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const auto& group) { return group.first == text; });
    auto& paths = known == groups.end()
                      ? groups.emplace_back(text, std::vector<std::string>()).second
                      : known->second;
    paths.push_back(DescribePath(match.Path));
  }
  std::string text = "[ " + query + " ]\nIn experiment files.\n\n";
  for (const auto& [facts, paths] : groups) {
    text += Wrapped(Joined(paths), 0, kIndent) + facts + '\n';
  }
  return text;
}

}  // namespace

std::string WriteText(const std::string& query, const SAnswer& answer, CCatalogue& catalogue) {
  if (!answer.IsFound()) {
    return "Nothing found: no plug-in has a name that contains \"" + query +
           "\", and no element or attribute has this name" +
           (answer.Suggestions.empty() ? "; argos3 -q all lists all\n"
                                       : "; did you mean " + Joined(answer.Suggestions) + "?\n");
  }
  std::string text;
  for (const SPluginKind* const kind : answer.Lists) {
    text += DescribeList(*kind);
  }
  const std::string line = std::string(kTextWidth - 2, '=') + '\n';
  for (const SMatch& match : answer.Matches) {
    text += (text.empty() ? "" : line) + DescribePlugin(match, catalogue);
  }
  if (!answer.Elements.empty()) {
    text += (text.empty() ? "" : line) + DescribeElements(query, answer.Elements);
  }
  return text + (answer.Others.empty() ? "" : Wrapped("See also: " + Joined(answer.Others), 0, 2));
}

}  // namespace argos
