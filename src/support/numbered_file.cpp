#include <argos3/support/numbered_file.h>

#include <filesystem>

namespace argos {

std::string NumberFile(const std::string& file, int run) {
  if (run <= 1) {
    return file;
  }
  const std::filesystem::path path(file);
  std::string name = path.stem().string();
  name += '.';
  name += std::to_string(run);
  name += path.extension().string();
  return (path.parent_path() / name).string();
}

}  // namespace argos
