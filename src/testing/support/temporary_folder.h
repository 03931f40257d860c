#ifndef ARGOS3_TESTING_SUPPORT_TEMPORARY_FOLDER_H
#define ARGOS3_TESTING_SUPPORT_TEMPORARY_FOLDER_H

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace argos {

/** A new folder for a test, removed with its content by the destructor. */
class CTemporaryFolder {
 public:
  /** @throws std::runtime_error if it cannot be created. */
  CTemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "argos_test_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("cannot create the folder " + pattern);
    }
    m_path = pattern;
  }
  ~CTemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  CTemporaryFolder(const CTemporaryFolder&) = delete;
  CTemporaryFolder& operator=(const CTemporaryFolder&) = delete;

  const std::string& GetPath() const { return m_path; }
  /** @return the path of a file in this folder. */
  std::string Path(const std::string& name) const { return m_path + '/' + name; }

  /** Writes a file. @return its path. */
  std::string Write(const std::string& name, const std::string& content) const {
    std::ofstream(Path(name), std::ios::binary) << content;
    return Path(name);
  }
  /** @return the content of a file; empty if there is none. */
  std::string Read(const std::string& name) const {
    std::ifstream file(Path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  /** @return the sorted names of what is in a folder in this one, or in this one. */
  std::vector<std::string> List(const std::string& subfolder = ".") const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(Path(subfolder))) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  std::string m_path;
};

}  // namespace argos

#endif
