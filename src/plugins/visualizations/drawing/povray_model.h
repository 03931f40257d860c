#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_POVRAY_MODEL_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_POVRAY_MODEL_H

#include <argos3/core/utility/plugins/factory.h>

#include <string>
#include <vector>

namespace argos {

/**
 * A finer model of a type of entities for the view `<povray>`, in POV-Ray's scene description
 * language.
 *
 * The label of the registered class is the tag of the type, such as "eye-bot". A model replaces the
 * solids of the type's appearance; the view adds its LEDs, with their colours and light.
 */
class CPovrayModel {
 public:
  /** What replaces the solids on one anchor. */
  struct SPart {
    std::string Anchor = "origin";
    /**
     * One object (`union`, `merge`, ...) in the anchor's frame: m, right-handed, z up. Texts may
     * use the macros that doc/povray.md lists.
     */
    std::string Object;
  };

  virtual ~CPovrayModel() = default;

  /** Called once per view. Anchors without a part keep their solids. */
  virtual std::vector<SPart> MakeParts() const = 0;
};

}  // namespace argos

#define REGISTER_POVRAY_MODEL(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION,   \
                              LONG_DESCRIPTION, STATUS)                               \
  REGISTER_SYMBOL(CPovrayModel, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, \
                  LONG_DESCRIPTION, STATUS)

#endif
