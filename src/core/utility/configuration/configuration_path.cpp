#include <argos3/core/utility/configuration/configuration_path.h>

#include <argos3/core/utility/configuration/configuration_error.h>
#include <argos3/core/utility/configuration/configuration_store.h>
#include <argos3/core/utility/text/lists.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace argos {

// parsing a path

void CConfigurationPath::ThrowMalformed(const std::string& why) const {
  THROW_CONFIGURATION_ERROR("\"" << m_path << "\" is not a path to an attribute: " << why
                                 << "; expected a form like framework/experiment/@length or "
                                    "//foot-bot[@id='fb0']/body/@position");
}

CConfigurationPath::CConfigurationPath(const std::string& path) : m_path(path) {
  bool anyDepth = false;
  std::size_t position = 0;
  while (position < path.size()) {
    if (path[position] == '/') {
      const bool isDouble = position + 1 < path.size() && path[position + 1] == '/';
      anyDepth = isDouble;
      position += isDouble ? 2 : 1;
    }
    // a step ends at the next slash outside of a predicate
    std::size_t end = position;
    int depth = 0;
    while (end < path.size() && (path[end] != '/' || depth > 0)) {
      depth += path[end] == '[' ? 1 : 0;
      depth -= path[end] == ']' ? 1 : 0;
      ++end;
    }
    const std::string step = path.substr(position, end - position);
    if (step.empty()) {
      ThrowMalformed("a step between two slashes or after the last one is empty");
    }
    if (!m_attribute.empty()) {
      ThrowMalformed("\"@" + m_attribute + "\" is not at the end");
    }
    if (step[0] == '@') {
      m_attribute = step.substr(1);
      CheckXmlName(m_attribute);
      if (anyDepth) {
        ThrowMalformed("\"//\" precedes the attribute");
      }
    } else {
      ParseStep(step, anyDepth);
    }
    anyDepth = false;
    position = end;
  }
  if (m_attribute.empty()) {
    ThrowMalformed("it does not end with \"@\" and the name of an attribute");
  }
}

void CConfigurationPath::ParseStep(const std::string& text, bool anyDepth) {
  SStep step;
  step.Text = text;
  step.AnyDepth = anyDepth;
  std::size_t position = text.find('[');
  step.Tag = text.substr(0, position);
  if (step.Tag.empty()) {
    ThrowMalformed("the step \"" + text + "\" names no element");
  }
  if (step.Tag != "*") {
    CheckXmlName(step.Tag);
  }
  while (position < text.size()) {
    const std::size_t end = text.find(']', position);
    if (text[position] != '[' || end == std::string::npos) {
      ThrowMalformed("the brackets of the step \"" + text + "\" do not match");
    }
    step.Predicates.push_back(ParsePredicate(text.substr(position + 1, end - position - 1)));
    position = end + 1;
  }
  m_steps.push_back(step);
}

CConfigurationPath::SPredicate CConfigurationPath::ParsePredicate(const std::string& text) const {
  SPredicate predicate;
  if (ParseNumber(text, predicate.Position) == ENumberParsing::Ok && predicate.Position > 0) {
    return predicate;
  }
  const std::size_t equals = text.find('=');
  // the shortest form is @a=''
  if (text.size() >= 5 && text[0] == '@' && equals != std::string::npos &&
      equals + 2 < text.size() && (text[equals + 1] == '\'' || text[equals + 1] == '"') &&
      text.back() == text[equals + 1]) {
    predicate.Position = 0;
    predicate.Attribute = text.substr(1, equals - 1);
    predicate.Value = text.substr(equals + 2, text.size() - equals - 3);
    return predicate;
  }
  ThrowMalformed("[" + text + "] is neither a number from 1 up nor a condition [@name='value']");
}

// matching elements

