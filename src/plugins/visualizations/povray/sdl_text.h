#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_SDL_TEXT_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_POVRAY_SDL_TEXT_H

#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <Eigen/Core>

#include <array>
#include <string>
#include <string_view>

namespace argos {

/*
 * Pieces of POV-Ray's scene description language (SDL). All of them are independent of the locale.
 */

/** @param value finite. @return the shortest text that reads as the same number. */
std::string ToSdl(double value);
std::string ToSdl(float value);
/** "<x,y,z>". */
std::string ToSdl(const Eigen::Vector3d& vector);
std::string ToSdl(const std::array<float, 3>& vector);

/** A colour given in sRGB: "srgb <r,g,b>", or "srgbt <r,g,b,t>" if it is translucent. */
std::string ToSdl(const SRgba& color);
/** The same colour as a filter of light, for glass. @param share of the light, 0 to 1. */
std::string ToSdlFilter(const SRgba& color, double share);

/** "matrix <...>" with the 12 numbers in POV-Ray's order: the images of x, y, z and the origin. */
std::string ToSdl(const std::array<std::array<float, 4>, 3>& rows);

/**
 * A string literal with its quotes. Quotes and backslashes are escaped, control characters become
 * blanks, so that no text ends the literal.
 * @param text UTF-8; what is not valid becomes "?".
 */
std::string ToSdlString(std::string_view text);

/** @return true if all entries are finite. */
bool IsFinite(const std::array<float, 3>& vector);
bool IsFinite(const std::array<std::array<float, 4>, 3>& rows);

}  // namespace argos

#endif
