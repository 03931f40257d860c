#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_VIEW_DRAWING_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_VIEW_DRAWING_H

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/simulator/visualization/drawing_functions.h>
#include <argos3/core/simulator/visualization/overlay.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <functional>
#include <memory>
#include <vector>

namespace argos {

class CSimulator;

/**
 * What is drawn into the pictures of one view besides the scene: owns the overlays and functions
 * that the view's element names, and the list that they and the loop functions fill.
 *
 * Order: the children of `<overlays>` and the `<user_functions>`, each in the order of the file,
 * then the loop functions.
 */
class CViewDrawing {
 public:
  /**
   * Creates what a view's element names: the children of `<overlays>`, whose tags are labels, and
   * the children `<user_functions label="..." library="..." />`. The attribute `library`, which
   * both may have, may be absent if a loaded library has registered the label.
   * @throws CARGoSException with file and line if a library cannot be loaded, if a label is not
   *         registered (listing the known ones), or if Init() throws.
   */
  void Init(TConfigurationNode& view);
  /** Destroys functions and overlays, the last one first. */
  void Destroy();

  /** True if the view's element has named user functions. */
  bool HasFunctions() const { return !m_functions.empty(); }
  /** For interactive views: passes on what their user does. */
  void ForEachFunctions(const std::function<void(CDrawingFunctions&)>& call) const;

  /** Views call it before the first tick and after each one: for overlays that need the past. */
  void Observe(CSimulator& simulator);

  /**
   * The shapes of the present state. If the clock has gone back since the last call, Reset() of
   * overlays and functions is called before.
   * @param width, height  of the picture, pixels; 0 if the view has none.
   * @throws CARGoSException what users' code throws.
   */
  const CDrawing& Draw(CSimulator& simulator, UInt32 width, UInt32 height);

 private:
  void NoticeReset(CSimulator& simulator);

  std::vector<std::unique_ptr<COverlay>> m_overlays;
  std::vector<std::unique_ptr<CDrawingFunctions>> m_functions;
  CDrawing m_drawing;
  UInt32 m_lastTick = 0;
};

}  // namespace argos

#endif
