#include <argos3/campaign/design/element_reading.h>

#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/names.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace argos {

namespace {

const std::vector<std::pair<std::string, Real>>& ListSizeUnits() {
  static const std::vector<std::pair<std::string, Real>> kUnits = {
      {"", 1.0},
      {"B", 1.0},
      {"kB", 1e3},
      {"MB", 1e6},
      {"GB", 1e9},
      {"TB", 1e12},
      {"KiB", 1024.0},
      {"MiB", 1024.0 * 1024.0},
      {"GiB", 1024.0 * 1024.0 * 1024.0},
      {"TiB", 1024.0 * 1024.0 * 1024.0 * 1024.0}};
  return kUnits;
}

// -1 if the text is no size
Real ParseSize(const std::string& text) {
  const size_t end = text.find_last_of("0123456789.");
  if (end == std::string::npos) {
    return -1.0;
  }
  Real number = 0.0;
  if (ParseNumber(text.substr(0, end + 1), number) != ENumberParsing::Ok) {
    return -1.0;
  }
  const std::string unit = TrimBlanks(text.substr(end + 1));
  for (const auto& [name, factor] : ListSizeUnits()) {
    if (name == unit) {
      return number * factor;
    }
  }
  return -1.0;
}

}  // namespace

void ThrowAt(const TConfigurationNode& node, const std::string& message) {
  THROW_ARGOSEXCEPTION(node.GetLocation() << ": <" << node.Value() << ">: " << message);
}

void ReadElement(CLoadErrors& errors, TConfigurationNode& node,
                 const std::function<void(TConfigurationNode&)>& read) {
  if (!errors.Try("", [&] { read(node); })) {
    MarkSubtreeRead(node);
  }
}

static const TChildReaders::mapped_type& FindReader(const TConfigurationNode& element,
                                                    const std::string& parent,
                                                    const TChildReaders& readers) {
  const auto reader = readers.find(element.Value());
  if (reader == readers.end()) {
    std::vector<std::string> known;
    for (const auto& [name, function] : readers) {
      known.push_back(name);
    }
    ThrowAt(element,
            "there is no such element in <" + parent + ">" + DidYouMean(element.Value(), known));
  }
  return reader->second;
}

void ReadChildren(CLoadErrors& errors, TConfigurationNode& node, const TChildReaders& readers,
                  const std::vector<std::string>& single) {
  std::map<std::string, std::string> first;
  TConfigurationNodeIterator child;
  for (child = child.begin(&node); child != child.end(); ++child) {
    ReadElement(errors, *child, [&](TConfigurationNode& element) {
      const std::string tag = element.Value();
      const TChildReaders::mapped_type& read = FindReader(element, node.Value(), readers);
      const auto [other, isFirst] = first.emplace(tag, element.GetLocation());
      if (!isFirst && std::find(single.begin(), single.end(), tag) != single.end()) {
        ThrowAt(element, "it is given twice, first at " + other->second);
      }
      read(element);
    });
  }
}

std::string ReadText(TConfigurationNode& node, const std::string& attribute) {
  std::string text;
  GetNodeAttribute(node, attribute, text);
  text = TrimBlanks(text);
  if (text.empty()) {
    ThrowAt(node, "attribute \"" + attribute + "\" is empty");
  }
  return text;
}

std::string ReadOptionalText(TConfigurationNode& node, const std::string& attribute) {
  return NodeAttributeExists(node, attribute) ? ReadText(node, attribute) : std::string();
}

std::string ReadName(TConfigurationNode& node, const std::string& attribute) {
  std::string name = ReadText(node, attribute);
  if (!IsName(name)) {
    ThrowAt(node, "attribute \"" + attribute + "\": \"" + name +
                      "\" is not a name: expected letters, digits and '_', beginning with a "
                      "letter");
  }
  return name;
}

size_t ReadChoice(TConfigurationNode& node, const std::string& attribute,
                  const std::vector<std::string>& choices) {
  if (!NodeAttributeExists(node, attribute)) {
    return 0;
  }
  const std::string text = ReadText(node, attribute);
  const auto found = std::find(choices.begin(), choices.end(), text);
  if (found == choices.end()) {
    std::string known;
    for (const std::string& choice : choices) {
      AppendQuoted(known, choice);
    }
    const std::string nearest = NearestNames(text, choices, 1);
    ThrowAt(node, "attribute \"" + attribute + "\": expected one of " + known + ", found \"" +
                      text + '"' + (nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
  }
  return found - choices.begin();
}

UInt32 ReadCount(TConfigurationNode& node, const std::string& attribute, UInt32 min, UInt32 dflt) {
  UInt32 count = dflt;
  GetNodeAttributeOrDefault(node, attribute, count, dflt);
  if (count < min) {
    ThrowAt(node, "attribute \"" + attribute + "\": expected a whole number of at least " +
                      std::to_string(min) + ", found " + std::to_string(count));
  }
  return count;
}

UInt64 ReadSize(TConfigurationNode& node, const std::string& attribute, UInt64 dflt) {
  if (!NodeAttributeExists(node, attribute)) {
    return dflt;
  }
  constexpr Real kMax = 1e18;
  const std::string text = ReadText(node, attribute);
  const Real size = std::floor(ParseSize(text));
  if (!(size >= 1.0) || size > kMax) {
    ThrowAt(node, "attribute \"" + attribute +
                      "\": expected a size, such as \"2 GiB\", \"500 MB\" or \"1048576\" (bytes), "
                      "found \"" +
                      text + '"');
  }
  return static_cast<UInt64>(size);
}

std::string WithoutMark(const CARGoSException& error) {
  constexpr char kMark[] = "[FATAL] ";
  const std::string text = error.what();
  return text.rfind(kMark, 0) == 0 ? text.substr(sizeof(kMark) - 1) : text;
}

std::string TrimBlanks(const std::string& text) {
  constexpr const char* kBlanks = " \t\r\n";
  const size_t first = text.find_first_not_of(kBlanks);
  return first == std::string::npos
             ? std::string()
             : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace argos
