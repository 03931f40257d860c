#ifndef ARGOS3_PROGRAM_OPTION_TABLE_H
#define ARGOS3_PROGRAM_OPTION_TABLE_H

#include <argos3/program/argos_command_line_arg_parser.h>

#include <string>
#include <variant>
#include <vector>

namespace argos {

/** With which actions an option may be given. */
enum class EOptionUse {
  Always,
  Run, /**< needs an experiment or a replay */
  Simulation, /**< needs an experiment */
  Replay,
  Query /**< needs --query */
};

/** What completes the value of an option in a shell. */
enum class EOptionWords {
  Nothing,
  File,
  ExperimentFile,
  Recording,
  Folder,
  Plugins, /**< names of plug-ins and kinds of plug-ins */
  XPaths, /**< attributes of the experiment file */
  Listed /**< SCommandLineOption::Choices */
};

/** What the user has given for options whose values are checked further, or that are no values. */
struct SOptionTexts {
  bool Help = false, Version = false, Quiet = false;
  std::string Replay, Live, LiveSocket, LogLevel, Progress, Seed, Threads, Length, From, To, Every;
  std::vector<std::string> Overrides;
};

/** Where the value of an option goes: true for a flag, a text, or the texts of all occurrences. */
using TOptionTarget =
    std::variant<bool CARGoSCommandLineArgParser::SOptions::*,
                 std::string CARGoSCommandLineArgParser::SOptions::*, bool SOptionTexts::*,
                 std::string SOptionTexts::*, std::vector<std::string> SOptionTexts::*>;

/**
 * An option of argos3. The parser, --help, the man page and the completions of shells are made from
 * the table of these.
 */
struct SCommandLineOption {
  std::string Names; /**< "-c,--config-file" or "--seed" */
  /** "FILE"; "[WORD]" may be left out; empty: a flag, which may have a value only as in
   * "--live=8000" */
  std::string Value;
  TOptionTarget Target;
  std::string Group; /**< heading in the help */
  std::string Help;
  EOptionUse Use = EOptionUse::Always;
  EOptionWords Words = EOptionWords::Nothing;
  std::vector<std::string> Choices = {};

  bool IsRepeatable() const {
    return std::holds_alternative<std::vector<std::string> SOptionTexts::*>(Target);
  }
  bool IsValueOptional() const { return !Value.empty() && Value.front() == '['; }
  /** "--config-file". */
  std::string GetLongName() const;
  /** "-c"; empty if there is none. */
  std::string GetShortName() const;
};

/** All options, in the order of the help. */
const std::vector<SCommandLineOption>& GetCommandLineOptions();

/** A part of the help after the options. */
struct SHelpSection {
  std::string Heading;
  std::string Text; /**< lines, each ending with a line break */
};

/** Examples, words of --query, environment, exit status. */
const std::vector<SHelpSection>& GetHelpSections();

/** The ways to call the program: "argos3 FILE [options]", ... */
const std::vector<std::string>& GetUsageLines();

}  // namespace argos

#endif
