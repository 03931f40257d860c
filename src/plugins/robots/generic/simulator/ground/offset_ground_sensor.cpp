#include <argos3/plugins/robots/generic/simulator/offset_ground_sensor.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

std::string GroundSensorManual(const std::string& tag, const std::string& next) {
  const std::string element = "<" + tag + R"( implementation="rot_z_only")";
  return RequiredSensorXML(element + " />") + R"(
with a floor:

  <arena size="10,10,2">
    <floor id="floor" source="image" path="floor.png" />
  </arena>
)" + OptionalXML(element + R"( noise_level="0.1" />)") +
         R"(
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to the grey
               level of each sensor in each tick, before )" +
         next + ".\n" + NoiseManual("reading", "the grey level in the same way.");
}

}  // namespace argos
