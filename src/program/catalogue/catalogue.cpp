#include <argos3/program/catalogue/catalogue.h>

#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <regex>

namespace argos {

namespace {

constexpr size_t kMaxSuggestions = 8;

// words of "range_and_bearing (medium)"
std::vector<std::string> WordsOf(const std::string& label) {
  static const std::regex kWord("[A-Za-z0-9]+");
  return {std::sregex_token_iterator(label.begin(), label.end(), kWord),
          std::sregex_token_iterator()};
}

// "rab" of "range_and_bearing"
std::string InitialsOf(const std::string& tag) {
  std::string initials;
  for (const std::string& word : WordsOf(tag)) {
    initials += word.front();
  }
  return initials;
}

void AddOnce(std::vector<std::string>& list, const std::string& text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) {
    list.push_back(text);
  }
}

// elements, and attributes, in the order of the tree
void Search(const SElement& parent, const TElementPath& path, const std::string& query,
            std::vector<SElementMatch>& matches) {
  for (const auto& [name, element] : parent.Children) {
    const TElementPath inside = path / name;
    if (name.Tag == query && element.IsVisited) {
      matches.push_back({inside, &element, ""});
    }
    if (element.Attributes.count(query) > 0) {
      matches.push_back({inside, &element, query});
    }
    Search(element, inside, query, matches);
  }
}

void CollectNames(const SElement& element, std::set<std::string>& names) {
  for (const auto& [name, attribute] : element.Attributes) {
    names.insert(name);
  }
  for (const auto& [name, child] : element.Children) {
    names.insert(name.Tag);
    CollectNames(child, names);
  }
}

}  // namespace

CDevices& CCatalogue::GetDevices() {
  return m_devices ? *m_devices : m_devices.emplace(m_kinds);
}

const SElement& CCatalogue::GetElements() {
  if (!m_elements) {
    CGrammar grammar(GetDevices());
    grammar.RecordAll();
    m_elements = grammar.MakeRoot();
  }
  return *m_elements;
}

const SElement* CCatalogue::FindElement(const SMatch& match) {
  const std::string& section = match.Kind->Section;
  if (match.Kind->Word == "elements") {
    std::vector<SElementMatch> matches;
    Search(GetElements(), {}, match.Plugin->Label, matches);
    const auto element =
        std::ranges::find_if(matches, std::ranges::empty, &SElementMatch::Attribute);
    return element == matches.end() ? nullptr : element->Element;
  }
  if (section.empty()) {
    return nullptr;
  }
  const SElementName name = SElementName::FromLabel(match.Plugin->Label);
  // outputs are among the views
  TElementPath path =
      section == "visualization" ? GetElements().FindIn("outputs", name) : TElementPath();
  path = path.empty() ? GetElements().FindIn(section, name) : path;
  return path.empty() ? nullptr : GetElements().FindAt(path);
}

bool CCatalogue::IsMeant(const SMatch& match, const std::string& query) const {
  const std::string& label = match.Plugin->Label;
  return label == query || TagOf(label) == query ||
         (query.rfind("CCI_", 0) == 0 && match.Kind->IsOfDevices() &&
          FindInterface(*match.Kind, label).Name == query);
}

SAnswer CCatalogue::Find(const std::string& query) {
  SAnswer answer;
  for (const SPluginKind& kind : m_kinds) {
    if (query == "all" || query == kind.Word ||
        (query == "outputs" && kind.Word == "visualizations")) {
      answer.Lists.push_back(&kind);
    }
  }
  if (!answer.Lists.empty()) {
    return answer;
  }
  std::vector<SMatch> containing;
  std::vector<std::string> withInitials;
  for (const SMatch& match : AllOf(m_kinds)) {
    const std::string& label = match.Plugin->Label;
    if (IsMeant(match, query)) {
      answer.Matches.push_back(match);
    } else if (label.find(query) != std::string::npos) {
      containing.push_back(match);
    }
    if (InitialsOf(TagOf(label)) == StringToLowerCase(query)) {
      withInitials.push_back(TagOf(label));
    }
  }
  if (answer.Matches.empty()) {
    answer.Matches = std::move(containing);
    Search(GetElements(), {}, query, answer.Elements);
  } else {
    for (const SMatch& match : containing) {
      AddOnce(answer.Others, TagOf(match.Plugin->Label));
    }
  }
  if (!answer.IsFound()) {
    answer.Suggestions = Suggest(query);
    return answer;
  }
  for (const std::string& tag : withInitials) {
    AddOnce(answer.Others, tag);
  }
  return answer;
}

std::vector<std::string> CCatalogue::Suggest(const std::string& query) {
  std::vector<std::string> names;
  std::vector<std::string> suggestions;
  std::vector<std::string> words;
  for (const SPluginKind& kind : m_kinds) {
    names.push_back(kind.Word);
    for (const SPluginText& plugin : kind.Plugins) {
      const std::string tag = TagOf(plugin.Label);
      AddOnce(names, tag);
      for (const std::string& word : WordsOf(tag)) {
        AddOnce(words, word);
      }
      if (InitialsOf(tag) == StringToLowerCase(query)) {
        AddOnce(suggestions, tag);
      }
    }
  }
  // a part of a name may be misspelt
  std::vector<std::string> parts = WordsOf(NearestNames(query, words));
  parts.insert(parts.begin(), query);
  for (const std::string& part : parts) {
    for (const std::string& name : names) {
      if (StringToLowerCase(name).find(StringToLowerCase(part)) != std::string::npos ||
          (part == query && !NearestNames(query, {name}).empty())) {
        AddOnce(suggestions, name);
      }
    }
  }
  if (suggestions.empty()) {
    std::set<std::string> inFiles;
    CollectNames(GetElements(), inFiles);
    Tokenize(NearestNames(query, {inFiles.begin(), inFiles.end()}), suggestions, ", ");
  }
  suggestions.resize(std::min(suggestions.size(), kMaxSuggestions));
  return suggestions;
}

}  // namespace argos
