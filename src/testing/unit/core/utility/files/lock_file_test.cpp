#include <argos3/core/utility/files/lock_file.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

using namespace argos;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

class CLockFolder {
 public:
  CLockFolder() {
    std::string pattern = (fs::temp_directory_path() / "argos_lock_XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    m_path = pattern;
  }
  ~CLockFolder() { fs::remove_all(m_path); }
  std::string Lock() const { return m_path + "/lock"; }

 private:
  std::string m_path;
};

}  // namespace

TEST_CASE("lock file: a second lock is refused until the first one ends", "[core][files]") {
  const CLockFolder folder;
  auto first = std::make_unique<CLockFile>(folder.Lock());
  CHECK_THROWS_WITH(CLockFile(folder.Lock()),
                    Contains("this process is writing there") && Contains(folder.Lock()));
  first.reset();
  CHECK_FALSE(fs::exists(folder.Lock()));
  CHECK_NOTHROW(CLockFile(folder.Lock()));
}

TEST_CASE("lock file: the process that holds the lock is named; its death releases it",
          "[core][files]") {
  const CLockFolder folder;
  int ready[2] = {-1, -1};
  REQUIRE(pipe(ready) == 0);
  const pid_t child = fork();
  if (child == 0) {
    const CLockFile lock(folder.Lock());
    const bool written = write(ready[1], "x", 1) == 1;
    pause();
    _exit(written ? 0 : 1);
  }
  char byte = 0;
  REQUIRE(read(ready[0], &byte, 1) == 1);
  CHECK_THROWS_WITH(CLockFile(folder.Lock()), Contains("process " + std::to_string(child)));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  CHECK(fs::exists(folder.Lock()));
  CHECK_NOTHROW(CLockFile(folder.Lock()));
  close(ready[0]);
  close(ready[1]);
}

TEST_CASE("lock file: a forked process does not release the lock", "[core][files]") {
  const CLockFolder folder;
  auto lock = std::make_unique<CLockFile>(folder.Lock());
  const pid_t child = fork();
  if (child == 0) {
    lock.reset();
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  CHECK(fs::exists(folder.Lock()));
  CHECK_THROWS_AS(CLockFile(folder.Lock()), CARGoSException);
}

TEST_CASE("lock file: a folder that does not exist is an error", "[core][files]") {
  CHECK_THROWS_WITH(CLockFile("/no/such/folder/lock"),
                    Contains("/no/such/folder/lock") && Contains("No such file"));
}
