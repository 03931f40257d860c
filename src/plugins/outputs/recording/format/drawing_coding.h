#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_DRAWING_CODING_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_DRAWING_CODING_H

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/support/byte_stream.h>

namespace argos {

/** Writes the shapes that users' code has drawn. */
void WriteDrawing(const CDrawing& drawing, CByteWriter& out);

/**
 * Draws the shapes of a space again, in the order in which they were drawn.
 * @throws CARGoSException if the bytes are no drawing.
 */
void DrawAgain(CByteReader& in, SDrawnShape::ESpace space, CDrawing& drawing);

}  // namespace argos

#endif
