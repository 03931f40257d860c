#include <argos3/support/scratch_folder.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace argos {

CScratchFolder::CScratchFolder(const std::string& prefix) {
  std::error_code failure;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(failure);
  std::string pattern = (parent / (prefix + "XXXXXX")).string();
  if (failure || mkdtemp(pattern.data()) == nullptr) {
    THROW_ARGOSEXCEPTION("no folder can be created in \""
                         << parent.string()
                         << "\": " << (failure ? failure.message() : std::strerror(errno))
                         << "; TMPDIR names another place");
  }
  m_path = pattern;
}

CScratchFolder::~CScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(m_path, ignored);
}

}  // namespace argos
