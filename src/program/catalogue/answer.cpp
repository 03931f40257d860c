#include <argos3/program/catalogue/answer.h>

#include <argos3/core/simulator/entity/actuator.h>
#include <argos3/core/simulator/entity/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/program/catalogue/interface_class.h>

#include <algorithm>
#include <cctype>
#include <memory>

namespace argos {

namespace {

constexpr size_t kMostSuggestions = 8;

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// words of "range_and_bearing (medium)"
std::vector<std::string> WordsOf(const std::string& label) {
  std::vector<std::string> words(1);
  for (const char c : label) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) {
    words.pop_back();
  }
  return words;
}

// "rab" of "range_and_bearing"
std::string InitialsOf(const std::string& tag) {
  std::string initials;
  for (const std::string& word : WordsOf(tag)) {
    initials += word.front();
  }
  return initials;
}

template <typename DEVICE>
bool HasInterface(const std::string& label, const std::string& name) {
  const std::unique_ptr<DEVICE> device(CFactory<DEVICE>::New(label));
  const DEVICE& object = *device;
  return FindInterfaceClass(typeid(object)).Name == name;
}

bool IsMeant(const SPluginKind& kind, const SPluginText& plugin, const std::string& query) {
  if (plugin.Label == query || TagOf(plugin.Label) == query) {
    return true;
  }
  if (query.rfind("CCI_", 0) != 0) {
    return false;
  }
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  return (kind.Word == "sensors" && HasInterface<CSimulatedSensor>(plugin.Label, query)) ||
         (kind.Word == "actuators" && HasInterface<CSimulatedActuator>(plugin.Label, query));
}

void AddOnce(std::vector<std::string>& list, const std::string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) {
    list.push_back(text);
  }
}

std::vector<std::string> Suggest(const std::string& query, const std::vector<SPluginKind>& kinds) {
  const std::string wanted = Lower(query);
  std::vector<std::string> names;
  std::vector<std::string> suggestions;
  std::vector<std::string> words;
  for (const SPluginKind& kind : kinds) {
    names.push_back(kind.Word);
    for (const SPluginText& plugin : kind.Plugins) {
      const std::string tag = TagOf(plugin.Label);
      AddOnce(names, tag);
      for (const std::string& word : WordsOf(tag)) {
        AddOnce(words, word);
      }
      if (InitialsOf(tag) == wanted) {
        AddOnce(suggestions, tag);
      }
    }
  }
  const auto addContaining = [&](const std::string& part) {
    for (const std::string& name : names) {
      if (Lower(name).find(part) != std::string::npos) {
        AddOnce(suggestions, name);
      }
    }
  };
  addContaining(wanted);
  for (const std::string& name : names) {
    if (!NearestNames(query, {name}).empty()) {
      AddOnce(suggestions, name);
    }
  }
  // a misspelt part of a name
  for (const std::string& word : WordsOf(NearestNames(query, words))) {
    addContaining(Lower(word));
  }
  if (suggestions.size() > kMostSuggestions) {
    suggestions.resize(kMostSuggestions);
  }
  return suggestions;
}

}  // namespace

std::string TagOf(const std::string& label) {
  return label.substr(0, label.find(" ("));
}

bool IsUnsaid(const std::string& text) {
  return text.find_first_not_of(" \n\t") == std::string::npos || text == "undefined" ||
         text == "UNDEFINED";
}

bool IsOwnAuthor(const std::string& author) {
  return author == "the authors of this project";
}

std::string LinkTargetOf(const std::string& library) {
  const std::string file = library.substr(library.rfind('/') + 1);
  const std::string prefix = "libargos3plugin_simulator_";
  if (file.rfind("libargos3core", 0) == 0) {
    return "ARGoS::core";
  }
  if (file.rfind(prefix, 0) != 0) {
    return "";
  }
  return "ARGoS::" + file.substr(prefix.size(), file.rfind('.') - prefix.size());
}

SAnswer FindAnswer(const std::string& query, const std::vector<SPluginKind>& kinds) {
  SAnswer answer;
  for (const SPluginKind& kind : kinds) {
    if (query == "all" || query == kind.Word ||
        (query == "outputs" && kind.Word == "visualizations")) {
      answer.Lists.push_back(&kind);
    }
  }
  if (!answer.Lists.empty()) {
    return answer;
  }
  std::vector<SMatch> containing;
  for (const SPluginKind& kind : kinds) {
    for (const SPluginText& plugin : kind.Plugins) {
      if (IsMeant(kind, plugin, query)) {
        answer.Matches.push_back({&kind, &plugin});
      } else if (plugin.Label.find(query) != std::string::npos) {
        containing.push_back({&kind, &plugin});
      }
    }
  }
  if (answer.Matches.empty()) {
    answer.Matches = containing;
  } else {
    for (const SMatch& match : containing) {
      AddOnce(answer.Others, TagOf(match.Plugin->Label));
    }
  }
  for (const SPluginKind& kind : kinds) {
    for (const SPluginText& plugin : kind.Plugins) {
      if (!answer.Matches.empty() && InitialsOf(TagOf(plugin.Label)) == Lower(query)) {
        AddOnce(answer.Others, TagOf(plugin.Label));
      }
    }
  }
  if (answer.Matches.empty()) {
    answer.Suggestions = Suggest(query, kinds);
  }
  return answer;
}

}  // namespace argos
