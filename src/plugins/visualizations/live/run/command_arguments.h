#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_COMMAND_ARGUMENTS_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_LIVE_RUN_COMMAND_ARGUMENTS_H

#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/visualizations/live/link/live_messages.h>

#include <optional>
#include <string>

namespace argos {

/*
 * Arguments of viewers' commands. Each function throws CARGoSException with the name and what is
 * expected if the argument has another form; those that return an optional, nothing if it is
 * absent.
 */

std::string ReadTextArgument(const TJson& arguments, const char* name);
/** @param least, most  the allowed numbers. */
std::optional<Real> ReadNumberArgument(const TJson& arguments, const char* name, Real least,
                                       Real most);
/** A whole number. */
std::optional<UInt32> ReadCountArgument(const TJson& arguments, const char* name, UInt32 least,
                                        UInt32 most);
std::optional<bool> ReadFlagArgument(const TJson& arguments, const char* name);
/** Three numbers, each from -most to most. */
std::optional<CVector3> ReadVectorArgument(const TJson& arguments, const char* name, Real most);

}  // namespace argos

#endif
