#include <argos3/program/catalogue/facts_text.h>

#include <argos3/core/utility/configuration/value_range.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/device_facts.h>
#include <argos3/program/catalogue/text_layout.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace argos {

namespace {

constexpr size_t kIndent = 2;
constexpr size_t kTextIndent = 6;
// column of the units behind fields of types
constexpr size_t kUnitColumn = 40;

std::string Joined(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) {
    joined += (joined.empty() ? "" : ", ") + text;
  }
  return joined;
}

std::string BriefOf(const SPluginText& plugin) {
  return IsUnsaid(plugin.Brief) ? "(no description)" : plugin.Brief;
}

// "A sensor.", or what users' plug-ins say of themselves: "A sensor by A. Author, version 1.5."
std::string DescribeOrigin(const SMatch& match) {
  const SPluginText& plugin = *match.Plugin;
  const std::string& name = match.Kind->Name;
  const bool isPlural = name.back() == 's';
  const bool hasVowel = std::string("aeiou").find(name.front()) != std::string::npos;
  std::string text = isPlural ? "" : hasVowel ? "An " : "A ";
  text += name;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (!IsOwnAuthor(plugin.Author)) {
    text += IsUnsaid(plugin.Author) ? "" : " by " + plugin.Author;
    text += IsUnsaid(plugin.Version) ? "" : ", version " + plugin.Version;
  }
  text += IsUnsaid(plugin.Status) || plugin.Status == "Usable" ? "" : ", status: " + plugin.Status;
  return text + ".\n";
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
  if (facts.Interface.empty()) {
    return text + "  The device has no control interface: controllers cannot use it.\n\n";
  }
  text += "  " + facts.Interface + '\n';
  text += facts.Class.Text.empty() ? "" : Wrapped(facts.Class.Text, kIndent);
  text += facts.Class.Header.empty()
              ? Wrapped("Its header is not known; ARGOS_INCLUDE_PATH may list its folder.", kIndent)
              : "\n  #include <" + facts.Class.Header + ">\n";
  text += "  link " + DescribeLibrary(facts.Library) + '\n';
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

std::string DescribeLua(const SDeviceFacts& facts) {
  std::string text = "IN LUA\n\n";
  if (facts.Lua.empty()) {
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
  return text + (facts.Class.Lua.empty() ? "" : '\n' + Wrapped(facts.Class.Lua, kIndent)) + '\n';
}

// "magnets" of a robot that needs that element
std::string DescribeRobots(const SDeviceFacts& facts) {
  std::string text = "ROBOTS\n\n";
  std::vector<std::string> robots;
  std::vector<std::string> parts;
  for (const SFit& fit : facts.Robots) {
    robots.push_back(fit.Robot);
    if (!fit.Part.empty() && std::find(parts.begin(), parts.end(), fit.Part) == parts.end()) {
      parts.push_back(fit.Part);
    }
  }
  if (robots.empty()) {
    // the innermost cause is the last line
    const std::string& problem = facts.Problem;
    std::string cause = problem.substr(problem.rfind('\n') + 1);
    Replace(cause, "[FATAL] ", "");
    return text + Wrapped("None of the loaded libraries: " + cause, kIndent) + '\n';
  }
  text += Wrapped(Joined(robots), kIndent);
  for (const std::string& part : parts) {
    std::vector<std::string> needy;
    for (const SFit& fit : facts.Robots) {
      if (fit.Part == part) {
        needy.push_back(fit.Robot);
      }
    }
    text += Wrapped((needy.size() == robots.size() ? "each" : Joined(needy)) + " with <" + part +
                        "> inside the robot's element",
                    kIndent);
  }
  return text + '\n';
}

std::string DescribeDevicesOf(const std::string& robot, const std::vector<SPluginKind>& kinds,
                              CDeviceCatalogue& catalogue) {
  std::string text;
  for (const SPluginKind& kind : kinds) {
    if (kind.Word != "sensors" && kind.Word != "actuators") {
      continue;
    }
    std::vector<std::string> labels;
    for (const SPluginText& plugin : kind.Plugins) {
      for (const SFit& fit : catalogue.GetFacts(kind.Word, plugin.Label).Robots) {
        if (fit.Robot == robot) {
          labels.push_back(plugin.Label +
                           (fit.Part.empty() ? "" : ", with <" + fit.Part + "> in its element"));
        }
      }
    }
    if (!labels.empty()) {
      text += kind.Word == "sensors" ? "SENSORS THAT FIT\n\n" : "ACTUATORS THAT FIT\n\n";
      for (const std::string& label : labels) {
        text += "  " + label + '\n';
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace

std::string DescribeList(const SPluginKind& kind) {
  std::string text = kind.Header + "\n\n";
  for (const SPluginText& plugin : kind.Plugins) {
    text += "   [ " + plugin.Label + " ]\n" + Wrapped(BriefOf(plugin), kTextIndent) + '\n';
  }
  return text;
}

std::string DescribePlugin(const SMatch& match, const std::vector<SPluginKind>& kinds,
                           CDeviceCatalogue& catalogue) {
  const SPluginText& plugin = *match.Plugin;
  const std::string& word = match.Kind->Word;
  std::string text = "[ " + plugin.Label + " ]\n" + Wrapped(BriefOf(plugin), 0) + '\n' +
                     Wrapped(DescribeOrigin(match), 0) + '\n';
  if (word == "sensors" || word == "actuators") {
    const SDeviceFacts& facts = catalogue.GetFacts(word, plugin.Label);
    text += DescribeClass(facts) + DescribeLua(facts) + DescribeRobots(facts);
  } else if (!IsOwnAuthor(plugin.Author) && !plugin.Library.empty()) {
    text += Wrapped("In the library " + plugin.Library, 0, kIndent) + '\n';
  }
  if (word == "entities") {
    text += DescribeDevicesOf(plugin.Label, kinds, catalogue);
  }
  if (!IsUnsaid(plugin.Long)) {
    text += "IN EXPERIMENT FILES\n\n" + WrappedManual(plugin.Long) + '\n';
    if (plugin.Long.find("ATTRIBUTES") != std::string::npos) {
      text += WrappedManual(kRangesDocumentation) + '\n';
    }
  }
  for (const SPluginKind& kind : kinds) {
    if (kind.Of == plugin.Label) {
      text += DescribeList(kind);
    }
  }
  return text;
}

std::string DescribeNothing(const std::string& query, const SAnswer& answer) {
  return "Nothing found: no plug-in has a name that contains \"" + query + '"' +
         (answer.Suggestions.empty() ? "; argos3 -q all lists all\n"
                                     : "; did you mean " + Joined(answer.Suggestions) + "?\n");
}

}  // namespace argos
