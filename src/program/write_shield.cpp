// A library that a check (argos3 --check) preloads: it takes the place of the C library's functions
// that change files, and has the changes made in a folder of their own. Code sees its own changes,
// as if they had been made. See shielded_check.h.

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

namespace {

namespace fs = std::filesystem;

// bytes; of a larger file that is opened for writing, only the size is copied
constexpr off_t kMaxCopyBytes = off_t(1) << 28;

struct SShield {
  std::atomic<bool> IsUp = false;
  std::string Folder;  // contains changed files, by their absolute paths
  std::mutex Mutex;
  std::set<std::string> Removed;  // absolute paths
};

SShield& GetShield() {
  // never destroyed: other libraries write files at the end of the process
  static SShield& shield = *std::make_unique<SShield>().release();
  return shield;
}

// true while functions of this library run on this thread: their own calls are not replaced
thread_local bool t_isInside = false;

class CInside {
 public:
  CInside() : m_isOuter(!t_isInside) { t_isInside = true; }
  ~CInside() { t_isInside = !m_isOuter; }
  CInside(const CInside&) = delete;
  CInside& operator=(const CInside&) = delete;

 private:
  bool m_isOuter;
};

bool IsActive() {
  return GetShield().IsUp && !t_isInside;
}

// the function that has that name without this library
template <typename FUNCTION>
FUNCTION* Next(FUNCTION* /*function*/, const char* name) {
  return reinterpret_cast<FUNCTION*>(dlsym(RTLD_NEXT, name));
}

#define NEXT(NAME) Next(&NAME, #NAME)

bool StartsWith(const std::string& text, std::string_view start) {
  return text.compare(0, start.size(), start) == 0;
}

std::string ToAbsolute(int folder, const char* path) {
  fs::path absolute = path;
  std::error_code error;
  if (absolute.is_relative()) {
    const fs::path base = folder == AT_FDCWD
                              ? fs::current_path(error)
                              : fs::read_symlink("/proc/self/fd/" + std::to_string(folder), error);
    absolute = base / absolute;
  }
  std::string text = absolute.lexically_normal().string();
  while (text.size() > 1 && text.back() == '/') {
    text.pop_back();
  }
  return text;
}

/* A path of a file as the code knows it. */
class CShieldedPath {
 public:
  CShieldedPath(int folder, const char* path)
      : m_path(path),
        m_absolute(ToAbsolute(folder, path)),
        m_copy(GetShield().Folder + m_absolute) {
    // devices, what the kernel shows as files, and the copies themselves
    m_isOutside = StartsWith(m_absolute, "/dev/") || StartsWith(m_absolute, "/proc/") ||
                  StartsWith(m_absolute, "/sys/") || StartsWith(m_absolute, GetShield().Folder);
  }

  bool IsOutside() const { return m_isOutside; }
  bool HasCopy() const { return Exists(m_copy); }
  bool IsRemoved() const {
    const std::lock_guard<std::mutex> lock(GetShield().Mutex);
    return GetShield().Removed.count(m_absolute) > 0;
  }
  bool HasOriginal() const { return !IsRemoved() && Exists(m_absolute); }
  bool IsThere() const { return HasCopy() || HasOriginal(); }

  const std::string& GetOriginal() const { return m_absolute; }
  const std::string& GetCopy() const { return m_copy; }

  // finds the file that is read at that path; null with errno if there is none
  const char* ToReadable() const {
    if (m_isOutside) {
      return m_path;
    }
    std::error_code error;
    if (HasCopy()) {
      // the copy of a folder has only what was written
      return fs::is_directory(m_copy, error) && HasOriginal() ? m_path : m_copy.c_str();
    }
    if (IsRemoved()) {
      errno = ENOENT;
      return nullptr;
    }
    return m_path;
  }

  // finds the file that is written at that path; null with errno if that is an error
  const char* ToWritable(int flags) const {
    if (m_isOutside || HasCopy()) {
      return ToReadable();
    }
    struct stat information {};
    if (IsRemoved() || stat(m_absolute.c_str(), &information) != 0) {
      return (flags & O_CREAT) == 0 ? Fail(ENOENT) : MakeFolderOfCopy() ? m_copy.c_str() : nullptr;
    }
    if ((flags & O_CREAT) != 0 && (flags & O_EXCL) != 0) {
      return Fail(EEXIST);
    }
    if (S_ISFIFO(information.st_mode) || S_ISSOCK(information.st_mode)) {
      return "/dev/null";
    }
    if (!S_ISREG(information.st_mode)) {
      return m_path;
    }
    if (access(m_absolute.c_str(), W_OK) != 0) {
      return nullptr;
    }
    return CopyFile(information.st_size, (flags & O_TRUNC) != 0) ? m_copy.c_str() : nullptr;
  }

