#include "campaign_world.h"

#include <argos3/testing/support/paths.h>

#include <fmt/format.h>

namespace argos {

std::string MakeCampaignExperiment(const std::string& what, int seed, int length) {
  static constexpr char kText[] = R"(<argos-configuration>
  <framework><experiment length="{length}" ticks_per_second="10" random_seed="7" /></framework>
  <controllers>
    <misbehaves_once id="c" library="{library}">
      <actuators><differential_steering implementation="default" /></actuators>
      <sensors />
      <params what="{what}" seed="{seed}" period="0" />
    </misbehaves_once>
  </controllers>
  <loop_functions label="measures" library="{library}" gain="1" />
  <arena size="4, 4, 1">
    <foot-bot id="fb0"><body position="-1,0,0" /><controller config="c" /></foot-bot>
    <foot-bot id="fb1"><body position="1,0,0" /><controller config="c" /></foot-bot>
  </arena>
  <physics_engines><kinematics2d id="k" /></physics_engines>
  <media />
</argos-configuration>
)";
  const std::string library = InBuildTree("testing/plugins/libargos3_test_campaign.so");
  return fmt::format(kText, fmt::arg("length", length), fmt::arg("library", library),
                     fmt::arg("what", what), fmt::arg("seed", seed));
}

}  // namespace argos
