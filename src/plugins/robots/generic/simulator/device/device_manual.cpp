#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

namespace {

// a section of a controller, which may be empty
std::string Section(const std::string& name, const std::string& device) {
  if (device.empty()) {
    return "      <" + name + " />\n";
  }
  return "      <" + name + ">\n        " + device + "\n      </" + name + ">\n";
}

std::string RequiredXML(const std::string& actuator, const std::string& sensor) {
  return "\nREQUIRED XML\n\n"
         "  <controllers>\n"
         "    <my_controller id=\"c1\">\n" +
         Section("actuators", actuator) + Section("sensors", sensor) +
         "      <params />\n"
         "    </my_controller>\n"
         "  </controllers>\n";
}

}  // namespace

std::string RequiredSensorXML(const std::string& sensor) {
  return RequiredXML("", sensor);
}

std::string RequiredActuatorXML(const std::string& actuator, const std::string& sensor) {
  return RequiredXML(actuator, sensor);
}

std::string OptionalXML(const std::string& device) {
  return "\nOPTIONAL XML\n\n  " + device + "\n";
}

std::string MediumXML(const std::string& medium, const std::string& kind) {
  return "\nwith the medium that it names:\n\n"
         "  <media>\n    " +
         medium +
         "\n  </media>\n\n"
         "  medium  text, required: the id of " +
         kind + ".\n";
}

std::string CarrierXML(const std::string& part) {
  return "\n  <foot-bot id=\"fb0\">\n"
         "    <body position=\"0,0,0\" />\n"
         "    <controller config=\"c1\" />\n    " +
         part + "\n  </foot-bot>\n";
}

std::string CarriedPartsManual(const std::string& parts, const std::string& medium,
                               const std::string& part) {
  return "\non a robot that carries " + parts + ":\n" + CarrierXML(part) +
         "\nThe manual of the medium \"" + medium + "\" describes these attributes.\n";
}

std::string NoiseManual(const std::string& quantities, const std::string& effect) {
  const bool several = quantities.find('|') != std::string::npos;
  return "\nChildren <noise on=\"" + quantities +
         "\" model=\"uniform|gaussian|rayleigh\" level|std_dev|sigma=\"...\" bias=\"0\" "
         "relative=\"false\" />\nadd noise to " +
         effect +
         (several ? "\nWithout the attribute \"on\", noise is added to all of them.\n" : "\n");
}

std::string OptionalNoiseXML(const std::string& tag, const std::string& noise) {
  return OptionalXML("<" + tag + " implementation=\"default\">\n    <noise " + noise + " />\n  </" +
                     tag + ">");
}

std::string RayReadingsManual(const std::string& tag, const std::string& implementation,
                              const std::string& shown) {
  const std::string element = "<" + tag + " implementation=\"" + implementation + "\"";
  return RequiredSensorXML(element + " />") +
         OptionalXML(element + R"( show_rays="true" noise_level="0.01" />)") +
         "\n  show_rays    \"true\" or \"false\", default \"false\": visualizations show " + shown +
         R"(.
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to each
               reading in each tick, and the sum is clamped to [0,1].
)" + NoiseManual("reading", "every reading, before it is clamped.");
}

std::string BlobCameraManual() {
  return R"(- no body other than the robot's own is between the LED and the camera. A body does not occlude an LED on its own
  surface from the side of that surface.

The sensor is disabled until the controller calls Enable(). It then takes one image in each tick and counts the images.
After Disable() the last blobs remain.
)";
}

}  // namespace argos
