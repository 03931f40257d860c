#include <argos3/core/utility/configuration/command_line_arg_parser.h>
#include <argos3/core/utility/text/lists.h>

#include <algorithm>

namespace argos {

// options

void CCommandLineArgParser::AddOption(const SOption& option) {
  for (const SOption& known : m_options) {
    if (known.Short == option.Short || known.Long == option.Long) {
      THROW_ARGOSEXCEPTION("The option -" << option.Short << ", --" << option.Long
                                          << " cannot be added: there is -" << known.Short << ", --"
                                          << known.Long << " already");
    }
  }
  m_options.push_back(option);
}

void CCommandLineArgParser::AddFlag(char shortOption, const std::string& longOption,
                                    const std::string& description, bool& flag) {
  AddOption(SOption{shortOption, longOption, description, false,
                    [&flag](const std::string&) { flag = true; }});
  flag = false;
}

std::vector<std::string> CCommandLineArgParser::OptionNames() const {
  std::vector<std::string> names;
  for (const SOption& option : m_options) {
    names.push_back("--" + option.Long);
  }
  return names;
}

const CCommandLineArgParser::SOption& CCommandLineArgParser::FindLong(
    const std::string& name) const {
  for (const SOption& option : m_options) {
    if (option.Long == name) {
      return option;
    }
  }
  THROW_ARGOSEXCEPTION("Unknown option \"--" << name << '"'
                                             << DidYouMean("--" + name, OptionNames()));
}

const CCommandLineArgParser::SOption& CCommandLineArgParser::FindShort(char name) const {
  std::vector<std::string> names;
  for (const SOption& option : m_options) {
    if (option.Short == name) {
      return option;
    }
    names.push_back(std::string("-") + option.Short);
  }
  const std::string known = JoinItems(names);
  THROW_ARGOSEXCEPTION("Unknown option \"-" << name << "\"; known: " << known);
}

void CCommandLineArgParser::ThrowBadValue(const std::string& option, const std::string& text,
                                          const std::string& expected) {
  THROW_ARGOSEXCEPTION("Option --" << option << ": found \"" << text << "\", expected "
                                   << expected);
}

void CCommandLineArgParser::PrintUsage(CARGoSLog& log) {
  std::size_t width = 0;
  for (const SOption& option : m_options) {
    width = std::max(width, option.Long.size() + (option.TakesValue ? 6U : 0U));
  }
  for (const SOption& option : m_options) {
    std::string name = option.Long + (option.TakesValue ? " VALUE" : "");
    name.resize(width, ' ');
    log << "   -" + std::string(1, option.Short) + "  --" + name + "   " + option.Description
        << std::endl;
  }
}

// parsing

void CCommandLineArgParser::Apply(const SOption& option, const std::string& word,
                                  const std::string* nextWord, bool& usedNext) {
  if (!option.TakesValue) {
    option.Set("");
    return;
  }
  if (nextWord == nullptr) {
    THROW_ARGOSEXCEPTION("Option " << word
                                   << ": its value is missing, expected it as the next word");
  }
  option.Set(*nextWord);
  usedNext = true;
}

void CCommandLineArgParser::ParseGroup(const std::string& word, const std::string* nextWord,
                                       bool& usedNext) const {
  for (std::size_t i = 1; i < word.size(); ++i) {
    const SOption& option = FindShort(word[i]);
    if (option.TakesValue && i + 1 < word.size()) {
      THROW_ARGOSEXCEPTION("Option -" << option.Short << " in \"" << word
                                      << "\" takes a value, so it must be the last of the group");
    }
    Apply(option, word, nextWord, usedNext);
  }
}

void CCommandLineArgParser::Parse(SInt32 argc, char** argv) {
  const std::vector<std::string> words(argv, argv + argc);
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string* nextWord = i + 1 < words.size() ? &words[i + 1] : nullptr;
    bool usedNext = false;
    if (words[i].rfind("--", 0) == 0) {
      Apply(FindLong(words[i].substr(2)), words[i], nextWord, usedNext);
    } else if (words[i].size() > 1 && words[i][0] == '-') {
      ParseGroup(words[i], nextWord, usedNext);
    } else {
      THROW_ARGOSEXCEPTION("The word \"" << words[i] << "\" belongs to no option"
                                         << DidYouMean("--" + words[i], OptionNames()));
    }
    i += usedNext ? 1 : 0;
  }
}

}  // namespace argos
