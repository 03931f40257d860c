#include <argos3/program/catalogue/elements.h>

#include <utility>

namespace argos {

namespace {

EValueType TypeOf(const SRequestedAttribute& attribute) {
  static const std::map<std::string, EValueType> types = {
      {"", EValueType::Text},     {"1", EValueType::AnyNumber}, {"red", EValueType::Colour},
      {"1,1", EValueType::XY},    {"1,1,1", EValueType::XYZ},   {"false", EValueType::Boolean},
      {"0:1", EValueType::Range}, {"0,0,0", EValueType::ZYX}};
  const EValueType type = attribute.IsTyped ? types.at(attribute.Sample) : EValueType::Unknown;
  if (type != EValueType::AnyNumber || attribute.Expected.empty()) {
    return type;
  }
  if (attribute.Expected.rfind("an integer from 0", 0) == 0) {
    return EValueType::NaturalNumber;
  }
  return attribute.Expected.rfind("an integer", 0) == 0 ? EValueType::WholeNumber
                                                        : EValueType::RealNumber;
}

bool IsNumber(EValueType type) {
  return type >= EValueType::AnyNumber && type <= EValueType::NaturalNumber;
}

// a text and a number are a text
EValueType Merged(EValueType one, EValueType other) {
  if (one == EValueType::Unknown || (one == EValueType::AnyNumber && IsNumber(other))) {
    return other;
  }
  const bool isSame = one == other || other == EValueType::Unknown;
  return isSame || (IsNumber(one) && IsNumber(other)) ? one : EValueType::Text;
}

}  // namespace

TElementPath operator/(TElementPath path, const SElementName& name) {
  path.push_back(name);
  return path;
}

const char* NameOf(EValueType type) {
  static constexpr const char* kNames[] = {"text",    "text",    "real",    "real",
                                           "integer", "natural", "boolean", "colour",
                                           "x,y",     "x,y,z",   "z,y,x",   "min:max"};
  return kNames[static_cast<size_t>(type)];
}

SElement::SElement(const SRequestedElement& request)
    : IsVisited(request.IsVisited), HasText(request.HasText), IsOpen(request.IsOpen) {
  for (const auto& [name, attribute] : request.Attributes) {
    Attributes[name].Type = TypeOf(attribute);
  }
  for (const auto& [name, child] : request.Children) {
    Children.emplace(name, SElement(*child));
  }
}

const SElement* SElement::Find(const SElementName& name) const {
  const auto child = Children.find(name);
  return child == Children.end() ? nullptr : &child->second;
}

SElement* SElement::Find(const SElementName& name) {
  return const_cast<SElement*>(std::as_const(*this).Find(name));
}

const SElement* SElement::FindAt(const TElementPath& path) const {
  const SElement* found = this;
  for (auto name = path.begin(); found != nullptr && name != path.end(); ++name) {
    found = found->Find(*name);
  }
  return found;
}

TElementPath SElement::FindIn(const std::string& section, const SElementName& name) const {
  for (const auto& [tag, child] : Children) {
    TElementPath path = tag.Tag == section && child.Find(name) != nullptr
                            ? TElementPath{name}
                            : child.FindIn(section, name);
    if (!path.empty()) {
      path.insert(path.begin(), tag);
      return path;
    }
  }
  return {};
}

void SElement::Merge(const SElement& other) {
  for (const auto& [name, attribute] : other.Attributes) {
    SAttribute& own = Attributes[name];
    own.Type = Merged(own.Type, attribute.Type);
    own.Manual = own.Manual.Text.empty() ? attribute.Manual : own.Manual;
  }
  for (const auto& [name, child] : other.Children) {
    Children[name].Merge(child);
  }
  IsVisited = IsVisited || other.IsVisited;
  HasText = HasText || other.HasText;
  IsOpen = IsOpen || other.IsOpen;
}

}  // namespace argos
