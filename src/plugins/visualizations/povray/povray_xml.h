#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_XML_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_POVRAY_XML_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/simulator/visualizations/povray/povray_frame_series.h>

namespace argos {

/**
 * Reads the attributes of `<povray>`, see the view's description.
 * @throws CARGoSException with file and line, if one does not parse or is out of range.
 */
SPovrayFrameSettings ReadPovraySettings(TConfigurationNode& node);

}  // namespace argos

#endif
