#include <argos3/core/simulator/program/argos_command_line_arg_parser.h>

#include <argos3/core/config.h>
#include <argos3/core/simulator/catalogue/plugin_kinds.h>
#include <argos3/core/simulator/catalogue/schema.h>
#include <argos3/core/simulator/catalogue/text_layout.h>
#include <argos3/core/simulator/catalogue/version_text.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace argos {

namespace {

constexpr char kFooter[] = R"(
Examples:
  argos3 -c experiment.argos                  run an experiment
  argos3 -zc experiment.argos                 the same, without its visualization
  argos3 -c experiment.argos --seed 7 --threads 4 --length 60
                                              another seed, four threads, 60 simulated seconds
  argos3 -c experiment.argos --set "//distribute/entity/@quantity=500"
                                              change an attribute of the file for this run
  argos3 -c experiment.argos --csv out        poses and metrics, as tables in the folder out
  argos3 -zc experiment.argos --record run.rec
                                              record a run
  argos3 -zc experiment.argos --video run.mp4 --speed 2
                                              a film of a run, twice as fast as real time
  argos3 --replay run.rec --from 10s --to 20s --every 5 -c other_cameras.argos
                                              show a part of it, every 5 ticks, in other views
  argos3 -n -l log.txt -e errors.txt -c experiment.argos
                                              write the two logs to files
  argos3 -q sensors                           list all sensors
  argos3 -q footbot_proximity                 all facts about the plug-ins of that name
  argos3 -q range_and_bearing --json          the same for programs
  argos3 --schema rng > argos.rng             a schema for editors

Words for --query:
  QUERY_WORDS      a list of that kind; libraries can add kinds, such as dynamics3d_add_ons
  all: all the lists; names: all names, for the completion of shells
  other words: all facts about the plug-ins of that name, or whose name contains
  the word: C++ and Lua interface, robots, XML. With -c, the libraries that the
  experiment file names are known, too. Status 1 if nothing was found.

Paths for --set use XPath notation: /argos-configuration/framework/experiment/@length,
arena/distribute[2]/entity/@quantity, //foot-bot[@id='fb0']/body/@position.

Environment:
  ARGOS_FFMPEG       the program that encodes films, by default the ffmpeg in PATH
  ARGOS_INCLUDE_PATH folders, separated by colons, with headers of your control interfaces, for -q
  ARGOS_PLUGIN_PATH  folders, separated by colons, that are searched for libraries first
  NO_COLOR           if set, logs have no colours

Exit status: 0 after a normal end, 1 after an error (also if an output cannot be written), 3 if the
run ended normally but errors had stopped robots (on_error), 130 or 143 if stopped by SIGINT or
SIGTERM.
)";

std::string Title() {
  return std::string("argos3, a simulator for swarms of robots, version ") + ARGOS_VERSION + "-" +
         ARGOS_RELEASE + "\nReleased under the MIT License.\n";
}

// the values as given by the user; they are parsed by the rules of the experiment file
struct SRawOptions {
  bool Help = false;
  bool Version = false;
  std::string Seed;
  std::string Threads;
  std::string Length;
  std::string From;
  std::string To;
  std::string Every;
  std::vector<std::string> Overrides;
};

class CHelpFormatter : public CLI::Formatter {
 public:
  CHelpFormatter() { column_width(32); }
  std::string make_usage(const CLI::App*, std::string) const override {
    return "Usage: argos3 (-c FILE | --replay FILE [-c FILE] | -q WORD | --schema FORMAT | -h | "
           "-v) [options]\n";
  }
};

