#include <argos3/campaign/execution/experiment_paths.h>

#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>

namespace fs = std::filesystem;

namespace argos {

namespace {

// names of attributes of the core and the plug-ins that are paths: scripts, images, libraries
constexpr const char* kInputAttributes[] = {"library", "path", "script"};

void ForEachElement(CConfigurationNode& node,
                    const std::function<void(CConfigurationNode&)>& handle) {
  handle(node);
  for (CConfigurationNode* child = node.FirstChildElement(false); child != nullptr;
       child = child->NextSiblingElement(false)) {
    ForEachElement(*child, handle);
  }
}

bool IsFile(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

std::string MakeInputPathAbsolute(const std::string& path, const std::string& startFolder) {
  const fs::path whole = fs::path(startFolder) / path;
  const bool isInput = !path.empty() && fs::path(path).is_relative() &&
                       (IsFile(whole) || IsFile(whole.string() + ".so"));
  return isInput ? whole.string() : path;
}

void MakeInputPathsAbsolute(CConfigurationDocument& document, const std::string& startFolder) {
  ForEachElement(document.GetRoot(), [&](CConfigurationNode& node) {
    for (const char* name : kInputAttributes) {
      if (node.HasAttribute(name)) {
        node.SetAttribute(name, MakeInputPathAbsolute(node.GetAttribute(name), startFolder));
      }
    }
  });
}

void ParseExperiment(const SRunSetup& setup, CConfigurationDocument& document) {
  document.Parse(setup.ExperimentText, setup.ExperimentFile);
  for (const SSetting& constant : setup.Constants) {
    // one that nothing reads is reported like an attribute of the file
    document.SetByPath(constant.Path, constant.Value, false);
  }
  CConfigurationNode* const framework = document.GetRoot().FirstChildElement("framework", false);
  if (framework != nullptr && setup.Threads) {
    CConfigurationNode* const system = framework->FirstChildElement("system", false);
    (system != nullptr ? system : framework->InsertEndChild(CConfigurationNode("system")))
        ->SetAttribute("threads", *setup.Threads);
  }
  MakeInputPathsAbsolute(document, setup.StartFolder);
}

std::string MakeInputPathAbsolute(const SSetting& setting, const std::string& startFolder) {
  const std::string name = setting.Path.substr(setting.Path.rfind('@') + 1);
  const bool isInput = std::find(std::begin(kInputAttributes), std::end(kInputAttributes), name) !=
                       std::end(kInputAttributes);
  return isInput ? MakeInputPathAbsolute(setting.Value, startFolder) : setting.Value;
}

std::vector<std::string> ListLibraries(CConfigurationDocument& document) {
  std::vector<std::string> libraries;
  ForEachElement(document.GetRoot(), [&](CConfigurationNode& node) {
    const std::string library = node.GetAttribute("library");
    if (!library.empty() &&
        std::find(libraries.begin(), libraries.end(), library) == libraries.end()) {
      libraries.push_back(library);
    }
  });
  return libraries;
}

std::set<std::string> ListPluginLabels(CConfigurationDocument& document) {
  std::set<std::string> labels;
  ForEachElement(document.GetRoot(), [&labels](CConfigurationNode& node) {
    labels.insert(node.Value());
    labels.insert(node.Value() + " (" + node.GetAttribute("implementation") + ')');
    labels.insert(node.GetAttribute("label"));
  });
  return labels;
}

void MakePluginPathAbsolute() {
  const char* const value = std::getenv("ARGOS_PLUGIN_PATH");
  if (value == nullptr) {
    return;
  }
  std::vector<std::string> folders;
  Tokenize(value, folders, ":");
  std::string path;
  for (const std::string& folder : folders) {
    path += path.empty() ? "" : ":";
    path += fs::absolute(folder).string();
  }
  setenv("ARGOS_PLUGIN_PATH", path.c_str(), 1);
}

}  // namespace argos
