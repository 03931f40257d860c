#include <argos3/program/catalogue/interface_class.h>

#include <argos3/core/utility/plugins/registration.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <cxxabi.h>

#include <vector>

namespace argos {

namespace {

std::vector<const std::type_info*> BasesOf(const std::type_info& type) {
  if (const auto* single = dynamic_cast<const abi::__si_class_type_info*>(&type)) {
    return {single->__base_type};
  }
  std::vector<const std::type_info*> bases;
  if (const auto* several = dynamic_cast<const abi::__vmi_class_type_info*>(&type)) {
    for (unsigned i = 0; i < several->__base_count; ++i) {
      bases.push_back(several->__base_info[i].__base_type);
    }
  }
  return bases;
}

// without namespaces
std::string NameOf(const std::type_info& type) {
  const std::string name = DemangledName(type);
  const size_t colons = name.find('<') == std::string::npos ? name.rfind("::") : std::string::npos;
  return colons == std::string::npos ? name : name.substr(colons + 2);
}

}  // namespace

// breadth first: a class is nearer than its bases
SInterfaceClass FindInterfaceClass(const std::type_info& device) {
  std::vector<const std::type_info*> level = {&device};
  while (!level.empty()) {
    std::vector<const std::type_info*> next;
    for (const std::type_info* const type : level) {
      const std::string name = NameOf(*type);
      if (name.rfind("CCI_", 0) == 0 && name != "CCI_Sensor" && name != "CCI_Actuator") {
        return {name, GetLibraryOf(type)};
      }
      for (const std::type_info* const base : BasesOf(*type)) {
        next.push_back(base);
      }
    }
    level = std::move(next);
  }
  return {};
}

}  // namespace argos
