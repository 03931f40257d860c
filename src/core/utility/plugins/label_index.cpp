#include <argos3/core/utility/plugins/label_index.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/input_file.h>
#include <argos3/core/utility/plugins/elf_file.h>

#include <filesystem>
#include <string_view>

namespace fs = std::filesystem;

namespace argos {

namespace {

// the first line of an index; the second is the build id, the others are "KIND LABEL"
constexpr std::string_view kHeading = "labels of an ARGoS library, 1";

// removes the first line of a text and returns it
std::string_view TakeLine(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

}  // namespace

std::string GetIndexPath(const std::string& library) {
  return fs::path(library).replace_extension(".labels").string();
}

std::optional<std::vector<SPluginLabel>> ReadLabelIndex(const std::string& library) {
  std::string content;
  std::string problem;
  if (!ReadInputFile(GetIndexPath(library), content, problem)) {
    return std::nullopt;
  }
  std::string_view rest = content;
  if (TakeLine(rest) != kHeading) {
    return std::nullopt;
  }
  const std::string_view buildId = TakeLine(rest);
  if (buildId.empty() || buildId != ReadBuildId(library)) {
    return std::nullopt;
  }
  std::vector<SPluginLabel> labels;
  while (!rest.empty()) {
    const std::string_view line = TakeLine(rest);
    const size_t space = line.find(' ');
    if (space == std::string_view::npos) {
      return std::nullopt;
    }
    labels.push_back({std::string(line.substr(0, space)), std::string(line.substr(space + 1))});
  }
  return labels;
}

void WriteLabelIndex(const std::string& library, const std::vector<SPluginLabel>& labels) {
  const std::string path = GetIndexPath(library);
  const std::string buildId = ReadBuildId(library);
  if (buildId.empty()) {
    THROW_ARGOSEXCEPTION("The library \"" << library
                                          << "\" has no build id; link it with -Wl,--build-id");
  }
  std::string content(kHeading);
  content += '\n' + buildId + '\n';
  for (const SPluginLabel& label : labels) {
    content += label.Kind + ' ' + label.Label + '\n';
  }
  std::string problem;
  if (!ReplaceFile(path, content, problem)) {
    THROW_ARGOSEXCEPTION("The index \"" << path << "\" cannot be written: " << problem);
  }
}

}  // namespace argos
