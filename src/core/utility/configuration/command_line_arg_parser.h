#ifndef ARGOS3_CORE_UTILITY_CONFIGURATION_COMMAND_LINE_ARG_PARSER_H
#define ARGOS3_CORE_UTILITY_CONFIGURATION_COMMAND_LINE_ARG_PARSER_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/configuration/configuration_parsing.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <functional>
#include <string>
#include <vector>

namespace argos {

/**
 * The options of a program: -x or --example. The value of an option is the word after it. Short
 * flags may be glued together (-ab); only the last of such a group may take a value.
 */
class CCommandLineArgParser {
 public:
  CCommandLineArgParser() = default;
  virtual ~CCommandLineArgParser() = default;

  /**
   * Adds an option without value.
   * @param longOption  without the dashes.
   * @param flag        set to false now and to true if the option is given; must outlive Parse().
   * @throws CARGoSException if there is such an option already.
   */
  void AddFlag(char shortOption, const std::string& longOption, const std::string& description,
               bool& flag);

  /**
   * Adds an option with a value, of any type that an attribute in an experiment file can have.
   * @param buffer  set if the option is given; must outlive Parse().
   * @throws CARGoSException if there is such an option already.
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

  /** Lists the options, one a line, in the order in which they were added. */
  virtual void PrintUsage(CARGoSLog& log);

  /**
   * @param argc, argv  what main() gets; the first word is the program.
   * @throws CARGoSException on an option that was not added (the text gives the nearest), a missing
   * value, a value that does not parse, or a word that belongs to no option.
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
