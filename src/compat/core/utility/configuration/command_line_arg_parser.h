#ifndef ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_COMMAND_LINE_ARG_PARSER_H
#define ARGOS3_COMPAT_CORE_UTILITY_CONFIGURATION_COMMAND_LINE_ARG_PARSER_H

#include <argos3/core/utility/configuration/configuration_parsing.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <functional>
#include <string>
#include <vector>

namespace argos {

/**
 * Parser of command-line options, -x or --example. The value of an option is the next word. Short
 * flags may be combined (-ab); only the last one of a group may take a value.
 */
class CCommandLineArgParser {
 public:
  CCommandLineArgParser() = default;
  virtual ~CCommandLineArgParser() = default;

  /**
   * Adds an option without a value.
   * @param longOption  without the dashes.
   * @param flag        set to false by this call and to true if the option is given; must outlive
   *   Parse().
   * @throws CARGoSException if the option already exists.
   */
  void AddFlag(char shortOption, const std::string& longOption, const std::string& description,
               bool& flag);

  /**
   * Adds an option with a value, of any type that an XML attribute can have.
   * @param buffer  set if the option is given; must outlive Parse().
   * @throws CARGoSException if the option already exists.
   */
  template <typename T>
  void AddArgument(char shortOption, const std::string& longOption, const std::string& description,
                   T& buffer) {
    AddOption(SOption{
        shortOption, longOption, description, true, [&buffer, longOption](const std::string& text) {
          std::string reason;
          if (!detail::ParseText(text.c_str(), buffer, reason)) {
            ThrowBadValue(longOption, text, detail::ExpectedText(static_cast<const T*>(nullptr)));
          }
        }});
  }

  /** Prints the options, one per line, in the order in which they were added. */
  virtual void PrintUsage(CARGoSLog& log);

  /**
   * @param argc, argv  the arguments of main(); the first word is the program name.
   * @throws CARGoSException on an unknown option (the text gives the nearest names), a missing
   *   value, a value that does not parse, or a word that belongs to no option.
   */
  virtual void Parse(SInt32 argc, char** argv);

 private:
  struct SOption {
    char Short;
    std::string Long;
    std::string Description;
    bool TakesValue;
    std::function<void(const std::string& value)> Set;
  };

  void AddOption(const SOption& option);
  const SOption& FindLong(const std::string& name) const;
  const SOption& FindShort(char name) const;
  void ParseGroup(const std::string& word, const std::string* nextWord, bool& usedNext) const;
  static void Apply(const SOption& option, const std::string& word, const std::string* nextWord,
                    bool& usedNext);
  [[noreturn]] static void ThrowBadValue(const std::string& option, const std::string& text,
                                         const std::string& expected);
  std::vector<std::string> OptionNames() const;

  std::vector<SOption> m_options;
};

}  // namespace argos

#endif
