#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

namespace argos::file_replacement_test {

using Catch::Contains;
namespace fs = std::filesystem;

TEST_CASE("file replacement: a file has its content, and no part is left", "[core][files]") {
  const CTemporaryFolder folder;
  folder.Write("a", "a longer old content");
  std::string problem = "old";
  CHECK(ReplaceFile(folder.Path("a"), std::string("new\0text", 8), problem));
  CHECK(problem.empty());
  CHECK(folder.Read("a") == std::string("new\0text", 8));
  CHECK_FALSE(fs::exists(folder.Path("a") + kPartSuffix));
}

TEST_CASE("file replacement: a failed write leaves the earlier file", "[core][files]") {
  const CTemporaryFolder folder;
  folder.Write("a", "old");
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    std::string problem;
    const bool done = ReplaceFile(folder.Path("a"), std::string(5000, 'x'), problem);
    _exit(!done && problem == "File too large" ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  CHECK(status == 0);
  CHECK(folder.Read("a") == "old");
  CHECK_FALSE(fs::exists(folder.Path("a") + kPartSuffix));
}

TEST_CASE("file replacement: links are followed, devices are kept", "[core][files]") {
  const CTemporaryFolder folder;
  fs::create_directory(folder.Path("sub"));
  folder.Write("sub/target", "old");
  fs::create_symlink("sub/target", folder.Path("link"));
  std::string problem;
  CHECK(ReplaceFile(folder.Path("link"), "new", problem));
  CHECK(fs::is_symlink(folder.Path("link")));
  CHECK(folder.Read("sub/target") == "new");
  CHECK(ReplaceFile("/dev/null", "new", problem));
  CHECK(fs::is_character_file("/dev/null"));
  CHECK_FALSE(ReplaceFile("/dev/full", "new", problem));
  CHECK(problem == "No space left on device");
  CHECK_FALSE(ReplaceFile(folder.Path("sub"), "new", problem));
  CHECK(problem == "Is a directory");
}

TEST_CASE("file replacement: a part of a killed process is replaced, a live one refused",
          "[core][files]") {
  const CTemporaryFolder folder;
  const std::string part = std::string("a") + kPartSuffix;
  folder.Write(part, "a part that is longer than the new content");
  std::string problem;
  CHECK(ReplaceFile(folder.Path("a"), "new", problem));
  CHECK(folder.Read("a") == "new");
  folder.Write(part, "half");
  const int live = open(folder.Path(part).c_str(), O_RDONLY);
  REQUIRE(flock(live, LOCK_EX) == 0);
  CHECK_FALSE(ReplaceFile(folder.Path("a"), "newer", problem));
  CHECK_THAT(problem, Contains("process is writing it"));
  RemoveStaleParts(folder.GetPath());
  CHECK(folder.Read(part) == "half");
  close(live);
  RemoveStaleParts(folder.GetPath());
  CHECK_FALSE(fs::exists(folder.Path(part)));
  CHECK(folder.Read("a") == "new");
  RemoveStaleParts("/no/such/folder");
}

}  // namespace argos::file_replacement_test
