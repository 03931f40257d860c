#include <argos3/program/catalogue/relax_ng_compact.h>

#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

namespace argos {

namespace {

std::string Write(TConfigurationNode& pattern, size_t depth);

std::string Quoted(const std::string& text) {
  // no escapes inside quotation marks; three of them allow one inside
  const char* const quote = text.find('"') == std::string::npos ? "\"" : "\"\"\"";
  return fmt::format("{0}{1}{0}", quote, text);
}

// the patterns inside one, each on a line
std::string Join(TConfigurationNode& parent, const std::string& sign, size_t depth) {
  std::string text;
  TConfigurationNodeIterator it;
  for (it = it.begin(&parent); it != it.end(); ++it) {
    if (it->Value() != "anyName" && it->Value() != "a:documentation") {
      text += text.empty() ? std::string() : fmt::format("{}\n{:{}}", sign, "", 2 * depth);
      text += Write(*it, depth);
    }
  }
  return text;
}

// names that are words of the syntax need no backslash here: they follow "element" or "attribute"
std::string NameOf(TConfigurationNode& pattern) {
  if (!NodeExists(pattern, "anyName")) {
    return pattern.GetAttribute("name");
  }
  TConfigurationNode& any = GetNode(pattern, "anyName");
  if (!NodeExists(any, "except")) {
    return "*";
  }
  std::string names;
  TConfigurationNodeIterator it;
  for (it = it.begin(&GetNode(any, "except")); it != it.end(); ++it) {
    names += (names.empty() ? "" : " | ") + it->GetText();
  }
  return "* - (" + names + ")";
}

std::string WriteNamed(TConfigurationNode& pattern, size_t depth) {
  std::string documentation;
  if (NodeExists(pattern, "a:documentation")) {
    const std::string indent(2 * depth, ' ');
    documentation = GetNode(pattern, "a:documentation").GetText();
    Replace(documentation, "\n", fmt::format("\n{}## ", indent));
    documentation = "## " + documentation + '\n' + indent;
  }
  return fmt::format("{}{} {} {{ {} }}", documentation, pattern.Value(), NameOf(pattern),
                     Join(pattern, ",", depth + 1));
}

std::string Write(TConfigurationNode& pattern, size_t depth) {
  std::string kind = pattern.Value();
  if (kind == "element" || kind == "attribute") {
    return WriteNamed(pattern, depth);
  }
  if (kind == "choice") {
    return '(' + Join(pattern, " |", depth) + ')';
  }
  if (kind == "optional" || kind == "zeroOrMore") {
    return '(' + Join(pattern, ",", depth) + (kind == "optional" ? ")?" : ")*");
  }
  if (kind == "value") {
    return Quoted(pattern.GetText());
  }
  if (kind == "ref") {
    return pattern.GetAttribute("name");
  }
  if (kind == "data") {
    return "xsd:string { pattern = " + Quoted(GetNode(pattern, "param").GetText()) + " }";
  }
  return kind;  // text, empty
}

}  // namespace

std::string WriteCompactSyntax(TConfigurationNode& grammar) {
  std::string text;
  TConfigurationNodeIterator it;
  for (it = it.begin(&grammar); it != it.end(); ++it) {
    const std::string name = it->Value() == "start" ? "start" : it->GetAttribute("name");
    text += name + " =\n  " + Join(*it, ",", 1) + "\n";
  }
  return text;
}

}  // namespace argos
