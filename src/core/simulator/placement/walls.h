#ifndef ARGOS3_CORE_SIMULATOR_PLACEMENT_WALLS_H
#define ARGOS3_CORE_SIMULATOR_PLACEMENT_WALLS_H

#include <argos3/core/simulator/images/image_file.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <string>
#include <vector>

namespace argos {

class CSpace;

/** A rectangular piece of a wall, seen from above. */
struct SWallPiece {
  CVector2 Center; /**< m */
  CVector2 Size; /**< along the wall and across it, m */
  CRadians Direction; /**< direction of the wall */
};

/** Four pieces along the sides of the arena, within its limits. */
std::vector<SWallPiece> MakeWallsAround(const CRange<CVector3>& limits, Real thickness);

/**
 * A piece for each two points that follow each other, whose axis is the line between them. Pieces
 * are as much longer as the outer edges of a corner need to meet, but at most by the thickness.
 * @param points  at least two, no two in a row equal. @param isClosed  the last one is joined to
 *   the first.
 */
std::vector<SWallPiece> MakeWallsAlong(const std::vector<CVector2>& points, bool isClosed,
                                       Real thickness);

/**
 * Rectangles that cover the dark pixels of a map, and no others, in few pieces.
 * @param center  of the image, m. @param metersPerPixel  > 0.
 * @param threshold  a pixel whose mean of red, green and blue is below it, from 0 to 1, is wall.
 */
std::vector<SWallPiece> MakeWallsOfImage(const SImage& image, const CVector2& center,
                                         Real metersPerPixel, Real threshold);

/**
 * The lines of a drawing in SVG, each a list of points in m, and whether it is closed: `<line>`,
 * `<polyline>`, `<polygon>`, `<rect>`, and `<path>` of straight lines, at any depth. The origin of
 * the drawing is the upper left corner, as in SVG; the y axis points down there, and up here.
 */
struct SWallLine {
  std::vector<CVector2> Points;
  bool IsClosed = false;
};
/**
 * @param path  of the file. @param metersPerUnit  length of a unit of the drawing.
 * @throws CARGoSException if it is no SVG, or has curves or transformations.
 */
std::vector<SWallLine> ReadWallLines(const std::string& path, Real metersPerUnit);

/**
 * Adds the boxes of an element `<walls>`, which cannot move. Its attributes: `id` ("walls"), of
 * which the boxes are `<id>_0`, ...; `thickness` and `height`, m; and what there is: `points`, "x,y
 * x,y ...", with `closed` (true); or `image` with `meters_per_pixel`, `center` (0,0) and
 * `threshold` (0.5); or `svg` with `meters_per_unit` and `corner`, the place of the upper left one
 * (0,0); or none of them: the sides of the arena. Bases are at `base` (0), m.
 * @throws CARGoSException if an attribute is malformed, or a file cannot be read.
 */
void AddWalls(CSpace& space, TConfigurationNode& element);

/** The same for the attribute `walls="THICKNESS,HEIGHT"` of `<arena>`, if it has one. */
void AddWallsAround(CSpace& space, TConfigurationNode& arena);

}  // namespace argos

#endif
