#include <argos3/core/utility/files/nearby_file.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <filesystem>
#include <system_error>

namespace argos {

namespace fs = std::filesystem;

namespace {

std::string Absolute(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

std::string DescribePlace(const fs::path& path) {
  std::error_code ignored;
  return '"' + Absolute(path) + '"' + (fs::is_directory(path, ignored) ? " (a directory)" : "");
}

bool IsFile(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

}  // namespace

std::string FindNearbyFile(const std::string& name, const std::string& besideFile,
                           const std::string& what) {
  std::string expanded = name;
  const fs::path path = ExpandEnvVariables(expanded);
  if (IsFile(path)) {
    return path.string();
  }
  std::string places = DescribePlace(path);
  if (!besideFile.empty() && path.is_relative()) {
    const fs::path beside = fs::path(besideFile).parent_path() / path;
    if (IsFile(beside)) {
      return beside.string();
    }
    if (Absolute(beside) != Absolute(path)) {
      places += " and for " + DescribePlace(beside);
    }
  }
  THROW_ARGOSEXCEPTION("there is no " << what << " \"" << name << "\"; looked for " << places);
}

}  // namespace argos
