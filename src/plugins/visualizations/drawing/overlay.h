#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_OVERLAY_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_OVERLAY_H

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/plugins/factory.h>

namespace argos {

class CSimulator;

/**
 * Something that a view can add to its pictures by XML alone, such as ids or trails: a child of
 * `<overlays>` in the view's element, whose tag is the label of the class.
 *
 * Functions are called on the main thread, between ticks. They may read everything and must change
 * nothing: a run without a view does not call them.
 */
class COverlay : public CBaseConfigurableResource {
 public:
  /** @param tree the child of `<overlays>`. @throws CARGoSException if a value is wrong. */
  void Init(TConfigurationNode&) override {}
  /** The experiment was reset. */
  void Reset() override {}
  void Destroy() override {}

  /** Called before the first tick and after each one, whether or not there is a picture then. */
  virtual void Observe(CSimulator&) {}
  /** Adds its shapes for a picture of the present state. @param drawing in the world's frame. */
  virtual void Draw(CSimulator& simulator, CDrawing& drawing) = 0;
};

}  // namespace argos

#define REGISTER_OVERLAY(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION, \
                         STATUS)                                                                 \
  REGISTER_SYMBOL(COverlay, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,                \
                  LONG_DESCRIPTION, STATUS)

#endif
