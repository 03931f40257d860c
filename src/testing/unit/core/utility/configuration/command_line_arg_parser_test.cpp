#include <argos3/core/utility/configuration/command_line_arg_parser.h>

#include <catch2/catch.hpp>

#include <sstream>

namespace command_line_arg_parser_test {

using namespace argos;
using Catch::Contains;

namespace {

// a program with one option of each kind
struct SProgram {
  SProgram() {
    Parser.AddFlag('z', "quiet", "says less", Quiet);
    Parser.AddFlag('n', "no-color", "without colours", NoColor);
    Parser.AddArgument('c', "config-file", "what to run", File);
    Parser.AddArgument('t', "threads", "how many threads", Threads);
  }
  void Parse(std::vector<std::string> words) {
    std::vector<char*> arguments;
    words.insert(words.begin(), "program");
    for (std::string& word : words) {
      arguments.push_back(word.data());
    }
    Parser.Parse(static_cast<SInt32>(arguments.size()), arguments.data());
  }
  CCommandLineArgParser Parser;
  bool Quiet = true;
  bool NoColor = true;
  std::string File = "default";
  UInt32 Threads = 3;
};

}  // namespace

TEST_CASE("command line: flags are off and values keep their defaults", "[core][command_line]") {
  SProgram program;
  program.Parse({});
  CHECK_FALSE(program.Quiet);
  CHECK_FALSE(program.NoColor);
  CHECK(program.File == "default");
  CHECK(program.Threads == 3);
}

TEST_CASE("command line: short and long options", "[core][command_line]") {
  SProgram program;
  program.Parse({"-c", "a file", "--threads", "8", "--quiet"});
  CHECK(program.File == "a file");
  CHECK(program.Threads == 8);
  CHECK(program.Quiet);
  CHECK_FALSE(program.NoColor);
}

TEST_CASE("command line: short flags can be combined, and the last may take a value",
          "[core][command_line]") {
  SProgram program;
  program.Parse({"-znc", "x"});
  CHECK(program.Quiet);
  CHECK(program.NoColor);
  CHECK(program.File == "x");
}

TEST_CASE("command line: unknown options and invalid values are errors", "[core][command_line]") {
  SProgram program;
  CHECK_THROWS_WITH(program.Parse({"--thread", "2"}),
                    Contains("Unknown option \"--thread\"; did you mean \"--threads\""));
  CHECK_THROWS_WITH(program.Parse({"---threads", "2"}),
                    Contains("Unknown option \"---threads\"; did you mean \"--threads\""));
  CHECK_THROWS_WITH(program.Parse({"--config-file=x"}),
                    Contains("Unknown option \"--config-file=x\""));
  CHECK_THROWS_WITH(program.Parse({"-x"}),
                    Contains("Unknown option \"-x\"; known: -z, -n, -c, -t"));
  CHECK_THROWS_WITH(program.Parse({"-c"}), Contains("Option -c: its value is missing"));
  CHECK_THROWS_WITH(program.Parse({"-t", "many"}),
                    Contains("Option --threads: found \"many\", expected an integer from 0"));
  CHECK_THROWS_WITH(program.Parse({"stray"}), Contains("The word \"stray\" belongs to no option"));
  CHECK_THROWS_WITH(program.Parse({"-cz", "x"}), Contains("must be the last of the group"));
  bool flag = false;
  CHECK_THROWS_WITH(program.Parser.AddFlag('z', "zoom", "", flag),
                    Contains("there is -z, --quiet"));
  CHECK_THROWS_AS(program.Parser.AddFlag('y', "threads", "", flag), CARGoSException);
}

TEST_CASE("command line: the usage lists all options in order", "[core][command_line]") {
  SProgram program;
  std::ostringstream stream;
  {
    CARGoSLog log(stream, SLogColor(), false);
    program.Parser.PrintUsage(log);
    log.Flush();
  }
  CHECK(stream.str() ==
        "   -z  --quiet               says less\n"
        "   -n  --no-color            without colours\n"
        "   -c  --config-file VALUE   what to run\n"
        "   -t  --threads VALUE       how many threads\n");
}

}  // namespace command_line_arg_parser_test
