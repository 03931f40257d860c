#include <argos3/program/argos_command_line_arg_parser.h>

#include <argos3/core/config.h>
#include <argos3/core/simulator/loading/run_settings.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/text_layout.h>
#include <argos3/program/catalogue/version_text.h>
#include <argos3/program/option_table.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <variant>

namespace argos {

namespace {

std::string Title() {
  return std::string("argos3, a simulator for swarms of robots, version ") + ARGOS_VERSION + "-" +
         ARGOS_RELEASE + "\nReleased under the MIT License.\n";
}

using SOptions = CARGoSCommandLineArgParser::SOptions;

// column of the texts of the options
constexpr size_t kHelpColumn = 32;

// the text of an option in lines, which CLI11 indents
std::string FoldHelp(const std::string& help) {
  std::istringstream lines(Wrapped(help, kHelpColumn));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    text += text.empty() ? "" : "\n";
    text += line.substr(kHelpColumn);
  }
  return text;
}

class CHelpFormatter : public CLI::Formatter {
 public:
  CHelpFormatter() { column_width(kHelpColumn); }
  std::string make_usage(const CLI::App*, std::string) const override {
    std::string usage;
    for (const std::string& line : GetUsageLines()) {
      usage += (usage.empty() ? "Usage: " : "       ") + line + '\n';
    }
    return usage;
  }
};

CLI::Option* AddOption(CLI::App& app, const SCommandLineOption& row, bool& value) {
  return app.add_flag(row.Names, value);
}

// reports an option that was given repeatedly
CLI::Option* AddOption(CLI::App& app, const SCommandLineOption& row, std::string& value) {
  if (row.Value.empty()) {
    // a word that follows is not its value: "true" without "=..."
    return app.add_flag(row.Names, value);
  }
  return app.add_option(row.Names, value)
      ->expected(row.IsValueOptional() ? 0 : 1, 1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->type_name(row.Value);
}

CLI::Option* AddOption(CLI::App& app, const SCommandLineOption& row,
                       std::vector<std::string>& values) {
  return app.add_option(row.Names, values)
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->type_name(row.Value);
}

/** Finds the object of a pointer to a member. */
struct STargets {
  SOptions& Options;
  SOptionTexts& Texts;

  template <typename T>
  T& Get(T SOptions::*member) const {
    return Options.*member;
  }
  template <typename T>
  T& Get(T SOptionTexts::*member) const {
    return Texts.*member;
  }
};

void Define(CLI::App& app, const STargets& targets) {
  app.set_help_flag();
  app.allow_extras();
  app.formatter(std::make_shared<CHelpFormatter>());
  std::string footer;
  for (const SHelpSection& section : GetHelpSections()) {
    footer += '\n' + section.Heading + ":\n" + section.Text;
  }
  app.footer(footer);
  for (const SCommandLineOption& row : GetCommandLineOptions()) {
    CLI::Option* const option = std::visit(
        [&](auto member) { return AddOption(app, row, targets.Get(member)); }, row.Target);
    option->description(FoldHelp(row.Help))->group(row.Group);
  }
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
  for (const SCommandLineOption& row : GetCommandLineOptions()) {
    const std::string name = row.GetLongName();
    const bool takesOneValue = !row.Value.empty() && !row.IsRepeatable();
    if (takesOneValue && app.count(name) > 1) {
      problems.Add(name + " is given " + std::to_string(app.count(name)) + " times");
    }
  }
}

// long options with one dash: CLI11 would read their letters as short ones
void CheckDashes(const CLI::App& app, SInt32 argc, const char* const* argv, CProblems& problems) {
  const std::vector<std::string> names = OptionNames(app);
  for (SInt32 i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string name = '-' + word.substr(0, word.find('='));
    if (word.size() > 2 && word[0] == '-' && word[1] != '-' &&
        std::find(names.begin(), names.end(), name) != names.end()) {
      problems.Add("unknown option " + name.substr(1) + "; did you mean \"" + name + "\"?");
    }
  }
}

// "--length: 1 required S missing" of CLI11
std::string DescribeParseError(const CLI::ParseError& error) {
  std::string text = error.what();
  const std::string missing = " missing";
  const size_t required = text.find(": 1 required ");
  if (required != std::string::npos && text.size() > missing.size() &&
      text.compare(text.size() - missing.size(), missing.size(), missing) == 0) {
    text.resize(text.size() - missing.size());
    Replace(text, ": 1 required ", " needs a value: ");
  }
  return text;
}

// a word without an option is the experiment, if there is none
void ReadStrayWords(const CLI::App& app, std::string& experimentFile, CProblems& problems) {
  bool afterUnknownOption = false;
  bool isFileKnown = app.count("--config-file") > 0;
  for (const std::string& word : app.remaining()) {
    if (word.size() > 1 && word[0] == '-' && word != "--") {
      const std::string name = word.substr(0, word.find('='));
      problems.Add("unknown option " + name + DidYouMean(name, OptionNames(app)));
      afterUnknownOption = true;
      continue;
    }
    if (!afterUnknownOption && word != "--") {
      if (isFileKnown) {
        problems.Add('"' + word + "\" belongs to no option" +
                     (experimentFile.empty() ? "" : "; the experiment is " + experimentFile));
      } else {
        experimentFile = word;
        isFileKnown = true;
      }
    }
    // the word may have been the value of the unknown option
    afterUnknownOption = false;
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
  constexpr Real kMaxSpeed = 10000.0;
  std::optional<Real> speed;
  ReadNumber(app, "--speed", text, kMaxSpeed, "a number from 0.0001 to 10000", speed, problems);
  if (speed && *speed < 1.0 / kMaxSpeed) {
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
  time = ParseReplayTime(text);
  if (!time) {
    problems.Add(name + " " + text +
                 ": expected a tick, such as 100, or a time in seconds, such as 12.5s");
  }
}

void ReadLivePort(const CLI::App& app, const std::string& text, std::optional<UInt16>& port,
                  CProblems& problems) {
  if (app.count("--live") == 0) {
    return;
  }
  constexpr UInt16 kMaxPort = 65535;
  port = 0;
  if (text != "true") {
    ReadNumber(app, "--live", text, kMaxPort, "a port, from 0 to 65535, as in --live=8000", port,
               problems);
  }
}

void ReadLiveSocket(const CLI::App& app, const std::string& text, std::string& file,
                    CProblems& problems) {
  if (app.count("--live-socket") == 0) {
    return;
  }
  file = text == "true" ? "auto" : text;
  if (file.empty()) {
    problems.Add("--live-socket= needs the name of a file, as in --live-socket=run.url");
  }
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

CARGoSCommandLineArgParser::EAction ChooseAction(const CLI::App& app, bool hasExperiment,
                                                 CProblems& problems) {
  using EAction = CARGoSCommandLineArgParser::EAction;
  const std::pair<const char*, EAction> choices[] = {
      {"--config-file", EAction::ACTION_RUN_EXPERIMENT}, {"--replay", EAction::ACTION_REPLAY},
      {"--query", EAction::ACTION_QUERY_PLUGINS},        {"--schema", EAction::ACTION_MAKE_SCHEMA},
      {"--generate", EAction::ACTION_GENERATE},          {"--help", EAction::ACTION_SHOW_HELP},
      {"--version", EAction::ACTION_SHOW_VERSION}};
  EAction action = EAction::ACTION_UNKNOWN;
  std::string given;
  size_t count = 0;
  const bool hasOther =
      std::any_of(std::begin(choices) + 1, std::end(choices),
                  [&app](const auto& choice) { return app.count(choice.first) > 0; });
  for (const auto& [name, choice] : choices) {
    // with --replay, the experiment is the file of the views, with others that of the libraries or
    // words
    const bool isExperiment = choice == EAction::ACTION_RUN_EXPERIMENT;
    if (isExperiment ? hasExperiment && !hasOther : app.count(name) > 0) {
      action = choice;
      given += (count++ == 0 ? "" : ", ") + std::string(name);
    }
  }
  if (count == 0) {
    problems.Add(
        "one of FILE, --replay FILE, -q WORD, --schema FORMAT, --generate WORD, -h, -v must be "
        "given");
  } else if (count > 1) {
    problems.Add("only one of -c, --replay, -q, --schema, --generate, -h, -v may be given, not " +
                 given);
  }
  return action;
}

bool SameFile(const std::string& first, const std::string& second) {
  std::error_code ignored;
  return first == second || std::filesystem::equivalent(first, second, ignored);
}

void CheckFiles(const CLI::App& app, const SOptions& options, CProblems& problems) {
  const std::pair<const char*, const std::string*> files[] = {
      {"--config-file", &options.ExperimentFile},
      {"--replay", &options.Replay.File},
      {"--record", &options.RecordFile},
      {"--video", &options.VideoFile},
      {"--replay-commands", &options.CommandsFile},
      {"--html", &options.HTMLFile},
      {"--log-file", &options.LogFile},
      {"--logerr-file", &options.LogErrFile}};
  for (size_t i = 0; i < std::size(files); ++i) {
    if (app.count(files[i].first) == 0 && files[i].second->empty()) {
      continue;
    }
    if (files[i].second->empty()) {
      problems.Add(std::string(files[i].first) + " needs the name of a file, not an empty text");
      continue;
    }
    for (size_t j = 0; j < i; ++j) {
      if (!files[j].second->empty() && SameFile(*files[i].second, *files[j].second)) {
        problems.Add(std::string(files[j].first) + " and " + files[i].first +
                     " are the same file, " + *files[i].second);
      }
    }
  }
}

// both run the experiment
void CheckRunners(const CLI::App& app, CProblems& problems) {
  const char* const runners[] = {"--live", "--live-socket", "--replay-commands"};
  for (size_t i = 0; i < std::size(runners); ++i) {
    for (size_t j = i + 1; j < std::size(runners); ++j) {
      if (app.count(runners[i]) > 0 && app.count(runners[j]) > 0) {
        problems.Add(std::string("only one of ") + runners[i] + " and " + runners[j] +
                     " may be given");
      }
    }
  }
}

void CheckFolder(const CLI::App& app, const SOptions& options, CProblems& problems) {
  if (app.count("--csv") > 0 && options.CSVFolder.empty()) {
    problems.Add("--csv needs the name of a folder, not an empty text; . is the current one");
  }
}

// options that do not fit the action
void CheckUses(const CLI::App& app, CARGoSCommandLineArgParser::EAction action,
               CProblems& problems) {
  using TParser = CARGoSCommandLineArgParser;
  const bool isReplay = app.count("--replay") > 0;
  const bool isRun =
      isReplay || action == TParser::ACTION_RUN_EXPERIMENT || action == TParser::ACTION_UNKNOWN;
  for (const SCommandLineOption& row : GetCommandLineOptions()) {
    const std::string name = row.GetLongName();
    if (app.count(name) == 0 || row.Use == EOptionUse::Always) {
      continue;
    }
    if (row.Use == EOptionUse::Replay) {
      if (!isReplay) {
        problems.Add(name + " can only be used with --replay FILE");
      }
    } else if (row.Use == EOptionUse::Query) {
      if (app.count("--query") == 0) {
        problems.Add(name + " can only be used with -q");
      }
    } else if (!isRun) {
      problems.Add(name + " can only be used with an experiment, -c FILE");
    } else if (isReplay && row.Use == EOptionUse::Simulation) {
      problems.Add(name +
                   " cannot be used with --replay, which simulates nothing: it shows what was "
                   "recorded");
    }
  }
}

// values of options that allow only some
void CheckChoices(const CLI::App& app, CProblems& problems) {
  for (const SCommandLineOption& row : GetCommandLineOptions()) {
    const std::string name = row.GetLongName();
    if (row.Choices.empty() || app.count(name) == 0) {
      continue;
    }
    const std::string value = app[name]->as<std::string>();
    if (std::find(row.Choices.begin(), row.Choices.end(), value) == row.Choices.end()) {
      problems.Add(name + ' ' + value + ": unknown" + DidYouMean(value, row.Choices));
    }
  }
}

ELogLevel ReadLogLevel(const CLI::App& app, const SOptionTexts& raw, CProblems& problems) {
  if (raw.Quiet && app.count("--log-level") > 0) {
    problems.Add("only one of --quiet and --log-level may be given");
  }
  if (raw.LogLevel == "error") {
    return ELogLevel::Error;
  }
  if (raw.Quiet || raw.LogLevel == "warning") {
    return ELogLevel::Warning;
  }
  return raw.LogLevel == "debug" ? ELogLevel::Debug : ELogLevel::Info;
}

void CheckGenerate(const SOptions& options, CProblems& problems) {
  if (options.Generate == "xpaths" && options.ExperimentFile.empty()) {
    problems.Add("--generate xpaths needs an experiment, -c FILE");
  }
}

}  // namespace

void CARGoSCommandLineArgParser::Parse(SInt32 argc, const char* const* argv) {
  m_options = SOptions();
  SOptionTexts raw;
  CLI::App app(Title(), "argos3");
  Define(app, {m_options, raw});
  CProblems problems;
  CheckDashes(app, argc, argv, problems);
  problems.ThrowIfAny();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    problems.Add(DescribeParseError(error));
    problems.ThrowIfAny();
  }

  CheckRepetitions(app, problems);
  ReadStrayWords(app, m_options.ExperimentFile, problems);
  m_options.Action = ChooseAction(app, !m_options.ExperimentFile.empty(), problems);
  if (app.count("--query") > 0 && m_options.Query.empty()) {
    m_options.Query = "all";
  }
  CheckChoices(app, problems);
  m_options.LogLevel = ReadLogLevel(app, raw, problems);
  CheckGenerate(m_options, problems);
  constexpr Real kMaxPeriod = 1e9;  // s
  ReadNumber(app, "--progress", raw.Progress, kMaxPeriod, "a number of seconds, at least 0",
             m_options.ProgressPeriod, problems);
  ReadNumber(app, "--seed", raw.Seed, ~UInt32(0), "an integer from 0 to 4294967295", m_options.Seed,
             problems);
  ReadNumber(app, "--threads", raw.Threads, SRunSettings::kMaxThreads, "an integer from 0 to 1024",
             m_options.Threads, problems);
  ReadNumber(app, "--length", raw.Length, 1e18, "a number of seconds, at least 0", m_options.Length,
             problems);
  ReadLivePort(app, raw.Live, m_options.LivePort, problems);
  ReadLiveSocket(app, raw.LiveSocket, m_options.LiveURLFile, problems);
  ReadOverrides(raw.Overrides, m_options.Overrides, problems);
  m_options.Replay.File = raw.Replay;
  CheckFiles(app, m_options, problems);
  CheckFolder(app, m_options, problems);
  CheckRunners(app, problems);
  CheckVideoSpeed(app, m_options.VideoSpeed, problems);
  ReadTime(app, "--from", raw.From, m_options.Replay.From, problems);
  ReadTime(app, "--to", raw.To, m_options.Replay.To, problems);
  ReadStep(app, raw.Every, m_options.Replay.Every, problems);
  m_options.Replay.ViewsFile = m_options.ExperimentFile;
  CheckUses(app, m_options.Action, problems);
  problems.ThrowIfAny();
}

std::string CARGoSCommandLineArgParser::GetUsage() {
  SOptions options;
  SOptionTexts raw;
  CLI::App app(Title(), "argos3");
  Define(app, {options, raw});
  std::string usage = app.help();
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
