#include <argos3/core/simulator/visualization/appearance.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <array>

namespace argos {

namespace {

// index: EMaterial
constexpr std::array<std::string_view, static_cast<size_t>(EMaterial::Count)> kMaterials = {
    "plastic", "matte", "metal", "glass"};

}  // namespace

std::string_view ToText(EMaterial material) {
  return kMaterials[static_cast<size_t>(material)];
}

EMaterial MaterialFromText(std::string_view text) {
  const auto found = std::find(kMaterials.begin(), kMaterials.end(), text);
  if (found == kMaterials.end()) {
    THROW_ARGOSEXCEPTION("unknown material \""
                         << text << "\""
                         << DidYouMean(
                                std::string(text),
                                std::vector<std::string>(kMaterials.begin(), kMaterials.end())));
  }
  return static_cast<EMaterial>(found - kMaterials.begin());
}

}  // namespace argos
