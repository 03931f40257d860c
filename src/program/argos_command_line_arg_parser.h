#ifndef ARGOS3_PROGRAM_ARGOS_COMMAND_LINE_ARG_PARSER_H
#define ARGOS3_PROGRAM_ARGOS_COMMAND_LINE_ARG_PARSER_H

#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/** Parser of the command line of the program argos3. */
class CARGoSCommandLineArgParser {
 public:
  enum EAction {
    ACTION_UNKNOWN = 0,
    ACTION_RUN_EXPERIMENT,
    ACTION_REPLAY,
    ACTION_QUERY_PLUGINS,
    ACTION_MAKE_SCHEMA,
    ACTION_GENERATE,
    ACTION_SHOW_HELP,
    ACTION_SHOW_VERSION
  };

  struct SOptions {
    EAction Action = ACTION_UNKNOWN;
    /** Of ACTION_RUN_EXPERIMENT; of queries and schemas, its libraries are loaded. */
    std::string ExperimentFile;
    SReplayRequest Replay; /**< belongs to ACTION_REPLAY */
    std::optional<UInt16> LivePort; /**< show the run in a browser; 0: at a free port */
    std::string LiveURLFile; /**< let viewers come and go; "auto": any file; empty: no */
    std::string RecordFile; /**< empty: the run is not recorded */
    std::string VideoFile; /**< empty: no film besides those of the file */
    std::string VideoSpeed; /**< a positive number; empty: that of the file */
    std::string CommandsFile; /**< recording whose commands are repeated; empty: none */
    std::string HTMLFile; /**< into which a recording is exported; empty: none */
    std::string Query; /**< belongs to ACTION_QUERY_PLUGINS */
    bool Json = false; /**< ACTION_QUERY_PLUGINS answers as JSON */
    std::string SchemaFormat; /**< ACTION_MAKE_SCHEMA makes "rng" or "rnc" */
    std::string Generate; /**< belongs to ACTION_GENERATE */
    bool NoColor = false;
    bool NoVisualization = false;
    bool Digest = false;
    bool Lenient = false;
    bool NoCrashHandler = false;
    bool Check = false; /**< load the experiment, and do not run it */
    ELogLevel LogLevel = ELogLevel::Info;
    std::optional<Real> ProgressPeriod; /**< s, of lines in the log; 0: none */
    std::string LogFile; /**< empty: the standard output */
    std::string LogErrFile; /**< empty: the standard error */
    std::string CSVFolder; /**< empty: no tables besides those of the file */
    std::optional<UInt32> Seed;
    std::optional<UInt32> Threads;
    std::optional<Real> Length; /**< s, >= 0; 0 = unlimited */
    std::vector<std::pair<std::string, std::string>> Overrides; /**< XPath and value, in order */
  };

  /**
   * Parses the arguments of main(); the first one is the name of the program.
   * @throws CARGoSException that lists all problems, with the nearest known names.
   */
  void Parse(SInt32 argc, const char* const* argv);

  const SOptions& GetOptions() const { return m_options; }
  EAction GetAction() const { return m_options.Action; }
  const std::string& GetExperimentConfigFile() const { return m_options.ExperimentFile; }

  /** The text of `argos3 --help`. */
  static std::string GetUsage();
  void PrintUsage(CARGoSLog& log) const;
  /** The text of `argos3 --version`: lines of the form KEY=value. */
  static std::string GetVersion();

 private:
  SOptions m_options;
};

}  // namespace argos

#endif