// an option with one value; if given repeatedly, the last value counts
CLI::Option* AddSingle(CLI::App& app, const std::string& names, std::string& value,
                       const std::string& description) {
  return app.add_option(names, value, description)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void DefineReplay(CLI::App& app, SRawOptions& raw) {
  const std::string replay = "For a replay";
  AddSingle(app, "--from", raw.From, "begin with this tick, or time: 100, 12.5s")
      ->type_name("TICK|TIMEs")
      ->group(replay);
  AddSingle(app, "--to", raw.To, "end with this tick, or time")
      ->type_name("TICK|TIMEs")
      ->group(replay);
  AddSingle(app, "--every", raw.Every, "ticks from state to state: 10 is ten times as fast")
      ->type_name("N")
      ->group(replay);
}

void DefineOutput(CLI::App& app, CARGoSCommandLineArgParser::SOptions& options) {
  const std::string output = "Output";
  app.add_flag("--json", options.Json, "the answer to --query as JSON")->group(output);
  app.add_flag("-n,--no-color", options.NoColor,
               "no colours in the logs; only terminals get colours")
      ->group(output);
  AddSingle(app, "-l,--log-file", options.LogFile, "write the log to this file; it is truncated")
      ->type_name("FILE")
      ->group(output);
  AddSingle(app, "-e,--logerr-file", options.LogErrFile,
            "write the error log to this file; it is truncated")
      ->type_name("FILE")
      ->group(output);
  AddSingle(app, "--record", options.RecordFile,
            "record the run to this file, for --replay; adds <recording> to <outputs>")
      ->type_name("FILE")
      ->group(output);
  AddSingle(app, "--video", options.VideoFile,
            "make a film, also with -z: .mp4, .webm or .gif; in the view of the file's <offscreen>")
      ->type_name("FILE")
      ->group(output);
  AddSingle(app, "--speed", options.VideoSpeed,
            "simulated seconds in a second of the film; 1, the default, is real time")
      ->type_name("X")
      ->group(output);
}

void DefineRun(CLI::App& app, CARGoSCommandLineArgParser::SOptions& options, SRawOptions& raw) {
  const std::string run = "For the run (with -c)";
  app.add_flag("-z,--no-visualization", options.NoVisualization,
               "ignore the <visualization> of the file")
      ->group(run);
  AddSingle(app, "--seed", raw.Seed, "random seed, overrides the file; 0: from the clock")
      ->type_name("N")
      ->group(run);
  AddSingle(app, "--threads", raw.Threads,
            "number of threads, overrides the file; at most 1024; results do not change")
      ->type_name("N")
      ->group(run);
  AddSingle(app, "--length", raw.Length,
            "simulated seconds to run, overrides the file; 0: no limit")
      ->type_name("S")
      ->group(run);
  app.add_option("--set", raw.Overrides,
                 "set an attribute of the file before it is used; may be repeated")
      ->type_name("XPATH=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group(run);
  app.add_flag("--lenient", options.Lenient,
               "read malformed numbers as ARGoS 3 does, with a warning, instead of refusing them")
      ->group(run);
  app.add_flag("--no-crash-handler", options.NoCrashHandler,
               "do not report crashes: for a debugger, or handlers of the user's code")
      ->group(run);
  AddSingle(app, "--csv", options.CSVFolder,
            "write the robots' poses and the metrics of each tick to DIR/robots.csv and "
            "DIR/metrics.csv")
      ->type_name("DIR")
      ->group(run);
  app.add_flag("--digest", options.Digest,
               "print a digest of the final state; equal runs, equal digests")
      ->group(run);
}

void Define(CLI::App& app, CARGoSCommandLineArgParser::SOptions& options, SRawOptions& raw) {
  app.set_help_flag();
  app.allow_extras();
  app.footer(kFooter);
  app.formatter(std::make_shared<CHelpFormatter>());

  const std::string actions = "Exactly one of";
  AddSingle(app, "-c,--config-file", options.ExperimentFile, "run the experiment in this file")
      ->type_name("FILE")
      ->group(actions);
  AddSingle(app, "--replay", options.Replay.File,
            "show a recording; with -c, in the views and outputs of that file")
      ->type_name("FILE")
      ->group(actions);
  AddSingle(app, "-q,--query", options.Query, "list or describe plug-ins, see below")
      ->type_name("WORD")
      ->group(actions);
  AddSingle(app, "--schema", options.SchemaFormat,
            "print a schema of experiment files, for editors: rng (RELAX NG) or rnc (compact)")
      ->type_name("FORMAT")
      ->group(actions);
  app.add_flag("-h,--help", raw.Help, "print this text")->group(actions);
  app.add_flag("-v,--version", raw.Version, "print the version and how it was built")
      ->group(actions);

  DefineOutput(app, options);
  DefineReplay(app, raw);
  DefineRun(app, options, raw);
}

// collects problems, so that all of them are reported together
class CProblems {
 public:
  void Add(const std::string& problem) { m_problems.push_back(problem); }

  void ThrowIfAny() const {
    if (m_problems.empty()) {
      return;
    }
    std::string text = m_problems.size() == 1 ? "invalid command line: " : "invalid command line:";
    for (const std::string& problem : m_problems) {
      text += (m_problems.size() == 1 ? "" : "\n  - ") + problem;
    }
    THROW_ARGOSEXCEPTION(text << "\nTry argos3 --help");
  }

 private:
  std::vector<std::string> m_problems;
};

std::vector<std::string> OptionNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

void CheckRepetitions(const CLI::App& app, CProblems& problems) {
  for (const CLI::Option* option : app.get_options()) {
    const bool takesOneValue =
        option->get_expected_min() > 0 &&
        option->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeLast;
    if (takesOneValue && option->count() > 1) {
      problems.Add("--" + option->get_lnames().front() + " is given " +
                   std::to_string(option->count()) + " times");
    }
  }
}

void CheckStrayWords(const CLI::App& app, CProblems& problems) {
  bool afterUnknownOption = false;
  for (const std::string& word : app.remaining()) {
    if (word.size() > 1 && word[0] == '-' && word != "--") {
      const std::string name = word.substr(0, word.find('='));
      problems.Add("unknown option " + name + DidYouMean(name, OptionNames(app)));
      afterUnknownOption = true;
    } else {
      // the word may be the value of the unknown option
      if (!afterUnknownOption) {
        problems.Add(
            '"' + word + "\" belongs to no option" +
            (word.find(".argos") != std::string::npos ? "; an experiment file goes after -c" : ""));
      }
      afterUnknownOption = false;
    }
  }
}

template <typename T>
void ReadNumber(const CLI::App& app, const std::string& name, const std::string& text, T maximum,
                const char* expected, std::optional<T>& value, CProblems& problems) {
  if (app.count(name) == 0) {
    return;
  }
  T number = T();
  if (ParseNumber(text, number) != ENumberParsing::Ok || number < T() || number > maximum) {
    problems.Add(name + " " + text + ": expected " + expected);
    return;
  }
  value = number;
}

void CheckVideoSpeed(const CLI::App& app, const std::string& text, CProblems& problems) {
  constexpr Real kLargestSpeed = 10000.0;
  std::optional<Real> speed;
  ReadNumber(app, "--speed", text, kLargestSpeed, "a number from 0.0001 to 10000", speed, problems);
  if (speed && *speed < 1.0 / kLargestSpeed) {
    problems.Add("--speed " + text + ": expected a number from 0.0001 to 10000");
  }
  if (app.count("--speed") > 0 && app.count("--video") == 0) {
    problems.Add("--speed can only be used with --video FILE");
  }
}

// "100" is a tick, "12.5s" a time
void ReadTime(const CLI::App& app, const std::string& name, const std::string& text,
              std::optional<SReplayTime>& time, CProblems& problems) {
  if (app.count(name) == 0) {
    return;
  }
  SReplayTime read;
  read.IsInSeconds = !text.empty() && text.back() == 's';
  UInt32 tick = 0;
  const bool isOk = read.IsInSeconds ? ParseNumber(text.substr(0, text.size() - 1), read.Value) ==
                                               ENumberParsing::Ok &&
                                           read.Value >= 0.0
                                     : ParseNumber(text, tick) == ENumberParsing::Ok;
  if (!isOk) {
    problems.Add(name + " " + text +
                 ": expected a tick, such as 100, or a time in seconds, such as 12.5s");
    return;
  }
  read.Value = read.IsInSeconds ? read.Value : tick;
  time = read;
}

void ReadStep(const CLI::App& app, const std::string& text, UInt32& every, CProblems& problems) {
  std::optional<UInt32> step;
  ReadNumber(app, "--every", text, ~UInt32(0), "a number of ticks, at least 1", step, problems);
  if (step == UInt32(0)) {
    problems.Add("--every 0: expected a number of ticks, at least 1");
  }
  every = step.value_or(1);
}

void ReadOverrides(const std::vector<std::string>& texts,
                   std::vector<std::pair<std::string, std::string>>& overrides,
                   CProblems& problems) {
  for (const std::string& text : texts) {
    // the path itself may contain '=', inside brackets: [@id='fb0']
    size_t equals = 0;
    for (int depth = 0; equals < text.size() && (depth > 0 || text[equals] != '='); ++equals) {
      depth += text[equals] == '[' ? 1 : text[equals] == ']' ? -1 : 0;
    }
    if (equals == 0 || equals == text.size()) {
      problems.Add("--set " + text +
                   ": expected XPATH=VALUE, such as --set framework/experiment/@length=60");
    } else {
      overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
  }
}

CARGoSCommandLineArgParser::EAction ChooseAction(const CLI::App& app, CProblems& problems) {
  using EAction = CARGoSCommandLineArgParser::EAction;
  const std::pair<const char*, EAction> choices[] = {
      {"--config-file", EAction::ACTION_RUN_EXPERIMENT},
      {"--replay", EAction::ACTION_REPLAY},
      {"--query", EAction::ACTION_QUERY_PLUGINS},
      {"--schema", EAction::ACTION_MAKE_SCHEMA},
      {"--help", EAction::ACTION_SHOW_HELP},
      {"--version", EAction::ACTION_SHOW_VERSION}};
  EAction action = EAction::ACTION_UNKNOWN;
  std::string given;
  size_t count = 0;
  for (const auto& [name, choice] : choices) {
    // with --replay, -c names the file of the views; with others, that of the libraries
    const bool isForOthers =
        choice == EAction::ACTION_RUN_EXPERIMENT &&
        app.count("--replay") + app.count("--query") + app.count("--schema") > 0;
    if (app.count(name) > 0 && !isForOthers) {
      action = choice;
      given += (count++ == 0 ? "" : ", ") + std::string(name);
    }
  }
  if (count == 0) {
    problems.Add("one of -c FILE, --replay FILE, -q WORD, --schema FORMAT, -h, -v must be given");
  } else if (count > 1) {
    problems.Add("only one of -c, --replay, -q, --schema, -h, -v may be given, not " + given);
  }
  return action;
}

bool SameFile(const std::string& first, const std::string& second) {
  std::error_code ignored;
  return first == second || std::filesystem::equivalent(first, second, ignored);
}

void CheckFiles(const CLI::App& app, const CARGoSCommandLineArgParser::SOptions& options,
                CProblems& problems) {
  const std::pair<const char*, const std::string*> files[] = {
      {"--config-file", &options.ExperimentFile}, {"--replay", &options.Replay.File},
      {"--record", &options.RecordFile},          {"--video", &options.VideoFile},
      {"--log-file", &options.LogFile},           {"--logerr-file", &options.LogErrFile}};
  for (size_t i = 0; i < std::size(files); ++i) {
    if (app.count(files[i].first) == 0) {
      continue;
    }
    if (files[i].second->empty()) {
      problems.Add(std::string(files[i].first) + " needs the name of a file, not an empty text");
      continue;
    }
    for (size_t j = 0; j < i; ++j) {
      if (app.count(files[j].first) > 0 && SameFile(*files[i].second, *files[j].second)) {
        problems.Add(std::string(files[j].first) + " and " + files[i].first +
                     " are the same file, " + *files[i].second);
      }
    }
  }
}

void CheckFolder(const CLI::App& app, const CARGoSCommandLineArgParser::SOptions& options,
                 CProblems& problems) {
  if (app.count("--csv") > 0 && options.CSVFolder.empty()) {
    problems.Add("--csv needs the name of a folder, not an empty text; . is the current one");
  }
}

void CheckNeedsRun(const CLI::App& app, CProblems& problems) {
  for (const char* name : {"--seed", "--threads", "--length", "--set", "--lenient", "--digest",
                           "--csv", "--record", "--video"}) {
    if (app.count(name) > 0) {
      problems.Add(std::string(name) + " can only be used with -c FILE");
    }
  }
}

void CheckSchema(const CLI::App& app, const std::string& format, CProblems& problems) {
  if (app.count("--schema") > 0 && !IsSchemaFormat(format)) {
    problems.Add("--schema " + format + ": expected rng or rnc");
  }
  if (app.count("--json") > 0 && app.count("--query") == 0) {
    problems.Add("--json can only be used with -q WORD");
  }
}

void CheckFitsReplay(const CLI::App& app, bool isReplay, CProblems& problems) {
  if (!isReplay) {
    for (const char* name : {"--from", "--to", "--every"}) {
      if (app.count(name) > 0) {
        problems.Add(std::string(name) + " can only be used with --replay FILE");
      }
    }
    return;
  }
  for (const char* name : {"--seed", "--threads", "--length", "--lenient", "--digest"}) {
    if (app.count(name) > 0) {
      problems.Add(std::string(name) +
                   " cannot be used with --replay, which simulates nothing: it shows what was "
                   "recorded");
    }
  }
}

}  // namespace

void CARGoSCommandLineArgParser::Parse(SInt32 argc, const char* const* argv) {
  m_options = SOptions();
  SRawOptions raw;
  CLI::App app(Title(), "argos3");
  Define(app, m_options, raw);
  CProblems problems;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    problems.Add(error.what());
    problems.ThrowIfAny();
  }

  CheckRepetitions(app, problems);
  CheckStrayWords(app, problems);
  m_options.Action = ChooseAction(app, problems);
  ReadNumber(app, "--seed", raw.Seed, ~UInt32(0), "an integer from 0 to 4294967295", m_options.Seed,
             problems);
  ReadNumber(app, "--threads", raw.Threads, kMaxThreads, "an integer from 0 to 1024",
             m_options.Threads, problems);
  ReadNumber(app, "--length", raw.Length, 1e18, "a number of seconds, at least 0", m_options.Length,
             problems);
  ReadOverrides(raw.Overrides, m_options.Overrides, problems);
  CheckFiles(app, m_options, problems);
  CheckFolder(app, m_options, problems);
  CheckVideoSpeed(app, m_options.VideoSpeed, problems);
  ReadTime(app, "--from", raw.From, m_options.Replay.From, problems);
  ReadTime(app, "--to", raw.To, m_options.Replay.To, problems);
  ReadStep(app, raw.Every, m_options.Replay.Every, problems);
  m_options.Replay.ViewsFile = m_options.ExperimentFile;
  CheckFitsReplay(app, app.count("--replay") > 0, problems);
  CheckSchema(app, m_options.SchemaFormat, problems);
  if (m_options.Action == ACTION_QUERY_PLUGINS || m_options.Action == ACTION_MAKE_SCHEMA ||
      m_options.Action == ACTION_SHOW_HELP || m_options.Action == ACTION_SHOW_VERSION) {
    CheckNeedsRun(app, problems);
  }
  problems.ThrowIfAny();
}

namespace {

// of the kinds that the core knows
std::string JoinQueryWords() {
  std::string words;
  for (const SPluginKind& kind : ListPluginKinds()) {
    words += !kind.Of.empty() ? "" : (words.empty() ? "" : ", ") + kind.Word;
  }
  Replace(words, "visualizations", "visualizations (or outputs)");
  return Wrapped(words, 2).substr(2, std::string::npos);
}

}  // namespace

std::string CARGoSCommandLineArgParser::GetUsage() {
  SOptions options;
  SRawOptions raw;
  CLI::App app(Title(), "argos3");
  Define(app, options, raw);
  std::string usage = app.help();
  Replace(usage, "QUERY_WORDS", JoinQueryWords());
  Replace(usage, "\n\n\n", "\n\n");
  return usage;
}

void CARGoSCommandLineArgParser::PrintUsage(CARGoSLog& log) const {
  log << GetUsage();
}

std::string CARGoSCommandLineArgParser::GetVersion() {
  return DescribeVersion();
}

}  // namespace argos
