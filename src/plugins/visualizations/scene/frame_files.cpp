#include <argos3/plugins/simulator/visualizations/scene/frame_files.h>

#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/lock_file.h>
#include <argos3/core/utility/files/writing.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <filesystem>
#include <iomanip>
#include <system_error>

namespace argos {

namespace {

constexpr int kTickDigits = 10;

}  // namespace

CFrameFiles::CFrameFiles(const std::string& directory, const std::string& baseName, bool create)
    : m_directory(directory), m_baseName(baseName) {
  CheckBaseName();
  CheckDirectory(create);
}

void CFrameFiles::CheckBaseName() const {
  if (m_baseName.find('/') != std::string::npos) {
    THROW_ARGOSEXCEPTION("The base name of frames is \""
                         << m_baseName
                         << "\"; it must not contain a \"/\": the folder is given by the attribute "
                            "\"directory\"");
  }
}

void CFrameFiles::CheckDirectory(bool create) {
  while (m_directory.size() > 1 && m_directory.back() == '/') {
    m_directory.pop_back();
  }
  if (m_directory.empty()) {
    m_directory.assign(1, '.');
  }
  std::error_code error;
  if (std::filesystem::is_directory(m_directory, error)) {
    return;
  }
  if (std::filesystem::exists(m_directory, error)) {
    THROW_ARGOSEXCEPTION("Frames cannot go to \"" << m_directory << "\": it is not a directory");
  }
  if (create && CLoadingCheck::IsActive()) {
    const std::string problem = FindFolderProblem(m_directory, EMissingFolder::WillBeCreated);
    if (!problem.empty()) {
      THROW_ARGOSEXCEPTION("The directory \"" << m_directory
                                              << "\" for frames cannot be created: " << problem);
    }
    return;
  }
  if (!create) {
    THROW_ARGOSEXCEPTION("Frames cannot go to \""
                         << m_directory << "\": there is no such directory; create it first");
  }
  std::filesystem::create_directories(m_directory, error);
  if (error) {
    THROW_ARGOSEXCEPTION("The directory \""
                         << m_directory << "\" for frames cannot be created: " << error.message());
  }
}

std::string CFrameFiles::MakeFileName(std::uint32_t tick, const std::string& extension) const {
  CTextOutput name;
  name << m_directory << '/' << m_baseName << std::setfill('0') << std::setw(kTickDigits) << tick
       << '.' << extension;
  return name.str();
}

std::unique_ptr<CLockFile> CFrameFiles::Lock() const {
  const std::string path = m_directory + "/." + m_baseName + ".argos3.lock";
  std::unique_ptr<CLockFile> lock;
  try {
    lock = std::make_unique<CLockFile>(path);
  } catch (CARGoSException& error) {
    THROW_ARGOSEXCEPTION_NESTED("Frames with the base name \""
                                    << m_baseName << "\" cannot go to the directory \""
                                    << m_directory << "\" now; choose another directory "
                                    << "or base name",
                                error);
  }
  RemoveStaleParts(m_directory);
  return lock;
}

}  // namespace argos
