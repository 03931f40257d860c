#include <argos3/program/option_table.h>

#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/plugin_kinds.h>
#include <argos3/program/catalogue/text_layout.h>

namespace argos {

namespace {

constexpr char kActions[] = "Exactly one of";
constexpr char kOutput[] = "Output";
constexpr char kReplay[] = "For a replay";
constexpr char kRun[] = "For the run (with an experiment)";

constexpr char kExamples[] = R"(  argos3 experiment.argos                     run an experiment
  argos3 -z experiment.argos                  the same, without its visualization
  argos3 experiment.argos --check             find its errors without running it
  argos3 experiment.argos --seed 7 --threads 4 --length 60
                                              another seed, four threads, 60 simulated seconds
  argos3 experiment.argos --set "//distribute/entity/@quantity=500"
                                              change an attribute of the file for this run
  argos3 experiment.argos --csv out           poses and metrics, as tables in the folder out
  argos3 -z experiment.argos --record run.rec
                                              record a run
  argos3 -z experiment.argos --video run.mp4 --speed 2
                                              a film of a run, twice as fast as real time
  argos3 --replay run.rec --from 10s --to 20s --every 5 -c other_cameras.argos
                                              show a part of it, every 5 ticks, in other views
  argos3 experiment.argos --live              watch and touch a run in a web browser
  argos3 -n -l log.txt -e errors.txt -c experiment.argos
                                              write the two logs to files
  argos3 -q sensors                           list all sensors
  argos3 -q footbot_proximity                 all facts about the plug-ins of that name
  argos3 -q range_and_bearing --json          the same for programs
  argos3 --schema rng > argos.rng             a schema for editors
)";

constexpr char kQuery[] =
    R"(: a list of that kind; libraries can add kinds, such as dynamics3d_add_ons
  all: all the lists
  other words: all facts about the plug-ins of that name, or whose name contains
  the word: C++ and Lua interface, robots, XML. With -c, the libraries that the
  experiment file names are known, too. Status 1 if nothing was found.
)";

constexpr char kPaths[] =
    R"(  XPath notation: /argos-configuration/framework/experiment/@length,
  arena/distribute[2]/entity/@quantity, //foot-bot[@id='fb0']/body/@position.
)";

constexpr char kEnvironment[] =
    R"(  ARGOS_FFMPEG       the program that encodes films, by default the ffmpeg in PATH
  ARGOS_INCLUDE_PATH folders, separated by colons, with headers of your control interfaces, for -q
  ARGOS_OUTPUT_TIMEOUT  s, by default 30: how long an output may make no progress (a FIFO without
                     a reader, a program that encodes films and does nothing) before that is an error
  ARGOS_PLUGIN_PATH  folders, separated by colons, that are searched for libraries first
  NO_COLOR           if set, logs have no colours
)";

constexpr char kExitStatus[] =
    R"(  0 after a normal end, 1 after an error (also if an output cannot be written), 3 if the
  run ended normally but errors had stopped robots (on_error), 128 + n if stopped by signal n:
  130 by SIGINT, 143 by SIGTERM, also by SIGHUP, SIGUSR1, SIGUSR2 and SIGXCPU. If users' code calls
  exit(), its status.
)";

// lists the kinds of plug-ins that the core knows
std::string ListKinds() {
  std::string words;
  for (const SPluginKind& kind : ListPluginKinds()) {
    if (kind.Of.empty()) {
      AppendItem(words, kind.Word);
    }
  }
  Replace(words, "visualizations", "visualizations (or outputs)");
  const std::string lines = Wrapped(words, 2);
  return lines.substr(0, lines.size() - 1);
}

}  // namespace

std::string SCommandLineOption::GetLongName() const {
  return Names.substr(Names.find("--"));
}

std::string SCommandLineOption::GetShortName() const {
  return Names.rfind("--", 0) == 0 ? "" : Names.substr(0, Names.find(','));
}

