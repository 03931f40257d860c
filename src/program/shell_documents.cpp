#include <argos3/program/shell_documents.h>

#include <argos3/core/config.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/plugin_kinds.h>
#include <argos3/program/option_table.h>

#include <fmt/format.h>

#include <map>
#include <set>
#include <sstream>

namespace argos {

namespace {

std::string Join(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : between) + word;
  }
  return text;
}

// man page

// text for roff: dashes that can be copied, backslashes, and no control lines
std::string ForRoff(std::string text) {
  Replace(text, "\\", "\\e");
  std::string escaped;
  bool isLineStart = true;
  for (const char c : text) {
    if (isLineStart && (c == '.' || c == '\'')) {
      escaped += "\\&";
    }
    escaped += c == '-' ? "\\" : "";
    escaped += c;
    isLineStart = c == '\n';
  }
  return escaped;
}

std::string DescribeForMan(const SCommandLineOption& option) {
  std::string names = option.Names;
  Replace(names, ",", ", ");
  std::string text = ".TP\n.B " + ForRoff(names);
  if (!option.Value.empty()) {
    text += " \\fI" + ForRoff(option.Value) + "\\fR";
  }
  return text + '\n' + ForRoff(option.Help) + '\n';
}

std::string Synopsis() {
  std::string text;
  for (const std::string& line : GetUsageLines()) {
    text += text.empty() ? "" : "\n.br\n";
    text += ForRoff(line);
  }
  return text;
}

}  // namespace

std::string MakeManPage() {
  std::string page = ".TH ARGOS3 1 \"\" \"argos3 " ARGOS_VERSION "\" \"User Commands\"\n";
  page +=
      ".SH NAME\nargos3 \\- a simulator for swarms of robots\n.SH SYNOPSIS\n" + Synopsis() +
      "\n.SH DESCRIPTION\nRuns an experiment, which an XML file describes, with robots that have "
      "controllers in C++ or Lua. The user's guide, doc/guide/, begins with a first experiment.\n";
  std::string group;
  for (const SCommandLineOption& option : GetCommandLineOptions()) {
    if (group.empty()) {
      page += ".SH OPTIONS\n";
    }
    if (option.Group != group) {
      group = option.Group;
      page += ".SS " + ForRoff(group) + '\n';
    }
    page += DescribeForMan(option);
  }
  for (const SHelpSection& section : GetHelpSections()) {
    page += ".SH " + ForRoff(StringToUpperCase(section.Heading)) + "\n.nf\n" +
            ForRoff(section.Text) + ".fi\n";
  }
  return page + ".SH SEE ALSO\n.BR argos3\\-campaign ,\n.BR argos3\\-plot\n";
}

// completion

namespace {

// the last short option of a group, such as -zc, takes the value
std::string BashPattern(const SCommandLineOption& option) {
  const std::string name = option.GetShortName();
  return name.empty() ? option.GetLongName()
                      : fmt::format("{}|-[!-]*{}|{}", name, name.substr(1), option.GetLongName());
}

// the bash command that prints the words of a value
std::string BashWords(const SCommandLineOption& option) {
  switch (option.Words) {
    case EOptionWords::File:
      return "_argos3_files '*'";
    case EOptionWords::ExperimentFile:
      return "_argos3_files '*.argos'";
    case EOptionWords::Recording:
      return "_argos3_files '*.rec'";
    case EOptionWords::Folder:
      return "_argos3_files ''";
    case EOptionWords::Plugins:
      return "_argos3_words \"$(\"${words[0]}\" --generate plugins 2>/dev/null)\"";
    case EOptionWords::XPaths:
      return "_argos3_xpaths";
    case EOptionWords::Listed:
      return "_argos3_words '" + Join(option.Choices, " ") + "'";
    default:
      return ":";
  }
}

constexpr char kBashFunctions[] = R"sh(# bash completion of argos3; made by: argos3 --generate bash

_argos3_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}

# $1: pattern of file names; folders are always offered
_argos3_files() {
  compopt -o filenames
  mapfile -t COMPREPLY < <(
    compgen -d -- "$current"
    [[ -z "$1" ]] || compgen -f -X "!$1" -- "$current"
  )
}

# attributes of the experiment in this command line
_argos3_xpaths() {
  local word
  for word in "${words[@]:1}"; do
    if [[ "$word" == *.argos ]]; then
      _argos3_words "$("${words[0]}" --generate xpaths -c "$word" 2>/dev/null | sed 's/$/=/')"
      compopt -o nospace
    fi
  done
}

_argos3() {
  local line="${COMP_LINE:0:COMP_POINT}" words current="" previous
  read -ra words <<<"$line"
  if [[ "$line" != *[[:space:]] ]]; then
    current="${words[-1]}"
    unset 'words[-1]'
  fi
  previous="${words[-1]}"
  COMPREPLY=()
  case "$previous" in
)sh";

