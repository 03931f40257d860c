#include "mutators.h"

#include "xml_tree.h"

#include <algorithm>
#include <iterator>
#include <random>

namespace argos {

namespace {

/* Draws; the distributions of the standard library differ between platforms, its engines do not. */
class CDice {
 public:
  explicit CDice(std::uint64_t seed) : m_engine(seed) {}

  std::size_t Below(std::size_t bound) { return bound == 0 ? 0 : m_engine() % bound; }
  template <typename LIST>
  const auto& From(const LIST& list) {
    return list[Below(std::size(list))];
  }

 private:
  std::mt19937_64 m_engine;
};

const char* const kValues[] = {
    // empty and blank
    "", " ", ",", ",,", ":", ".", "-",
    // large, small, negative
    "1e308", "-1e308", "1e39", "1e20", "1e13", "1e9", "100000", "1e-300", "1e-12", "-1e-12", "0",
    "-0", "-1", "-0.5", "1e6", "-1e6", "65536", "4294967295", "4294967296", "-2147483649",
    "18446744073709551615", "18446744073709551616", "1e400",
    // not numbers
    "nan", "-nan", "inf", "-inf", "text", "0x10", "1e", "1.2.3", "12abc", "true", "false", "True",
    "%s%n", "$HOME", "\\0", "&lt;&gt;", "&#65;",
    // wrong counts, and ranges
    "1,2", "1,2,3", "1,2,3,4", "1;2;3", "0,0,0", "-1,-1,-1", "1e30,1,1", "1e-300,1,1", "nan,0,0",
    "inf,0,0", "5:-5", "0:0", "1:", ":1", "1e308:1e309", "-1e300:1e300", "1000000,1000000,1000000",
    "3x", "1x1x1", "100000x100000",
    // other alphabets
    "\xc3\xbc", "\xe2\x88\x82\xe6\xbc\xa2", "\xf0\x9f\xa4\x96", "\xff\xfe", "\x01"};

// a value of any kind; some are made from the old one
std::string DrawValue(CDice& dice, const std::string& old) {
  switch (dice.Below(8)) {
    case 0:
      return old + old;
    case 1:
      return "-" + old;
    case 2:
      return old + "e30";
    case 3: {
      // one field of a list
      std::string value = old;
      const std::size_t comma = value.find(',');
      const std::string field = dice.From(kValues);
      return comma == std::string::npos ? field : field + value.substr(comma);
    }
    case 4:
      return dice.Below(4) == 0 ? std::string(100000, 'x') : old.substr(0, old.size() / 2);
    default:
      return dice.From(kValues);
  }
}

std::string Misspell(CDice& dice, std::string name) {
  const std::size_t at = dice.Below(name.size());
  if (dice.Below(2) == 0 && name.size() > 1) {
    name.erase(std::max<std::size_t>(at, 1), 1);
  } else {
    name.insert(at, 1, 'x');
  }
  return name;
}

std::string MutateAttribute(CDice& dice, SXmlElement& root) {
  std::vector<SXmlElement*> owners;
  for (const SXmlPlace& place : ListElements(root)) {
    // once for each attribute, so that all are equally likely
    owners.insert(owners.end(), place.Element->Attributes.size(), place.Element);
  }
  if (owners.empty()) {
    return "no attribute left";
  }
  SXmlElement& element = *dice.From(owners);
  const std::size_t number = dice.Below(element.Attributes.size());
  auto& [name, value] = element.Attributes[number];
  const std::string where = "<" + element.Tag + "> " + name;
  switch (dice.Below(12)) {
    case 0:
      element.Attributes.erase(element.Attributes.begin() + static_cast<std::ptrdiff_t>(number));
      return where + " removed";
    case 1:
      name = Misspell(dice, name);
      return where + " renamed to " + name;
    case 2:
      dice.From(owners)->Attributes.emplace_back(name, value);
      return where + " repeated elsewhere";
    default:
      value = DrawValue(dice, value);
      return where + "=\"" + value.substr(0, 80) + '"';
  }
}

std::unique_ptr<SXmlElement> TakeOut(const SXmlPlace& place) {
  std::unique_ptr<SXmlElement> taken = std::move((*place.Siblings)[place.Number]);
  place.Siblings->erase(place.Siblings->begin() + static_cast<std::ptrdiff_t>(place.Number));
  return taken;
}

std::string MutateElement(CDice& dice, SXmlElement& root) {
  const std::vector<SXmlPlace> places = ListElements(root);
  if (places.size() < 2) {
    return "no element left";
  }
  const SXmlPlace place = places[1 + dice.Below(places.size() - 1)];
  const std::string where = "<" + place.Element->Tag + ">";
  switch (dice.Below(9)) {
    case 0:
      TakeOut(place);
      return where + " removed";
    case 1:
      place.Siblings->push_back(place.Element->Clone());
      return where + " duplicated";
    case 2:
      place.Element->Tag = Misspell(dice, place.Element->Tag);
      return where + " renamed to " + place.Element->Tag;
    case 3: {
      std::unique_ptr<SXmlElement> copy = place.Element->Clone();
      SXmlElement& parent = *dice.From(places).Element;
      parent.Children.push_back(std::move(copy));
      return where + " copied into <" + parent.Tag + ">";
    }
    case 4: {
      std::unique_ptr<SXmlElement> moved = TakeOut(place);
      const std::vector<SXmlPlace> others = ListElements(root);
      SXmlElement& parent = *dice.From(others).Element;
      parent.Children.push_back(std::move(moved));
      return where + " moved into <" + parent.Tag + ">";
    }
    case 5: {
      std::unique_ptr<SXmlElement> outer = place.Element->Clone();
      outer->Children.clear();
      outer->Children.push_back(std::move((*place.Siblings)[place.Number]));
      (*place.Siblings)[place.Number] = std::move(outer);
      return where + " nested in itself";
    }
    case 6:
      place.Element->Children.clear();
      return where + " emptied";
    case 7:
      place.Element->Text = dice.Below(2) == 0 ? "velocity=\"40\"" : dice.From(kValues);
      return where + " with text";
    default: {
      SXmlElement& other = *dice.From(places).Element;
      std::swap(place.Element->Tag, other.Tag);
      return where + " swapped its name with <" + place.Element->Tag + ">";
    }
  }
}

std::string MutateBytes(CDice& dice, std::string& text) {
  if (text.empty()) {
    return "nothing left";
  }
  const std::size_t at = dice.Below(text.size());
  const std::size_t length = std::min(1 + dice.Below(100), text.size() - at);
  switch (dice.Below(5)) {
    case 0:
      text.resize(at);
      return "truncated to " + std::to_string(at) + " bytes";
    case 1:
      text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << dice.Below(8)));
      return "a bit flipped at " + std::to_string(at);
    case 2:
      text.erase(at, length);
      return std::to_string(length) + " bytes removed at " + std::to_string(at);
    case 3:
      for (std::size_t i = 0; i < length; ++i) {
        text.insert(at, 1, static_cast<char>(dice.Below(256)));
      }
      return std::to_string(length) + " bytes inserted at " + std::to_string(at);
    default:
      text.insert(at, text.substr(at, length));
      return std::to_string(length) + " bytes repeated at " + std::to_string(at);
  }
}

}  // namespace

std::string Mutate(const std::string& xml, EMutation mutation, std::uint64_t seed,
                   std::string& description) {
  CDice dice(seed);
  description.clear();
  const std::size_t changes = 1 + dice.Below(3);
  const auto note = [&description](const std::string& change) {
    description += (description.empty() ? "" : "; ") + change;
  };
  if (mutation == EMutation::File) {
    std::string text = xml;
    for (std::size_t i = 0; i < changes; ++i) {
      note(MutateBytes(dice, text));
    }
    return text;
  }
  const std::unique_ptr<SXmlElement> root = ParseXml(xml);
  for (std::size_t i = 0; i < changes; ++i) {
    note(mutation == EMutation::Attribute ? MutateAttribute(dice, *root)
                                          : MutateElement(dice, *root));
  }
  return ToText(*root);
}

}  // namespace argos
