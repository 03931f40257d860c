#include <argos3/plugins/simulator/visualizations/live/run/command_arguments.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

namespace {

// null if it is absent
const TJson* Find(const TJson& arguments, const char* name) {
  const auto found = arguments.find(name);
  return found == arguments.end() || found->is_null() ? nullptr : &*found;
}

}  // namespace

std::string ReadTextArgument(const TJson& arguments, const char* name) {
  const TJson* const text = Find(arguments, name);
  if (text == nullptr || !text->is_string() || text->get_ref<const std::string&>().empty()) {
    THROW_ARGOSEXCEPTION('"' << name << "\" is missing, or no text");
  }
  return text->get<std::string>();
}

std::optional<Real> ReadNumberArgument(const TJson& arguments, const char* name, Real least,
                                       Real most) {
  const TJson* const number = Find(arguments, name);
  if (number == nullptr) {
    return std::nullopt;
  }
  if (!number->is_number() || !(number->get<Real>() >= least) || !(number->get<Real>() <= most)) {
    THROW_ARGOSEXCEPTION('"' << name << "\" is a number from " << least << " to " << most);
  }
  return number->get<Real>();
}

std::optional<UInt32> ReadCountArgument(const TJson& arguments, const char* name, UInt32 least,
                                        UInt32 most) {
  const TJson* const number = Find(arguments, name);
  if (number == nullptr) {
    return std::nullopt;
  }
  if (!number->is_number_unsigned() || number->get<UInt64>() < least ||
      number->get<UInt64>() > most) {
    THROW_ARGOSEXCEPTION('"' << name << "\" is a whole number from " << least << " to " << most);
  }
  return number->get<UInt32>();
}

std::optional<bool> ReadFlagArgument(const TJson& arguments, const char* name) {
  const TJson* const flag = Find(arguments, name);
  if (flag == nullptr) {
    return std::nullopt;
  }
  if (!flag->is_boolean()) {
    THROW_ARGOSEXCEPTION('"' << name << "\" is true or false");
  }
  return flag->get<bool>();
}

std::optional<CVector3> ReadVectorArgument(const TJson& arguments, const char* name, Real most) {
  const TJson* const vector = Find(arguments, name);
  if (vector == nullptr) {
    return std::nullopt;
  }
  bool isGood = vector->is_array() && vector->size() == 3;
  for (size_t i = 0; isGood && i < 3; ++i) {
    const TJson& number = (*vector)[i];
    isGood = number.is_number() && number.get<Real>() >= -most && number.get<Real>() <= most;
  }
  if (!isGood) {
    THROW_ARGOSEXCEPTION('"' << name << "\" is a list of three numbers from -" << most << " to "
                             << most);
  }
  return CVector3((*vector)[0].get<Real>(), (*vector)[1].get<Real>(), (*vector)[2].get<Real>());
}

}  // namespace argos
