#include <argos3/campaign/store/experiment_files.h>

#include <argos3/campaign/design/element_reading.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <vector>

namespace argos {

namespace {

void CollectNames(TConfigurationNode& node, std::vector<std::string>& names) {
  for (const char* attribute : {"library", "script"}) {
    if (NodeAttributeExists(node, attribute)) {
      std::string name;
      GetNodeAttribute(node, attribute, name);
      if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
      }
    }
  }
  TConfigurationNodeIterator child;
  for (child = child.begin(&node); child != child.end(); ++child) {
    CollectNames(*child, names);
  }
}

std::vector<std::string> ListFolders(const std::string& experimentFile) {
  std::vector<std::string> folders;
  const char* path = std::getenv("ARGOS_PLUGIN_PATH");
  std::istringstream parts(path == nullptr ? "" : path);
  std::string folder;
  while (std::getline(parts, folder, ':')) {
    if (!folder.empty()) {
      folders.push_back(folder);
    }
  }
  folders.emplace_back(".");
  folders.push_back(std::filesystem::path(experimentFile).parent_path().string());
  return folders;
}

// an absolute name replaces the folder
bool ReadFirst(const std::vector<std::string>& folders, const std::string& name,
               std::string& content) {
  std::string problem;
  for (const std::string& folder : folders) {
    for (const char* suffix : {"", ".so"}) {
      if (ReadInputFile((std::filesystem::path(folder) / (name + suffix)).string(), content,
                        problem)) {
        return true;
      }
    }
  }
  return false;
}

std::map<std::string, std::string> SplitDescriptions(const std::string& text) {
  std::map<std::string, std::string> descriptions;
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    const size_t digest = line.rfind(' ');
    const size_t size = digest == std::string::npos ? digest : line.rfind(' ', digest - 1);
    if (size != std::string::npos) {
      descriptions[line.substr(0, size)] = line.substr(size);
    }
  }
  return descriptions;
}

}  // namespace

std::string DescribeExperimentFiles(const std::string& experimentText,
                                    const std::string& experimentFile,
                                    const std::vector<std::string>& furtherFiles) {
  CConfigurationDocument document;
  document.Parse(experimentText, experimentFile);
  std::vector<std::string> names;
  CollectNames(document.GetRoot(), names);
  names.insert(names.end(), furtherFiles.begin(), furtherFiles.end());
  const std::vector<std::string> folders = ListFolders(experimentFile);
  std::string text;
  for (const std::string& name : names) {
    std::string expanded = name;
    ExpandEnvVariables(expanded);
    std::string content;
    if (ReadFirst(folders, expanded, content)) {
      text += fmt::format("{} {} {}\n", name, content.size(), ComputeTextDigest(content));
    }
  }
  return text;
}

std::string ListChangedFiles(const std::string& before, const std::string& now) {
  const std::map<std::string, std::string> old = SplitDescriptions(before);
  std::string changed;
  for (const auto& [name, description] : SplitDescriptions(now)) {
    const auto other = old.find(name);
    if (other != old.end() && other->second != description) {
      AppendItem(changed, name);
    }
  }
  return changed;
}

std::string ComputeTextDigest(const std::string& text) {
  CDigest digest;
  digest.Add(text);
  return fmt::format("{:016x}", digest.GetValue());
}

// Reads a line without the blanks around it. @return false at the end.
static bool ReadTrimmed(std::istream& stream, std::string& line) {
  if (!std::getline(stream, line)) {
    line = "(end of the file)";
    return false;
  }
  line = TrimBlanks(line);
  return true;
}

std::string DescribeFirstDifference(const std::string& before, const std::string& now) {
  std::istringstream beforeLines(before);
  std::istringstream nowLines(now);
  for (int number = 1;; ++number) {
    std::string beforeLine;
    std::string nowLine;
    const bool hadLine = ReadTrimmed(beforeLines, beforeLine);
    const bool hasLine = ReadTrimmed(nowLines, nowLine);
    if (!hadLine && !hasLine) {
      return before == now ? "" : "blanks or line breaks";
    }
    if (beforeLine != nowLine) {
      return fmt::format("line {}: '{}' instead of '{}'", number, nowLine, beforeLine);
    }
  }
}

}  // namespace argos
