#include <argos3/core/utility/files/output_file.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace output_file_test {

using namespace argos;
using Catch::Contains;

namespace {

std::string Content(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(name).rdbuf();
  return text.str();
}

// the name of a file that is removed by the destructor
class CName {
 public:
  CName() : m_name("argos_output_file_test." + std::to_string(getpid())) {}
  ~CName() { std::remove(m_name.c_str()); }
  operator const std::string&() const { return m_name; }

 private:
  std::string m_name;
};

// runs a function in a process whose files cannot exceed a size. @return its exit status
template <typename FUNCTION>
int RunWithFileSize(rlim_t bytes, FUNCTION&& function) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    _exit(function());
  }
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("output file: what is written is in the file when it is closed", "[core][files]") {
  const CName name;
  std::ofstream(name) << "old";
  COutputFile file(name);
  CHECK(file.IsOpen());
  CHECK(Content(name).empty());
  file << "a," << 1.5 << '\n' << "no end";
  CHECK(file.GetSize() == 12);
  file.Close();
  CHECK_FALSE(file.IsOpen());
  CHECK(Content(name) == "a,1.5\nno end");
  file.Close();
  file.Open(name, COutputFile::EStart::Append);
  CHECK(file.GetSize() == 12);
  file << " yet\n";
  file.Close();
  CHECK(Content(name) == "a,1.5\nno end yet\n");
}

TEST_CASE("output file: at any time the file has whole lines, and flush writes the rest",
          "[core][files]") {
  const CName name;
  COutputFile file(name);
  bool hadLines = false;
  for (int line = 0; line < 20000; ++line) {
    file << "line " << line << '\n';
    if (line % 1000 == 0) {
      const std::string content = Content(name);
      REQUIRE((content.empty() || content.back() == '\n'));
      hadLines = hadLines || !content.empty();
    }
  }
  CHECK(hadLines);
  file << "half a line" << std::flush;
  CHECK_THAT(Content(name), Catch::EndsWith("\nline 19999\nhalf a line"));
}

TEST_CASE("output file: lines of 1 MiB or more are written in parts", "[core][files]") {
  const CName name;
  COutputFile file(name);
  file << std::string((1 << 20) - 1, 'x');
  CHECK(Content(name).empty());
  file << "xy";
  CHECK(Content(name).size() == (1 << 20) + 1);
  // the rest of the line follows, and lines are whole again
  file << "z\nhalf";
  file << std::string(40000, 'a') << '\n' << "next";
  CHECK_THAT(Content(name), Catch::EndsWith("a\n"));
  file.Close();
  CHECK(Content(name).size() == (1 << 20) + 1 + 2 + 4 + 40001 + 4);
}

TEST_CASE("output file: single characters fill the buffer, too", "[core][files]") {
  const CName name;
  COutputFile file(name);
  for (int i = 0; i < 40000; ++i) {
    file.put(i % 100 == 99 ? '\n' : 'x');
  }
  CHECK(Content(name).size() >= 32700);
  CHECK_THAT(Content(name), Catch::EndsWith("\n"));
  file.Close();
  CHECK(Content(name).size() == 40000);
  // nothing can be written then
  file.exceptions(std::ios::goodbit);
  file.put('x');
  CHECK(file.bad());
}

TEST_CASE("output file: a full disk is an exception with file and reason", "[core][files]") {
  COutputFile file("/dev/full");
  file << "text\n";
  CHECK_THROWS_WITH(file.Close(),
                    Contains("cannot write the file \"/dev/full\": No space left on device"));
  CHECK(file.GetReason() == "No space left on device");
  CHECK_FALSE(file.IsOpen());
  // reported once
  CHECK_NOTHROW(file.Close());
  CHECK(TakeOutputFailures().empty());

  file.Open("/dev/full");
  CHECK(file.GetFailure().empty());
  CHECK_THROWS_AS(file << std::string(100000, 'x') + '\n', CARGoSException);
  CHECK_THROWS_WITH(file.WriteRecord("record\n"), Contains("cannot write the file \"/dev/full\""));
  CHECK_THROWS_WITH(file.Replace("content"), Contains("cannot write the file \"/dev/full\""));
  CHECK_NOTHROW(file.Close());
}

TEST_CASE("output file: a failure in the destructor is kept for the program", "[core][files]") {
  {
    COutputFile file("/dev/full");
    file << "text\n";
  }
  const std::vector<std::string> failures = TakeOutputFailures();
  REQUIRE(failures.size() == 1);
  CHECK_THAT(failures[0], Contains("/dev/full"));
  CHECK(TakeOutputFailures().empty());
}

TEST_CASE("output file: after a failure the file ends with its last whole line", "[core][files]") {
  // from the first byte to beyond the buffer
  const rlim_t bytes = GENERATE(0u, 1u, 5u, 6u, 7u, 1000u, 33000u, 70001u);
  CAPTURE(bytes);
  const CName name;
  const int status = RunWithFileSize(bytes, [&name] {
    try {
      COutputFile file(name);
      for (int line = 0; line < 20000; ++line) {
        file << "abcde\n";
      }
      file.Close();
    } catch (const CARGoSException& error) {
      return std::string(error.what()).find("File too large") == std::string::npos ? 2 : 1;
    }
    return 0;
  });
  CHECK(status == 1);
  const std::string content = Content(name);
  CHECK(content.size() == bytes / 6 * 6);
  CHECK((content.empty() || content.back() == '\n'));
}

TEST_CASE("output file: appended lines that fail leave the earlier ones", "[core][files]") {
  const CName name;
  std::ofstream(name) << "earlier, without an end";
  CHECK(RunWithFileSize(25, [&name] {
          COutputFile file(name, COutputFile::EStart::Append);
          file << "a later line";
          try {
            file.Close();
          } catch (const CARGoSException&) {
            return 1;
          }
          return 0;
        }) == 1);
  CHECK(Content(name) == "earlier, without an end");
}

TEST_CASE("output file: a file is open once", "[core][files]") {
  const CName name;
  COutputFile first(name);
  first << "first\n";
  COutputFile second;
  CHECK_THROWS_WITH(second.Open(name),
                    Contains("cannot write the file") && Contains("process is writing it"));
  first.Close();
  CHECK(Content(name) == "first\n");
  CHECK_NOTHROW(second.Open(name));
  // devices may be shared
  COutputFile null("/dev/null");
  CHECK_NOTHROW(COutputFile("/dev/null"));
}

TEST_CASE("output file: errors of opening have file and reason", "[core][files]") {
  CHECK_THROWS_WITH(COutputFile("/no/such/folder/x"),
                    Contains("\"/no/such/folder/x\": No such file or directory"));
  CHECK_THROWS_WITH(COutputFile("/tmp"), Contains("\"/tmp\": Is a directory"));
  COutputFile closed;
  CHECK_THROWS(closed << "lost");
}

TEST_CASE("output file: its content is replaced at once, and what follows is appended",
          "[core][files]") {
  const CName name;
  COutputFile file(name);
  file << "one\ntwo\n" << std::flush;
  std::ifstream reader(name);
  file.Replace("three\n");
  CHECK(Content(name) == "three\n");
  CHECK(file.GetSize() == 6);
  file.WriteRecord("four\n");
  CHECK(Content(name) == "three\nfour\n");
  // who had opened it still has the old one
  std::ostringstream old;
  old << reader.rdbuf();
  CHECK(old.str() == "one\ntwo\n");
  // it is still locked
  CHECK_THROWS_WITH(COutputFile(name), Contains("this process is writing it"));
  file.Close();
  CHECK(Content(name) == "three\nfour\n");
}

}  // namespace output_file_test
