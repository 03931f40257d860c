#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_DEVICE_MANUAL_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_DEVICE_MANUAL_H

#include <string>

namespace argos {

/*
 * Texts that the manuals of several devices share: parts of the LONG_DESCRIPTION of REGISTER_SENSOR
 * and REGISTER_ACTUATOR. Each one begins with a blank line. They are called while libraries load,
 * so they use no other static objects.
 */

/**
 * "REQUIRED XML": a controller with one sensor.
 * @param sensor  its XML element. Lines after the first one are indented by 8 blanks.
 */
std::string RequiredSensorXML(const std::string& sensor);
/** The same for an actuator. @param sensor  a sensor that is used with it; empty for none. */
std::string RequiredActuatorXML(const std::string& actuator, const std::string& sensor = "");
/** "OPTIONAL XML". @param device  the XML element. Lines after the first one are indented by 2. */
std::string OptionalXML(const std::string& device);

/**
 * The medium that a device names in its attribute `medium`.
 * @param medium  its XML element. Lines after the first one are indented by 4 blanks.
 * @param kind    with an article, such as "an LED medium".
 */
std::string MediumXML(const std::string& medium, const std::string& kind);
/**
 * Parts that a robot has to carry for a device, and where their attributes are described.
 * @param parts   in the plural: "radios".
 * @param medium  the medium whose manual describes them.
 * @param part    see CarrierXML().
 */
std::string CarriedPartsManual(const std::string& parts, const std::string& medium,
                               const std::string& part);
/** The robot that carries a device. @param part  its XML element, indented by 4 after line 1. */
std::string CarrierXML(const std::string& part);

/**
 * The children `<noise>`.
 * @param quantities  that the attribute `on` accepts, with "|" in between.
 * @param effect      continues the sentence "Children <noise ...> add noise to".
 */
std::string NoiseManual(const std::string& quantities, const std::string& effect);

/**
 * "OPTIONAL XML" of a device of the implementation "default" with a child `<noise>`.
 * @param tag    of the device.
 * @param noise  attributes of the child.
 */
std::string OptionalNoiseXML(const std::string& tag, const std::string& noise);

/**
 * Required and optional XML of a sensor with the attributes `show_rays` and `noise_level`, whose
 * readings are in [0,1].
 * @param tag, implementation  of the sensor.
 * @param shown                the objects that `show_rays` shows.
 */
std::string RayReadingsManual(const std::string& tag, const std::string& implementation,
                              const std::string& shown);

/**
 * Of a camera of blobs: the last condition for a blob, and when it takes images. Does not begin
 * with a blank line.
 */
std::string BlobCameraManual();

}  // namespace argos

#endif
