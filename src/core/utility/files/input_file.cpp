#include <argos3/core/utility/files/input_file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace argos {

namespace {

constexpr std::size_t kReadSize = 1 << 16;  // bytes

const char* DescribeKind(mode_t mode) {
  if (S_ISDIR(mode)) {
    return "it is a directory";
  }
  if (S_ISFIFO(mode)) {
    return "it is a FIFO (a pipe), not a regular file";
  }
  if (S_ISSOCK(mode)) {
    return "it is a socket, not a regular file";
  }
  return "it is a device, not a regular file";
}

}  // namespace

std::string FindInputProblem(const std::string& path) {
  struct stat information {};
  if (stat(path.c_str(), &information) != 0) {
    return std::strerror(errno);
  }
  return S_ISREG(information.st_mode) ? "" : DescribeKind(information.st_mode);
}

bool ReadInputFile(const std::string& path, std::string& content, std::string& problem) {
  content.clear();
  problem = FindInputProblem(path);
  if (!problem.empty()) {
    return false;
  }
  // it does not block: a FIFO may have taken the file's place since the check
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat information {};
  bool failed = file < 0 || fstat(file, &information) != 0;
  // one byte more than there should be, so that the end is found without growth
  std::size_t chunk = static_cast<std::size_t>(information.st_size) + 1;
  while (!failed) {
    const std::size_t size = content.size();
    content.resize(size + chunk);
    const ssize_t count = read(file, &content[size], chunk);
    content.resize(size + static_cast<std::size_t>(count > 0 ? count : 0));
    if (count == 0) {
      break;
    }
    failed = count < 0 && errno != EINTR;
    chunk = content.size() == size + chunk ? kReadSize : 1;
  }
  if (failed) {
    problem = std::strerror(errno);
  }
  if (file >= 0) {
    close(file);
  }
  return !failed;
}

}  // namespace argos
