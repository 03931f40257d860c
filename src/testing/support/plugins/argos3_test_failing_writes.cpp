// A library for LD_PRELOAD: writes fail from the n-th byte on, as on a full disk.
//   ARGOS_TEST_FAIL_AFTER  n, over all files concerned; without it nothing fails
//   ARGOS_TEST_FAIL_FILE   part of the paths of the files concerned; "stdout" and "stderr" stand
//   for
//                          those streams. Without it: all files but the standard error
//   ARGOS_TEST_FULL_DISK   part of the paths whose disk has no free space, by statvfs()
//   ARGOS_TEST_NO_SIZES    the same of those whose file system does not say how large it is

#include <dlfcn.h>
#include <sys/statvfs.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::atomic<long> g_left{-1};  // bytes; -1: not read yet

template <typename FUNCTION>
FUNCTION* FindNext(FUNCTION*, const char* name) {
  return reinterpret_cast<FUNCTION*>(dlsym(RTLD_NEXT, name));
}

bool IsConcerned(int file) {
  const char* const part = std::getenv("ARGOS_TEST_FAIL_FILE");
  if (part == nullptr) {
    return file != STDERR_FILENO;
  }
  if (file == STDOUT_FILENO || file == STDERR_FILENO) {
    return std::strcmp(part, file == STDOUT_FILENO ? "stdout" : "stderr") == 0;
  }
  char link[64];
  char path[4096] = {};
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", file);
  return readlink(link, path, sizeof(path) - 1) > 0 && std::strstr(path, part) != nullptr;
}

// @return how many of these bytes may be written; sets errno if none may
size_t Grant(int file, size_t size) {
  const char* const limit = std::getenv("ARGOS_TEST_FAIL_AFTER");
  if (limit == nullptr || size == 0 || !IsConcerned(file)) {
    return size;
  }
  long unread = -1;
  g_left.compare_exchange_strong(unread, std::atol(limit));
  const long granted = std::min(g_left.load(), static_cast<long>(size));
  g_left -= granted;
  if (granted == 0) {
    errno = ENOSPC;
  }
  return static_cast<size_t>(granted);
}

}  // namespace

extern "C" ssize_t write(int file, const void* data, size_t size) {
  static const auto next = FindNext(&write, "write");
  const size_t granted = Grant(file, size);
  return granted == 0 && size > 0 ? -1 : next(file, data, granted);
}

extern "C" ssize_t writev(int file, const iovec* parts, int count) {
  ssize_t done = 0;
  for (int i = 0; i < count; ++i) {
    const ssize_t part = write(file, parts[i].iov_base, parts[i].iov_len);
    if (part < 0) {
      return done > 0 ? done : -1;
    }
    done += part;
    if (static_cast<size_t>(part) < parts[i].iov_len) {
      break;
    }
  }
  return done;
}

// the buffers of C's streams are in the C library, which does not call the functions above
extern "C" size_t fwrite(const void* data, size_t size, size_t count, FILE* stream) {
  static const auto next = FindNext(&fwrite, "fwrite");
  if (std::getenv("ARGOS_TEST_FAIL_AFTER") == nullptr || !IsConcerned(fileno(stream))) {
    return next(data, size, count, stream);
  }
  std::fflush(stream);
  size_t done = 0;
  while (done < size * count) {
    const ssize_t part =
        write(fileno(stream), static_cast<const char*>(data) + done, size * count - done);
    if (part < 0) {
      return done / size;
    }
    done += static_cast<size_t>(part);
  }
  return count;
}

extern "C" int statvfs(const char* path, struct statvfs* disk) {
  static const auto next = FindNext(&statvfs, "statvfs");
  const int result = next(path, disk);
  const char* const part = std::getenv("ARGOS_TEST_FULL_DISK");
  if (result == 0 && part != nullptr && std::strstr(path, part) != nullptr) {
    disk->f_bfree = disk->f_bavail = 0;
  }
  const char* const other = std::getenv("ARGOS_TEST_NO_SIZES");
  if (result == 0 && other != nullptr && std::strstr(path, other) != nullptr) {
    disk->f_blocks = disk->f_bfree = disk->f_bavail = 0;
  }
  return result;
}