  // checks what the system would check, and creates the folder in which the copy is
  bool MakeFolderOfCopy() const {
    const fs::path folder = fs::path(m_absolute).parent_path();
    const CShieldedPath parent(AT_FDCWD, folder.c_str());
    if (!parent.IsThere()) {
      errno = ENOENT;
      return false;
    }
    if (!parent.HasCopy() && access(folder.c_str(), W_OK | X_OK) != 0) {
      return false;
    }
    std::error_code error;
    fs::create_directories(fs::path(m_copy).parent_path(), error);
    errno = error.value();
    return !error;
  }

  void MarkRemoved() const {
    const std::lock_guard<std::mutex> lock(GetShield().Mutex);
    GetShield().Removed.insert(m_absolute);
  }

 private:
  static bool Exists(const std::string& path) {
    struct stat information {};
    return lstat(path.c_str(), &information) == 0;
  }

  static const char* Fail(int error) {
    errno = error;
    return nullptr;
  }

  bool CopyFile(off_t size, bool isEmptied) const {
    std::error_code error;
    fs::create_directories(fs::path(m_copy).parent_path(), error);
    const int file = error ? -1 : open(m_copy.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (file < 0) {
      return false;
    }
    const bool hasContent = !isEmptied && size > 0;
    bool isDone = !hasContent || size <= kMaxCopyBytes || ftruncate(file, size) == 0;
    close(file);
    if (isDone && hasContent && size <= kMaxCopyBytes) {
      fs::copy_file(m_absolute, m_copy, fs::copy_options::overwrite_existing, error);
      isDone = !error;
    }
    return isDone;
  }

  const char* m_path;
  std::string m_absolute;
  std::string m_copy;
  bool m_isOutside = false;
};

bool IsForWriting(int flags) {
  return (flags & O_ACCMODE) != O_RDONLY || (flags & (O_CREAT | O_TRUNC)) != 0;
}

int ToFlags(const char* mode) {
  const bool isBoth = std::strchr(mode, '+') != nullptr;
  switch (mode[0]) {
    case 'w':
      return (isBoth ? O_RDWR : O_WRONLY) | O_CREAT | O_TRUNC |
             (std::strchr(mode, 'x') != nullptr ? O_EXCL : 0);
    case 'a':
      return (isBoth ? O_RDWR : O_WRONLY) | O_CREAT | O_APPEND;
    default:
      return isBoth ? O_RDWR : O_RDONLY;
  }
}

/* Calls a function with the path that is to be used in place of another one. */
template <typename CALL, typename RESULT>
RESULT WithPath(int folder, const char* path, int flags, RESULT failure, CALL&& call) {
  if (!IsActive() || path == nullptr) {
    return call(path);
  }
  const CInside inside;
  const CShieldedPath shielded(folder, path);
  const char* const used = IsForWriting(flags) ? shielded.ToWritable(flags) : shielded.ToReadable();
  return used == nullptr ? failure : call(used);
}

int Remove(int folder, const char* path, int (*remove)(const char*)) {
  if (!IsActive() || path == nullptr) {
    return remove(path);
  }
  const CInside inside;
  const CShieldedPath shielded(folder, path);
  if (shielded.IsOutside()) {
    return remove(path);
  }
  if (!shielded.IsThere()) {
    errno = ENOENT;
    return -1;
  }
  if (shielded.HasOriginal()) {
    if (!shielded.MakeFolderOfCopy()) {
      return -1;
    }
    shielded.MarkRemoved();
  }
  return shielded.HasCopy() ? remove(shielded.GetCopy().c_str()) : 0;
}

int MakeFolder(int folder, const char* path, mode_t mode) {
  const CInside inside;
  const CShieldedPath shielded(folder, path);
  if (shielded.IsOutside()) {
    return NEXT(mkdirat)(folder, path, mode);
  }
  if (shielded.IsThere()) {
    errno = EEXIST;
    return -1;
  }
  return shielded.MakeFolderOfCopy() ? NEXT(mkdir)(shielded.GetCopy().c_str(), mode | S_IRWXU) : -1;
}

int Rename(int oldFolder, const char* oldPath, int newFolder, const char* newPath) {
  const CInside inside;
  const CShieldedPath from(oldFolder, oldPath);
  const CShieldedPath to(newFolder, newPath);
  if (from.IsOutside() && to.IsOutside()) {
    return NEXT(renameat)(oldFolder, oldPath, newFolder, newPath);
  }
  if (!from.IsThere()) {
    errno = ENOENT;
    return -1;
  }
  if (!to.MakeFolderOfCopy()) {
    return -1;
  }
  const char* const source = from.ToWritable(O_RDWR);
  if (source == nullptr) {
    return -1;
  }
  const int result =
      source == from.GetCopy()
          ? NEXT(rename)(source, to.GetCopy().c_str())
          : NEXT(mkdir)(to.GetCopy().c_str(), S_IRWXU);  // copies a folder without its contents
  if (result == 0) {
    from.MarkRemoved();
  }
  return result;
}

__attribute__((constructor)) void RaiseInPrograms() {
  // this acts in programs that the checked code starts
  const char* const folder = std::getenv("ARGOS_SHIELD_FOLDER_OF_CHECK");
  if (folder != nullptr) {
    GetShield().Folder = folder;
    GetShield().IsUp = true;
  }
}

}  // namespace

extern "C" {

// NOLINTBEGIN(readability-identifier-naming): names of C

/** From now on, this process changes files in a folder only. */
void argos3_raise_write_shield(const char* folder) {
  GetShield().Folder = folder;
  GetShield().IsUp = true;
  setenv("ARGOS_SHIELD_FOLDER_OF_CHECK", folder, 1);
}

// the functions of the C library; the names of their parameters do not matter

#define OPEN_FUNCTION(NAME)                                                           \
  int NAME(const char* path, int flags, ...) {                                        \
    va_list rest;                                                                     \
    va_start(rest, flags);                                                            \
    const mode_t mode = va_arg(rest, mode_t);                                         \
    va_end(rest);                                                                     \
    return WithPath(AT_FDCWD, path, flags, -1,                                        \
                    [&](const char* used) { return NEXT(NAME)(used, flags, mode); }); \
  }
#define OPEN_AT_FUNCTION(NAME)                                                                \
  int NAME(int folder, const char* path, int flags, ...) {                                    \
    va_list rest;                                                                             \
    va_start(rest, flags);                                                                    \
    const mode_t mode = va_arg(rest, mode_t);                                                 \
    va_end(rest);                                                                             \
    return WithPath(folder, path, flags, -1,                                                  \
                    [&](const char* used) { return NEXT(NAME)(folder, used, flags, mode); }); \
  }
OPEN_FUNCTION(open)
OPEN_FUNCTION(open64)
OPEN_AT_FUNCTION(openat)
OPEN_AT_FUNCTION(openat64)
#undef OPEN_FUNCTION
#undef OPEN_AT_FUNCTION

int __open_2(const char* path, int flags) {
  return open(path, flags, 0);
}
int __open64_2(const char* path, int flags) {
  return open64(path, flags, 0);
}
int __openat_2(int folder, const char* path, int flags) {
  return openat(folder, path, flags, 0);
}
int __openat64_2(int folder, const char* path, int flags) {
  return openat64(folder, path, flags, 0);
}

// NOLINTEND(readability-identifier-naming)

int creat(const char* path, mode_t mode) {
  return open(path, O_WRONLY | O_CREAT | O_TRUNC, mode);
}
int creat64(const char* path, mode_t mode) {
  return open64(path, O_WRONLY | O_CREAT | O_TRUNC, mode);
}

FILE* fopen(const char* path, const char* mode) {
  return WithPath(AT_FDCWD, path, ToFlags(mode), static_cast<FILE*>(nullptr),
                  [&](const char* used) { return NEXT(fopen)(used, mode); });
}
FILE* fopen64(const char* path, const char* mode) {
  return WithPath(AT_FDCWD, path, ToFlags(mode), static_cast<FILE*>(nullptr),
                  [&](const char* used) { return NEXT(fopen64)(used, mode); });
}
FILE* freopen(const char* path, const char* mode, FILE* file) {
  return WithPath(AT_FDCWD, path, ToFlags(mode), static_cast<FILE*>(nullptr),
                  [&](const char* used) { return NEXT(freopen)(used, mode, file); });
}
FILE* freopen64(const char* path, const char* mode, FILE* file) {
  return WithPath(AT_FDCWD, path, ToFlags(mode), static_cast<FILE*>(nullptr),
                  [&](const char* used) { return NEXT(freopen64)(used, mode, file); });
}
int truncate(const char* path, off_t size) noexcept {
  return WithPath(AT_FDCWD, path, O_WRONLY, -1,
                  [&](const char* used) { return NEXT(truncate)(used, size); });
}
int truncate64(const char* path, off64_t size) noexcept {
  return WithPath(AT_FDCWD, path, O_WRONLY, -1,
                  [&](const char* used) { return NEXT(truncate64)(used, size); });
}

int unlink(const char* path) noexcept {
  return Remove(AT_FDCWD, path, [](const char* used) { return NEXT(unlink)(used); });
}
int rmdir(const char* path) noexcept {
  return Remove(AT_FDCWD, path, [](const char* used) { return NEXT(rmdir)(used); });
}
int remove(const char* path) noexcept {
  return Remove(AT_FDCWD, path, [](const char* used) { return NEXT(remove)(used); });
}
int unlinkat(int folder, const char* path, int flags) noexcept {
  return IsActive() ? Remove(folder, path, [](const char* used) { return NEXT(remove)(used); })
                    : NEXT(unlinkat)(folder, path, flags);
}
int mkdir(const char* path, mode_t mode) noexcept {
  return IsActive() ? MakeFolder(AT_FDCWD, path, mode) : NEXT(mkdir)(path, mode);
}
int mkdirat(int folder, const char* path, mode_t mode) noexcept {
  return IsActive() ? MakeFolder(folder, path, mode) : NEXT(mkdirat)(folder, path, mode);
}
int rename(const char* from, const char* to) noexcept {
  return IsActive() ? Rename(AT_FDCWD, from, AT_FDCWD, to) : NEXT(rename)(from, to);
}
int renameat(int fromFolder, const char* from, int toFolder, const char* to) noexcept {
  return IsActive() ? Rename(fromFolder, from, toFolder, to)
                    : NEXT(renameat)(fromFolder, from, toFolder, to);
}
int symlink(const char* target, const char* path) noexcept {
  return WithPath(AT_FDCWD, path, O_WRONLY | O_CREAT | O_EXCL, -1,
                  [&](const char* used) { return NEXT(symlink)(target, used); });
}
int link(const char* target, const char* path) noexcept {
  return WithPath(AT_FDCWD, path, O_WRONLY | O_CREAT | O_EXCL, -1, [&](const char* used) {
    return t_isInside ? NEXT(symlink)(ToAbsolute(AT_FDCWD, target).c_str(), used)
                      : NEXT(link)(target, used);
  });
}
int chmod(const char* path, mode_t mode) noexcept {
  return WithPath(AT_FDCWD, path, O_WRONLY, -1,
                  [&](const char* used) { return NEXT(chmod)(used, mode); });
}

int access(const char* path, int mode) noexcept {
  return WithPath(AT_FDCWD, path, O_RDONLY, -1,
                  [&](const char* used) { return NEXT(access)(used, mode); });
}
int faccessat(int folder, const char* path, int mode, int flags) noexcept {
  return WithPath(folder, path, O_RDONLY, -1,
                  [&](const char* used) { return NEXT(faccessat)(folder, used, mode, flags); });
}
DIR* opendir(const char* path) {
  return WithPath(AT_FDCWD, path, O_RDONLY, static_cast<DIR*>(nullptr),
                  [&](const char* used) { return NEXT(opendir)(used); });
}
int chdir(const char* path) noexcept {
  return WithPath(AT_FDCWD, path, O_RDONLY, -1,
                  [&](const char* used) { return NEXT(chdir)(used); });
}

#define STAT_FUNCTION(NAME, TYPE)                                                     \
  int NAME(const char* path, TYPE* information) noexcept {                            \
    return WithPath(AT_FDCWD, path, O_RDONLY, -1,                                     \
                    [&](const char* used) { return NEXT(NAME)(used, information); }); \
  }
STAT_FUNCTION(stat, struct stat)
STAT_FUNCTION(lstat, struct stat)
STAT_FUNCTION(stat64, struct stat64)
STAT_FUNCTION(lstat64, struct stat64)
#undef STAT_FUNCTION

int fstatat(int folder, const char* path, struct stat* information, int flags) noexcept {
  return (flags & AT_EMPTY_PATH) != 0 ? NEXT(fstatat)(folder, path, information, flags)
                                      : WithPath(folder, path, O_RDONLY, -1, [&](const char* used) {
                                          return NEXT(fstatat)(folder, used, information, flags);
                                        });
}
int fstatat64(int folder, const char* path, struct stat64* information, int flags) noexcept {
  return (flags & AT_EMPTY_PATH) != 0 ? NEXT(fstatat64)(folder, path, information, flags)
                                      : WithPath(folder, path, O_RDONLY, -1, [&](const char* used) {
                                          return NEXT(fstatat64)(folder, used, information, flags);
                                        });
}

}  // extern "C"