constexpr char kBashEnd[] = R"sh(  esac
  # readline replaces only what follows the last of these characters
  local before="${current%"${current##*[@=:]}"}"
  COMPREPLY=("${COMPREPLY[@]#"$before"}")
}
complete -F _argos3 argos3
)sh";

}  // namespace

std::string MakeBashCompletion() {
  std::string script = kBashFunctions;
  std::vector<std::string> names;
  for (const SCommandLineOption& option : GetCommandLineOptions()) {
    names.push_back(option.GetLongName());
    if (!option.GetShortName().empty()) {
      names.push_back(option.GetShortName());
    }
    if (!option.Value.empty()) {
      script += "    " + BashPattern(option) + ") " + BashWords(option) + " ;;\n";
    }
  }
  return script + "    *)\n      if [[ \"$current\" == -* ]]; then\n        _argos3_words '" +
         Join(names, " ") + "'\n      else\n        _argos3_files '*.argos'\n      fi\n      ;;\n" +
         kBashEnd;
}

namespace {

std::string ZshAction(const SCommandLineOption& option) {
  switch (option.Words) {
    case EOptionWords::File:
      return "_files";
    case EOptionWords::ExperimentFile:
      return "_files -g \"*.argos\"";
    case EOptionWords::Recording:
      return "_files -g \"*.rec\"";
    case EOptionWords::Folder:
      return "_files -/";
    case EOptionWords::Plugins:
      return "_argos3_plugins";
    case EOptionWords::XPaths:
      return "_argos3_xpaths";
    case EOptionWords::Listed:
      return fmt::format("({})", fmt::join(option.Choices, " "));
    default:
      return " ";
  }
}

// text inside '...[help]:value:...' of _arguments
std::string ForZsh(std::string text) {
  Replace(text, "'", "'\\''");
  std::string escaped;
  for (const char c : text) {
    escaped += c == '[' || c == ']' || c == ':' ? "\\" : "";
    escaped += c;
  }
  return escaped;
}

std::string ZshArgument(const SCommandLineOption& option) {
  const std::string shortName = option.GetShortName();
  const std::string longName = option.GetLongName();
  const std::string names = shortName.empty()
                                ? (option.IsRepeatable() ? "'*'" : "") + longName
                                : fmt::format("'({0} {1})'{{{0},{1}}}", shortName, longName);
  const std::string value = option.Value.empty()
                                ? ""
                                : fmt::format("{}:{}:{}", option.IsValueOptional() ? ":" : "",
                                              ForZsh(option.Value), ZshAction(option));
  return fmt::format("  {}'[{}]{}' \\\n", names, ForZsh(option.Help), value);
}

constexpr char kZshFunctions[] = R"sh(#compdef argos3
# zsh completion of argos3; made by: argos3 --generate zsh

_argos3_plugins() {
  local -a names
  names=(${(f)"$(_call_program plugins $words[1] --generate plugins 2>/dev/null)"})
  compadd -a names
}

# attributes of the experiment in this command line
_argos3_xpaths() {
  local -a paths
  local file=${words[(r)*.argos]}
  [[ -n $file ]] || return
  paths=(${(f)"$(_call_program xpaths $words[1] --generate xpaths -c ${(q)file} 2>/dev/null)"})
  compadd -S = -a paths
}

_arguments -s -S \
)sh";

}  // namespace

std::string MakeZshCompletion() {
  std::string script = kZshFunctions;
  for (const SCommandLineOption& option : GetCommandLineOptions()) {
    script += ZshArgument(option);
  }
  return script + "  '*:experiment:_files -g \"*.argos\"'\n";
}

// words

std::vector<std::string> ListPluginWords() {
  std::set<std::string> words = {"all"};
  for (const SPluginKind& kind : ListPluginKinds()) {
    words.insert(kind.Word);
    for (const SPluginText& plugin : kind.Plugins) {
      words.insert(TagOf(plugin.Label));
    }
  }
  return {words.begin(), words.end()};
}

namespace {

void AddPaths(TConfigurationNode& node, const std::string& path, std::vector<std::string>& paths) {
  for (const std::string& name : node.GetAttributeNames()) {
    paths.push_back(path + '@' + name);
  }
  std::map<std::string, int> numSiblings;
  TConfigurationNodeIterator it;
  for (it = it.begin(&node); it != it.end(); ++it) {
    ++numSiblings[it->Value()];
  }
  std::map<std::string, int> places;
  for (it = it.begin(&node); it != it.end(); ++it) {
    const std::string tag = it->Value();
    const std::string place =
        numSiblings[tag] > 1 ? '[' + std::to_string(++places[tag]) + ']' : std::string();
    AddPaths(*it, path + tag + place + '/', paths);
  }
}

}  // namespace

std::vector<std::string> ListAttributePaths(const std::string& file) {
  CConfigurationDocument document;
  document.LoadFile(file);
  std::vector<std::string> paths;
  // steps below the root element
  AddPaths(document.GetRoot(), "", paths);
  return paths;
}

}  // namespace argos
