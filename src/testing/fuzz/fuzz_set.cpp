// The input is the argument of --set, "path=value", for an experiment with nested elements.

#include <argos3/testing/fuzz/fuzz_support.h>

#include <argos3/core/utility/configuration/configuration_document.h>

#include <string>

using namespace argos;

namespace {

constexpr const char* kExperiment =
    "<argos-configuration>\n"
    "<framework><experiment length='10' ticks_per_second='10' random_seed='1'/></framework>\n"
    "<controllers><a id='a'><params x='1'/></a><a id='b'><params x='2' y='3'/></a></controllers>\n"
    "<arena size='4,4,1'><distribute><entity quantity='3'><foot-bot id='fb'>"
    "<controller config='a'/></foot-bot></entity></distribute>"
    "<box id='box'><body position='1,1,0'/></box></arena>\n"
    "</argos-configuration>\n";

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return RunFuzzInput([data, size] {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t sign = text.rfind('=');
    CConfigurationDocument document;
    document.Parse(kExperiment, "fuzz");
    document.SetByPath(text.substr(0, sign),
                       sign == std::string::npos ? "" : text.substr(sign + 1));
  });
}
