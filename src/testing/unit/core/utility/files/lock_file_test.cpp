#include <argos3/core/utility/files/lock_file.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>

namespace argos::lock_file_test {

using Catch::Contains;
namespace fs = std::filesystem;

TEST_CASE("lock file: a second lock is refused until the first one ends", "[core][files]") {
  const CTemporaryFolder folder;
  auto first = std::make_unique<CLockFile>(folder.Path("lock"));
  CHECK_THROWS_WITH(CLockFile(folder.Path("lock")),
                    Contains("this process is writing there") && Contains(folder.Path("lock")));
  first.reset();
  CHECK_FALSE(fs::exists(folder.Path("lock")));
  CHECK_NOTHROW(CLockFile(folder.Path("lock")));
}

TEST_CASE("lock file: the process that holds the lock is named; its death releases it",
          "[core][files]") {
  const CTemporaryFolder folder;
  int ready[2] = {-1, -1};
  REQUIRE(pipe(ready) == 0);
  const pid_t child = fork();
  if (child == 0) {
    const CLockFile lock(folder.Path("lock"));
    const bool written = write(ready[1], "x", 1) == 1;
    pause();
    _exit(written ? 0 : 1);
  }
  char byte = 0;
  REQUIRE(read(ready[0], &byte, 1) == 1);
  CHECK_THROWS_WITH(CLockFile(folder.Path("lock")), Contains("process " + std::to_string(child)));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  CHECK(fs::exists(folder.Path("lock")));
  CHECK_NOTHROW(CLockFile(folder.Path("lock")));
  close(ready[0]);
  close(ready[1]);
}

TEST_CASE("lock file: a forked process does not release the lock", "[core][files]") {
  const CTemporaryFolder folder;
  auto lock = std::make_unique<CLockFile>(folder.Path("lock"));
  const pid_t child = fork();
  if (child == 0) {
    lock.reset();
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  CHECK(fs::exists(folder.Path("lock")));
  CHECK_THROWS_AS(CLockFile(folder.Path("lock")), CARGoSException);
}

TEST_CASE("lock file: a folder that does not exist is an error", "[core][files]") {
  CHECK_THROWS_WITH(CLockFile("/no/such/folder/lock"),
                    Contains("/no/such/folder/lock") && Contains("No such file"));
}

}  // namespace argos::lock_file_test
