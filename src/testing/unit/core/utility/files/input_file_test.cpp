#include <argos3/core/utility/files/input_file.h>

#include <catch2/catch.hpp>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

namespace input_file_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string NewName() {
  return "argos_input_file_test." + std::to_string(getpid());
}

}  // namespace

TEST_CASE("input file: the whole file is read, with all bytes", "[core][files]") {
  const std::string name = NewName();
  std::string written;
  for (int i = 0; i < 200000; ++i) {
    written.push_back(static_cast<char>(i % 256));
  }
  std::ofstream(name, std::ios::binary) << written;
  std::string content = "old";
  std::string problem = "old";
  CHECK(ReadInputFile(name, content, problem));
  CHECK(content == written);
  CHECK(problem.empty());
  std::remove(name.c_str());
}

TEST_CASE("input file: what is no file is named, without waiting", "[core][files]") {
  const std::string name = NewName() + ".fifo";
  REQUIRE(mkfifo(name.c_str(), 0600) == 0);
  std::string content;
  std::string problem;
  CHECK_FALSE(ReadInputFile(name, content, problem));
  CHECK_THAT(problem, Contains("FIFO"));
  CHECK_FALSE(ReadInputFile("/dev/zero", content, problem));
  CHECK_THAT(problem, Contains("device"));
  CHECK_FALSE(ReadInputFile("/tmp", content, problem));
  CHECK_THAT(problem, Contains("directory"));
  CHECK_FALSE(ReadInputFile("/no/such/file", content, problem));
  CHECK(problem == "No such file or directory");
  CHECK(FindInputProblem("/proc/self/status").empty());
  std::remove(name.c_str());
}

}  // namespace input_file_test
