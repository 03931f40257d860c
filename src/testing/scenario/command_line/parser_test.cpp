// Parsing of the command line.

#include <argos3/core/simulator/argos_command_line_arg_parser.h>
#include <argos3/program/option_table.h>
#include <argos3/program/shell_documents.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <argos3/core/config.h>

#include <catch2/catch.hpp>

#include <sstream>

namespace parser_test {

using namespace argos;
using Catch::Contains;

namespace {

using TParser = CARGoSCommandLineArgParser;

TParser::SOptions Parse(const std::vector<const char*>& arguments) {
  std::vector<const char*> argv{"argos3"};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  TParser parser;
  parser.Parse(static_cast<SInt32>(argv.size()), argv.data());
  return parser.GetOptions();
}

// words with one blank between them
std::string JoinLines(const std::string& text) {
  std::istringstream words(text);
  std::string joined;
  for (std::string word; words >> word;) {
    joined += joined.empty() ? "" : " ";
    joined += word;
  }
  return joined;
}

std::string ErrorOf(const std::vector<const char*>& arguments) {
  try {
    Parse(arguments);
  } catch (const CARGoSException& ex) {
    return ex.what();
  }
  return "";
}

}  // namespace

TEST_CASE("command line: the four actions are recognised", "[command_line]") {
  CHECK(Parse({"-c", "a.argos"}).Action == TParser::ACTION_RUN_EXPERIMENT);
  CHECK(Parse({"--config-file", "a.argos"}).ExperimentFile == "a.argos");
  CHECK(Parse({"-q", "all"}).Action == TParser::ACTION_QUERY_PLUGINS);
  CHECK(Parse({"--query", "led"}).Query == "led");
  CHECK(Parse({"-h"}).Action == TParser::ACTION_SHOW_HELP);
  CHECK(Parse({"--help"}).Action == TParser::ACTION_SHOW_HELP);
  CHECK(Parse({"-v"}).Action == TParser::ACTION_SHOW_VERSION);
  CHECK(Parse({"--version"}).Action == TParser::ACTION_SHOW_VERSION);
}

TEST_CASE("command line: --live takes a port only behind '='", "[command_line]") {
  CHECK_FALSE(Parse({"a.argos"}).LivePort.has_value());
  const TParser::SOptions options = Parse({"--live", "a.argos"});
  CHECK(options.LivePort == UInt16(0));
  CHECK(options.ExperimentFile == "a.argos");
  CHECK(Parse({"a.argos", "--live=8000"}).LivePort == UInt16(8000));
  CHECK(Parse({"--replay", "r.rec", "--live"}).LivePort == UInt16(0));
  CHECK_THAT(ErrorOf({"a.argos", "--live=65536"}), Contains("expected a port"));
  CHECK_THAT(ErrorOf({"a.argos", "--live=x"}), Contains("expected a port"));
  CHECK_THAT(ErrorOf({"-q", "all", "--live"}), Contains("only be used with an experiment"));
  CHECK_THAT(ErrorOf({"a.argos", "--live", "--replay-commands", "r.rec"}),
             Contains("only one of --live and --replay-commands"));
  CHECK_THAT(ErrorOf({"a.argos", "--html", "a.html"}), Contains("with --replay"));
}

TEST_CASE("command line: --live-socket lets viewers come and go", "[command_line]") {
  CHECK(Parse({"a.argos"}).LiveURLFile.empty());
  CHECK(Parse({"-z", "--live-socket", "a.argos"}).LiveURLFile == "auto");
  CHECK(Parse({"a.argos", "--live-socket=run.url"}).LiveURLFile == "run.url");
  CHECK_THAT(ErrorOf({"a.argos", "--live", "--live-socket"}),
             Contains("only one of --live and --live-socket"));
}

TEST_CASE("command line: an experiment needs no option", "[command_line]") {
  const TParser::SOptions first = Parse({"a.argos", "--seed", "3", "-z"});
  CHECK(first.Action == TParser::ACTION_RUN_EXPERIMENT);
  CHECK(first.ExperimentFile == "a.argos");
  CHECK(first.Seed == 3u);
  CHECK(first.NoVisualization);
  CHECK(Parse({"--threads", "2", "a.argos"}).ExperimentFile == "a.argos");
  CHECK(Parse({"-z", "a.argos"}).ExperimentFile == "a.argos");
  // in a replay it has the views
  const TParser::SOptions replay = Parse({"--replay", "r.rec", "a.argos"});
  CHECK(replay.Action == TParser::ACTION_REPLAY);
  CHECK(replay.Replay.ViewsFile == "a.argos");
  CHECK_THAT(ErrorOf({"a", "-l", "a"}), Contains("same file"));
}

TEST_CASE("command line: levels of logs, progress and checks", "[command_line]") {
  CHECK(Parse({"a"}).LogLevel == ELogLevel::Info);
  CHECK(Parse({"a", "--quiet"}).LogLevel == ELogLevel::Warning);
  CHECK(Parse({"a", "--log-level", "error"}).LogLevel == ELogLevel::Error);
  CHECK(Parse({"a", "--log-level", "warning"}).LogLevel == ELogLevel::Warning);
  CHECK(Parse({"a", "--log-level", "debug"}).LogLevel == ELogLevel::Debug);
  CHECK_THAT(ErrorOf({"a", "--log-level", "debg"}),
             Contains("--log-level debg: unknown; did you mean \"debug\"?"));
  CHECK_THAT(ErrorOf({"a", "--log-level", "info", "--quiet"}),
             Contains("only one of --quiet and --log-level"));
  CHECK_FALSE(Parse({"a"}).ProgressPeriod.has_value());
  CHECK(Parse({"a", "--progress", "2.5"}).ProgressPeriod == 2.5);
  CHECK_THAT(ErrorOf({"a", "--progress", "-1"}), Contains("--progress -1: expected a number"));
  CHECK(Parse({"a", "--check"}).Check);
  CHECK_THAT(ErrorOf({"--replay", "r", "--check"}), Contains("--check cannot be used with"));
  CHECK_THAT(ErrorOf({"-q", "all", "--quiet"}), Contains("--quiet can only be used with an"));
}

TEST_CASE("command line: what can be generated", "[command_line]") {
  CHECK(Parse({"--generate", "man"}).Action == TParser::ACTION_GENERATE);
  CHECK(Parse({"--generate", "xpaths", "-c", "a"}).ExperimentFile == "a");
  CHECK_THAT(ErrorOf({"--generate", "xpaths"}), Contains("needs an experiment"));
  CHECK_THAT(ErrorOf({"--generate", "fish"}), Contains("known: man, bash, zsh, plugins, xpaths"));
}

TEST_CASE("command line: help, man page and completions have all options", "[command_line]") {
  const std::string usage = TParser::GetUsage();
  const std::string bash = MakeBashCompletion();
  const std::string zsh = MakeZshCompletion();
  std::string man = MakeManPage();
  Replace(man, "\\-", "-");
  REQUIRE(GetCommandLineOptions().size() >= 28);
  for (const SCommandLineOption& option : GetCommandLineOptions()) {
    const std::string name = option.GetLongName();
    CAPTURE(name);
    CHECK_THAT(usage, Contains(option.Names));
    CHECK_THAT(JoinLines(usage), Contains(option.Help));
    CHECK_THAT(man, Contains(name) && Contains(option.Help));
    CHECK_THAT(bash, Contains(' ' + name) || Contains('|' + name) || Contains('\'' + name));
    CHECK_THAT(zsh, Contains(name + "'[") || Contains(name + "}'["));
  }
  for (const SHelpSection& section : GetHelpSections()) {
    CHECK_THAT(usage, Contains(section.Heading + ":\n" + section.Text));
    CHECK_THAT(man, Contains(".SH " + StringToUpperCase(section.Heading)));
  }
}

TEST_CASE("command line: options that are not given keep their defaults", "[command_line]") {
  const TParser::SOptions options = Parse({"-c", "a.argos"});
  CHECK_FALSE(options.NoColor);
  CHECK_FALSE(options.NoVisualization);
  CHECK_FALSE(options.Digest);
  CHECK(options.LogFile.empty());
  CHECK(options.LogErrFile.empty());
  CHECK_FALSE(options.Seed.has_value());
  CHECK_FALSE(options.Threads.has_value());
  CHECK_FALSE(options.Length.has_value());
  CHECK(options.Overrides.empty());
}

TEST_CASE("command line: every other option is recognised", "[command_line]") {
  const TParser::SOptions options =
      Parse({"-c", "a.argos", "-n", "-z", "-l", "log", "-e", "err", "--seed", "4294967295",
             "--threads", "4", "--length", "2.5", "--digest"});
  CHECK(options.NoColor);
  CHECK(options.NoVisualization);
  CHECK(options.LogFile == "log");
  CHECK(options.LogErrFile == "err");
  CHECK(options.Seed == 4294967295u);
  CHECK(options.Threads == 4u);
  CHECK(options.Length == 2.5);
  CHECK(options.Digest);
  CHECK(Parse({"-c", "a", "--no-color"}).NoColor);
  CHECK(Parse({"-c", "a", "--no-visualization"}).NoVisualization);
  CHECK(Parse({"-c", "a", "--log-file", "x"}).LogFile == "x");
  CHECK(Parse({"-c", "a", "--logerr-file", "x"}).LogErrFile == "x");
}

TEST_CASE("command line: short flags can be combined, and the last can take a value",
          "[command_line]") {
  CHECK(Parse({"-zn", "-c", "a"}).NoColor);
  CHECK(Parse({"-zn", "-c", "a"}).NoVisualization);
  const TParser::SOptions options = Parse({"-nzc", "a"});
  CHECK(options.NoColor);
  CHECK(options.NoVisualization);
  CHECK(options.ExperimentFile == "a");
}

TEST_CASE("command line: --set splits at the first '=' outside brackets", "[command_line]") {
  const auto overrides =
      Parse({"-c", "a", "--set", "framework/experiment/@length=5", "--set",
             "//foot-bot[@id='fb0']/body/@position=1,2,0", "--set", "x/@y=", "--set", "x/@y=a=b"})
          .Overrides;
  REQUIRE(overrides.size() == 4);
  CHECK(overrides[0].first == "framework/experiment/@length");
  CHECK(overrides[0].second == "5");
  CHECK(overrides[1].first == "//foot-bot[@id='fb0']/body/@position");
  CHECK(overrides[1].second == "1,2,0");
  CHECK(overrides[2].second.empty());
  CHECK(overrides[3].second == "a=b");
}

TEST_CASE("command line: mistakes that beginners make with dashes and values", "[command_line]") {
  CHECK_THAT(ErrorOf({"f.argos", "-check"}),
             Contains("unknown option -check; did you mean \"--check\"?"));
  CHECK_THAT(ErrorOf({"-length=5", "f.argos"}), Contains("did you mean \"--length\"?"));
  CHECK_THAT(ErrorOf({"f.argos", "--length"}), Contains("--length needs a value: S"));
  CHECK(Parse({"-zc", "f.argos"}).NoVisualization);
  CHECK(Parse({"f.argos", "--help"}).Action == TParser::ACTION_SHOW_HELP);
  const TParser::SOptions query = Parse({"f.argos", "-q", "leds"});
  CHECK(query.Action == TParser::ACTION_QUERY_PLUGINS);
  CHECK(query.ExperimentFile == "f.argos");
}

TEST_CASE("command line: a query without a word is one for all", "[command_line]") {
  CHECK(Parse({"-q"}).Query == "all");
  CHECK(Parse({"-q", "--json"}).Query == "all");
  CHECK(Parse({"-c", "f.argos", "--query"}).Query == "all");
  CHECK(Parse({"-q", "leds"}).Query == "leds");
  CHECK_THAT(ErrorOf({"-q", "leds", "-q"}), Contains("--query is given 2 times"));
}

TEST_CASE("command line: there must be exactly one action", "[command_line]") {
  CHECK_THAT(ErrorOf({}), Contains("one of FILE, --replay FILE, -q WORD, --schema FORMAT, "
                                   "--generate WORD, -h, -v must be given"));
  CHECK_THAT(ErrorOf({"-n"}), Contains("must be given"));
  CHECK_THAT(ErrorOf({"--replay", "a", "-q", "b"}), Contains("only one of") && Contains("--query"));
  CHECK_THAT(ErrorOf({"-h", "-v"}), Contains("only one of"));
}

TEST_CASE("command line: the error on an unknown option names the nearest", "[command_line]") {
  CHECK_THAT(ErrorOf({"-c", "a", "--thread", "2"}),
             Contains("--thread;") && Contains("\"--threads\"") && !Contains("\"2\""));
  CHECK_THAT(ErrorOf({"-c", "a", "--sed=3"}), Contains("--sed") && Contains("--seed"));
  CHECK_THAT(ErrorOf({"-c", "a", "-x"}), Contains("-x"));
  CHECK_THAT(ErrorOf({"-znx", "-c", "a"}), Contains("-x"));
}

TEST_CASE("command line: words without an option are errors", "[command_line]") {
  CHECK_THAT(ErrorOf({"-c", "a.argos", "7"}),
             Contains("\"7\" belongs to no option; the experiment is a.argos"));
  CHECK_THAT(ErrorOf({"a.argos", "b.argos"}), Contains("\"b.argos\" belongs to no option"));
  CHECK_THAT(ErrorOf({"-c", "a.argos", "--", "b"}), Contains("\"b\""));
}

TEST_CASE("command line: missing and malformed values are errors", "[command_line]") {
  CHECK_THAT(ErrorOf({"-c"}), Contains("--config-file"));
  CHECK_THAT(ErrorOf({"-c", ""}), Contains("--config-file"));
  CHECK_THAT(ErrorOf({"-c", "a", "--seed"}), Contains("--seed"));
  CHECK_THAT(ErrorOf({"-c", "a", "-l", ""}), Contains("--log-file"));
  const auto [option, value] =
      GENERATE(table<const char*, const char*>({{"--seed", "-1"},
                                                {"--seed", "4294967296"},
                                                {"--seed", "1.5"},
                                                {"--seed", "0x10"},
                                                {"--seed", "one"},
                                                {"--seed", ""},
                                                {"--threads", "-2"},
                                                {"--threads", "1025"},
                                                {"--threads", "many"},
                                                {"--length", "-1"},
                                                {"--length", "nan"},
                                                {"--length", "inf"},
                                                {"--length", "10s"},
                                                {"--set", "no_equals_sign"},
                                                {"--set", "=value"}}));
  CAPTURE(option, value);
  CHECK_THAT(ErrorOf({"-c", "a", option, value}), Contains(option) && Contains("expected"));
}

TEST_CASE("command line: an option with a value may be given only once", "[command_line]") {
  CHECK_THAT(ErrorOf({"-c", "a", "-c", "b"}), Contains("--config-file is given 2 times"));
  CHECK_THAT(ErrorOf({"-c", "a", "--seed", "1", "--seed", "2"}),
             Contains("--seed is given 2 times"));
  CHECK(ErrorOf({"-c", "a", "-z", "-z"}).empty());
}

TEST_CASE("command line: a file may not be used for two purposes", "[command_line]") {
  CHECK_THAT(ErrorOf({"-c", "a", "-l", "x", "-e", "x"}), Contains("same file"));
  CHECK_THAT(ErrorOf({"-c", "a", "-l", "a"}), Contains("same file"));
}

TEST_CASE("command line: options of a run without a run are errors", "[command_line]") {
  CHECK_THAT(ErrorOf({"-q", "all", "--seed", "3"}), Contains("--seed") && Contains("-c"));
  CHECK_THAT(ErrorOf({"-v", "--digest"}), Contains("--digest"));
}

TEST_CASE("command line: all errors are reported together", "[command_line]") {
  const std::string error = ErrorOf({"--seed", "x", "--threads", "y", "--colour", "z"});
  CHECK_THAT(error, Contains("--seed x"));
  CHECK_THAT(error, Contains("--threads y"));
  CHECK_THAT(error, Contains("--colour"));
  CHECK_THAT(error, Contains("must be given"));
}

TEST_CASE("command line: the help names every option and query word", "[command_line]") {
  const std::string usage = TParser::GetUsage();
  for (const char* word : {"-c,--config-file",
                           "-q,--query",
                           "-h,--help",
                           "-v,--version",
                           "-n,--no-color",
                           "-z,--no-visualization",
                           "-l,--log-file",
                           "-e,--logerr-file",
                           "--seed",
                           "--threads",
                           "--length",
                           "--set",
                           "--csv",
                           "--digest",
                           "fields",
                           "actuators",
                           "sensors",
                           "physics_engines",
                           "media",
                           "visualizations",
                           "entities",
                           "all",
                           "Examples",
                           "ARGOS_PLUGIN_PATH",
                           ARGOS_VERSION}) {
    CAPTURE(word);
    CHECK_THAT(usage, Contains(word));
  }
}

TEST_CASE("command line: the version is printed as lines KEY=value", "[command_line]") {
  const std::string version = TParser::GetVersion();
  CHECK_THAT(version, Contains("ARGOS_VERSION=" ARGOS_VERSION "-" ARGOS_RELEASE "\n"));
  CHECK_THAT(version, Contains("\nARGOS_INSTALL_PREFIX="));
  CHECK_THAT(version, Contains("\nARGOS_USE_DOUBLE=ON\n"));
  CHECK_THAT(version, Contains("\nARGOS_WITH_LUA=O"));
  CHECK_THAT(version, Contains("\nARGOS_BUILD_FLAGS="));
  CHECK_THAT(version, Contains("\nARGOS_COMMIT="));
  CHECK_THAT(version, Contains("\nARGOS_BUILD_TYPE="));
#ifdef __clang__
  CHECK_THAT(version, Contains("\nARGOS_COMPILER=clang "));
#else
  CHECK_THAT(version, Contains("\nARGOS_COMPILER=g++ "));
#endif
  CHECK_THAT(version, Contains("\nARGOS_ENGINES="));
}

}  // namespace parser_test
