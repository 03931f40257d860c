#include <argos3/plugins/simulator/visualizations/povray/povray_xml.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <array>
#include <utility>

namespace argos {

namespace {

constexpr UInt32 kMaxLights = 1000;
constexpr UInt32 kMaxThreads = 512;  // POV-Ray's limit

template <typename VALUE, std::size_t SIZE>
void ReadChoice(TConfigurationNode& node, const std::string& attribute,
                const std::array<std::pair<const char*, VALUE>, SIZE>& choices, VALUE& value) {
  if (!NodeAttributeExists(node, attribute)) {
    return;
  }
  std::string text;
  GetNodeAttribute(node, attribute, text);
  const auto found = std::find_if(choices.begin(), choices.end(),
                                  [&text](const auto& choice) { return text == choice.first; });
  if (found == choices.end()) {
    std::vector<std::string> names;
    for (const auto& choice : choices) {
      names.emplace_back(choice.first);
    }
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"" << attribute << "\": \"" << text
                                       << "\" is not valid" << DidYouMean(text, names));
  }
  value = found->second;
}

void ReadUpTo(TConfigurationNode& node, const std::string& attribute, UInt32 most, UInt32& value) {
  GetNodeAttributeOrDefault(node, attribute, value, value);
  if (value > most) {
    THROW_ARGOSEXCEPTION(OwnerOf(node) << ": attribute \"" << attribute << "\": " << value
                                       << " is out of range; it must be at most " << most);
  }
}

}  // namespace

SPovrayFrameSettings ReadPovraySettings(TConfigurationNode& node) {
  using ERender = SPovrayFrameSettings::ERender;
  using TQuality = std::pair<const char*, EPovrayQuality>;
  using TRender = std::pair<const char*, ERender>;
  using TLook = std::pair<const char*, bool>;
  SPovrayFrameSettings settings;
  SPovraySettings& scene = settings.Scene;
  GetNodeAttributeOrDefault(node, "directory", settings.Directory, settings.Directory);
  GetNodeAttributeOrDefault(node, "base_name", settings.BaseName, settings.BaseName);
  ReadFrameSize(node, scene.Width, scene.Height);
  ReadFrameChoice(node, settings);
  ReadChoice(node, "quality",
             std::array<TQuality, 3>{{{"draft", EPovrayQuality::Draft},
                                      {"good", EPovrayQuality::Good},
                                      {"best", EPovrayQuality::Best}}},
             scene.Quality);
  ReadChoice(node, "render",
             std::array<TRender, 3>{
                 {{"auto", ERender::IfInstalled}, {"false", ERender::No}, {"true", ERender::Yes}}},
             settings.Render);
  ReadChoice(node, "look", std::array<TLook, 2>{{{"dark", true}, {"light", false}}}, scene.IsDark);
  scene.Look = SLook::FromName(scene.IsDark ? "dark" : "light");
  ReadUpTo(node, "max_lights", kMaxLights, scene.MostLights);
  ReadUpTo(node, "threads", kMaxThreads, settings.Threads);
  ReadFrameContents(node, settings);
  GetNodeAttributeOrDefault(node, "models", settings.UseModels, true);
  return settings;
}

}  // namespace argos
