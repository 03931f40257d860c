#ifndef ARGOS3_CORE_SIMULATOR_VIEW_DRAWING_H
#define ARGOS3_CORE_SIMULATOR_VIEW_DRAWING_H

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/simulator/visualization/drawing_functions.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <memory>
#include <vector>

namespace argos {

class CSimulator;

/**
 * What users' code draws into the pictures of one view: owns the functions that the view's element
 * names, and the list that they and the loop functions fill.
 *
 * Order: the `<user_functions>` in the order of the file, then the loop functions.
 */
class CViewDrawing {
 public:
  /**
   * Creates the functions that the children `<user_functions label="..." library="..." />` of a
   * view's element name. The attribute `library` may be absent if a loaded library has registered
   * the label.
   * @throws CARGoSException with file and line if a library cannot be loaded, if a label is not
   *         registered (listing the known ones), or if Init() throws.
   */
  void Init(TConfigurationNode& view);
  /** Destroys the functions, the last one first. */
  void Destroy();

  /**
   * The shapes of the present state. If the clock has gone back since the last call, Reset() of the
   * functions is called before.
   * @param width, height  of the picture, pixels; 0 if the view has none.
   * @throws CARGoSException what users' code throws.
   */
  const CDrawing& Draw(CSimulator& simulator, UInt32 width, UInt32 height);

 private:
  std::vector<std::unique_ptr<CDrawingFunctions>> m_functions;
  CDrawing m_drawing;
  UInt32 m_lastTick = 0;
};

}  // namespace argos

#endif
