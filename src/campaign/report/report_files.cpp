#include <argos3/campaign/report/report_files.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>

#include <system_error>

namespace argos {

void CreateReportFolder(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    THROW_ARGOSEXCEPTION("the folder \"" << folder.string()
                                         << "\" cannot be created: " << problem.message());
  }
}

void WriteReportFile(const std::filesystem::path& path, const std::string& content) {
  std::string problem;
  if (!ReplaceFile(path.string(), content, problem)) {
    THROW_ARGOSEXCEPTION("\"" << path.string() << "\" cannot be written: " << problem);
  }
}

}  // namespace argos
