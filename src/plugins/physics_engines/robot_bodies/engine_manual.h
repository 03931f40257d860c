#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ENGINE_MANUAL_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_ENGINE_MANUAL_H

#include <string>

namespace argos {

/*
 * Texts that the manuals of several engines share: parts of the LONG_DESCRIPTION of
 * REGISTER_PHYSICS_ENGINE. Each one begins with a blank line, unless it says otherwise. They are
 * called while libraries load, so they use no other static objects.
 */

/** "REQUIRED XML". @param engine  its XML element. */
std::string RequiredEngineXML(const std::string& engine);
/**
 * "OPTIONAL XML", with `<boundaries>`.
 * @param tag, attributes  of the engine.
 * @param children  the lines before <boundaries>, indented by 6 blanks.
 * @param limits    the lines in it before <sides>, indented by 8 blanks.
 */
std::string OptionalEngineXML(const std::string& tag, const std::string& attributes,
                              const std::string& children, const std::string& limits);
/**
 * The attributes `boundaries` and `ghosts` of an engine of a plane: lines of "ATTRIBUTES", without
 * a blank one before them.
 */
std::string PlanarBoundariesManual();
/** The attribute `velocity_lag` of an engine of a plane: lines as of PlanarBoundariesManual(). */
std::string VelocityLagManual();
/** `<friction>` of an engine of a plane: lines without a blank one before them. */
std::string PlanarFrictionXML();

}  // namespace argos

#endif