CConfigurationPath::TElements CConfigurationPath::Filter(const TElements& siblings,
                                                         const SStep& step) {
  TElements kept;
  for (tinyxml2::XMLElement* element : siblings) {
    if (step.Tag == "*" || step.Tag == element->Value()) {
      kept.push_back(element);
    }
  }
  for (const SPredicate& predicate : step.Predicates) {
    TElements before;
    before.swap(kept);
    if (predicate.Position > 0) {
      if (predicate.Position <= before.size()) {
        kept.push_back(before[predicate.Position - 1]);
      }
      continue;
    }
    std::copy_if(before.begin(), before.end(), std::back_inserter(kept),
                 [&predicate](tinyxml2::XMLElement* element) {
                   const char* value = element->Attribute(predicate.Attribute.c_str());
                   return value != nullptr && predicate.Value == value;
                 });
  }
  return kept;
}

void CConfigurationPath::CollectMatches(tinyxml2::XMLElement& parent, const SStep& step,
                                        TElements& matches) {
  TElements children;
  for (auto* child = parent.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    children.push_back(child);
  }
  // a subset of the children, in their order
  const TElements found = Filter(children, step);
  auto next = found.begin();
  for (tinyxml2::XMLElement* child : children) {
    if (next != found.end() && *next == child) {
      matches.push_back(child);
      ++next;
    }
    if (step.AnyDepth) {
      CollectMatches(*child, step, matches);
    }
  }
}

CConfigurationPath::TElements CConfigurationPath::Walk(const TElements& start,
                                                       std::size_t firstStep) const {
  TElements current = start;
  for (std::size_t i = firstStep; i < m_steps.size(); ++i) {
    TElements next;
    if (i == 0 && m_steps[i].AnyDepth) {
      next = Filter(current, m_steps[i]);
    }
    for (tinyxml2::XMLElement* element : current) {
      CollectMatches(*element, m_steps[i], next);
    }
    // if a path has two "//", an element can be found several times
    std::set<tinyxml2::XMLElement*> seen;
    next.erase(std::remove_if(next.begin(), next.end(),
                              [&seen](auto* match) { return !seen.insert(match).second; }),
               next.end());
    if (next.empty()) {
      ThrowNothingFound(m_steps[i], current);
    }
    current.swap(next);
  }
  return current;
}

CConfigurationPath::TElements CConfigurationPath::Find(tinyxml2::XMLElement& root) const {
  // the first step may be the root itself
  const TElements start = {&root};
  const bool startsAtRoot = !m_steps.empty() && !Filter(start, m_steps[0]).empty() &&
                            (m_steps[0].Tag != "*" || m_path[0] == '/');
  TElements found = Walk(start, startsAtRoot && !m_steps[0].AnyDepth ? 1 : 0);
  const bool mayMatchSeveral = std::ranges::any_of(m_steps, &SStep::AnyDepth);
  if (found.size() > 1 && !mayMatchSeveral) {
    std::string lines;
    for (const tinyxml2::XMLElement* element : found) {
      AppendItem(lines, std::to_string(element->GetLineNum()));
    }
    THROW_CONFIGURATION_ERROR("\"" << m_path << "\" matches " << found.size()
                                   << " elements, in lines " << lines << ": select one, as in \""
                                   << m_steps.back().Text
                                   << "[1]\" or with [@id='...'], or begin with \"//\" for all");
  }
  return found;
}

void CConfigurationPath::ThrowNothingFound(const SStep& step, const TElements& parents) const {
  std::vector<std::string> known;
  std::size_t sameTag = 0;
  const auto addTags = [&known, &sameTag, &step](const tinyxml2::XMLElement& parent,
                                                 const auto& addTagsBelow) -> void {
    for (const auto* child = parent.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      sameTag += step.Tag == child->Value() ? 1 : 0;
      if (std::find(known.begin(), known.end(), child->Value()) == known.end()) {
        known.emplace_back(child->Value());
      }
      if (step.AnyDepth) {
        addTagsBelow(*child, addTagsBelow);
      }
    }
  };
  for (const tinyxml2::XMLElement* parent : parents) {
    addTags(*parent, addTags);
  }
  THROW_CONFIGURATION_ERROR(
      "\"" << m_path << "\": nothing matches the step \"" << step.Text << "\" inside <"
           << parents.front()->Value() << "> (line " << parents.front()->GetLineNum() << ")"
           << (sameTag > 0 ? "; elements <" + step.Tag + "> there: " + std::to_string(sameTag)
                           : DidYouMean(step.Tag, known)));
}

}  // namespace argos