namespace {

using EUse = EOptionUse;
using EWords = EOptionWords;
using TOptions = std::vector<SCommandLineOption>;
using SOptions = CARGoSCommandLineArgParser::SOptions;
using STexts = SOptionTexts;

TOptions MakeActionOptions() {
  return {
      {"-c,--config-file", "FILE", &SOptions::ExperimentFile, kActions,
       "run the experiment in this file; -c may be left out", EUse::Always, EWords::ExperimentFile},
      {"--replay", "FILE", &STexts::Replay, kActions,
       "show a recording; with -c, in the views and outputs of that file", EUse::Always,
       EWords::Recording},
      {"-q,--query", "[WORD]", &SOptions::Query, kActions,
       "list or describe plug-ins, elements and attributes, see below; without a word, all; with "
       "-c "
       "also those of that file's libraries",
       EUse::Always, EWords::Plugins},
      {"--schema",
       "FORMAT",
       &SOptions::SchemaFormat,
       kActions,
       "print a schema of experiment files, for editors: rng (RELAX NG) or rnc (compact)",
       EUse::Always,
       EWords::Listed,
       {"rng", "rnc"}},
      {"--generate",
       "WORD",
       &SOptions::Generate,
       kActions,
       "print the man page (man), a completion of the shell (bash, zsh), or what completes: the "
       "names of plug-ins (plugins), the attributes of the experiment after -c (xpaths)",
       EUse::Always,
       EWords::Listed,
       {"man", "bash", "zsh", "plugins", "xpaths"}},
      {"-h,--help", "", &STexts::Help, kActions, "print this text"},
      {"-v,--version", "", &STexts::Version, kActions, "print the version and how it was built"},
  };
}

TOptions MakeOutputOptions() {
  return {
      {"--json", "", &SOptions::Json, kOutput, "the answer to --query as JSON", EUse::Query},
      {"-n,--no-color", "", &SOptions::NoColor, kOutput,
       "no colours in the logs; only terminals get colours"},
      {"--quiet", "", &STexts::Quiet, kOutput, "as --log-level warning", EUse::Run},
      {"--log-level",
       "LEVEL",
       &STexts::LogLevel,
       kOutput,
       "least important lines in the logs: error, warning, info (the default), or debug, which "
       "adds the libraries that are loaded and the driver of OpenGL",
       EUse::Run,
       EWords::Listed,
       {"error", "warning", "info", "debug"}},
      {"--progress", "S", &STexts::Progress, kOutput,
       "write a line about the progress every S seconds, into the log file or to the standard "
       "error; "
       "by default 60 unless that is a terminal; 0: never",
       EUse::Run},
      {"-l,--log-file", "FILE", &SOptions::LogFile, kOutput,
       "write the log to this file; it is truncated", EUse::Always, EWords::File},
      {"-e,--logerr-file", "FILE", &SOptions::LogErrFile, kOutput,
       "write the error log to this file; it is truncated", EUse::Always, EWords::File},
      {"--live", "", &STexts::Live, kOutput,
       "show the run in a web browser, in place of the <visualization> of the file; --live=PORT: "
       "at "
       "that port",
       EUse::Run},
      {"--live-socket", "", &STexts::LiveSocket, kOutput,
       "run without waiting for a viewer, and let viewers come and go: `argos3-campaign live` "
       "lists "
       "such runs; --live-socket=FILE: also write the URL into that file while the run lasts",
       EUse::Run},
      {"--record", "FILE", &SOptions::RecordFile, kOutput,
       "record the run to this file, for --replay; adds <recording> to <outputs>", EUse::Run,
       EWords::File},
      {"--video", "FILE", &SOptions::VideoFile, kOutput,
       "make a film, also with -z: .mp4, .webm or .gif; in the view of the file's <offscreen>",
       EUse::Run, EWords::File},
      {"--speed", "X", &SOptions::VideoSpeed, kOutput,
       "simulated seconds in a second of the film; 1, the default, is real time"},
  };
}

TOptions MakeReplayOptions() {
  return {
      {"--from", "TICK|TIMEs", &STexts::From, kReplay, "begin with this tick, or time: 100, 12.5s",
       EUse::Replay},
      {"--to", "TICK|TIMEs", &STexts::To, kReplay, "end with this tick, or time", EUse::Replay},
      {"--every", "N", &STexts::Every, kReplay,
       "ticks from state to state: 10 is ten times as fast", EUse::Replay},
      {"--html", "FILE", &SOptions::HTMLFile, kReplay,
       "write the recording and the page of the live view into one file, which a browser opens; "
       "nothing is replayed",
       EUse::Replay, EWords::File},
  };
}

TOptions MakeRunOptions() {
  return {
      {"-z,--no-visualization", "", &SOptions::NoVisualization, kRun,
       "ignore the <visualization> of the file"},
      {"--check", "", &SOptions::Check, kRun,
       "load the experiment with its libraries, views and outputs, report all errors and warnings, "
       "and do not run it; no file is changed, not even by users' code",
       EUse::Simulation},
      {"--seed", "N", &STexts::Seed, kRun, "random seed, overrides the file; 0: from the clock",
       EUse::Simulation},
      {"--threads", "N", &STexts::Threads, kRun,
       "number of threads, overrides the file; at most 1024; results do not change",
       EUse::Simulation},
      {"--length", "S", &STexts::Length, kRun,
       "simulated seconds to run, overrides the file; 0: no limit", EUse::Simulation},
      {"--set", "XPATH=VALUE", &STexts::Overrides, kRun,
       "set an attribute of the file before it is used; may be repeated", EUse::Run,
       EWords::XPaths},
      {"--replay-commands", "FILE", &SOptions::CommandsFile, kRun,
       "repeat what viewers of the live view did in the run of this recording, with its seed",
       EUse::Simulation, EWords::Recording},
      {"--lenient", "", &SOptions::Lenient, kRun,
       "read malformed numbers as ARGoS 3 does, with a warning, instead of refusing them",
       EUse::Simulation},
      {"--no-crash-handler", "", &SOptions::NoCrashHandler, kRun,
       "do not report crashes: for a debugger, or handlers of the user's code"},
      {"--csv", "DIR", &SOptions::CSVFolder, kRun,
       "write the robots' poses and the metrics of each tick to DIR/robots.csv and "
       "DIR/metrics.csv",
       EUse::Run, EWords::Folder},
      {"--digest", "", &SOptions::Digest, kRun,
       "print a digest of the final state; equal runs, equal digests", EUse::Simulation},
  };
}

TOptions MakeOptions() {
  TOptions all;
  for (const TOptions& group :
       {MakeActionOptions(), MakeOutputOptions(), MakeReplayOptions(), MakeRunOptions()}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
}

}  // namespace

const std::vector<SCommandLineOption>& GetCommandLineOptions() {
  static const TOptions options = MakeOptions();
  return options;
}

const std::vector<SHelpSection>& GetHelpSections() {
  static const std::vector<SHelpSection> sections = {{"Examples", kExamples},
                                                     {"Words for --query", ListKinds() + kQuery},
                                                     {"Paths for --set", kPaths},
                                                     {"Environment", kEnvironment},
                                                     {"Exit status", kExitStatus}};
  return sections;
}

const std::vector<std::string>& GetUsageLines() {
  static const std::vector<std::string> lines = {
      "argos3 FILE [options]", "argos3 --replay FILE [-c FILE] [options]",
      "argos3 -q [WORD] | --schema FORMAT | --generate WORD  [-c FILE]", "argos3 -h | -v"};
  return lines;
}

}  // namespace argos
