#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_OUTPUT_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_OUTPUT_H

#include <argos3/plugins/simulator/visualizations/offscreen/frame_output.h>

namespace argos {

/**
 * Runs experiments whose file requests the window `<qt-opengl>`, which this simulator does not
 * have: headless, or with frames drawn off-screen if the file requests frame grabbing.
 */
class CQtOpenGlOutput : public CFrameOutput {
 public:
  /** Reads the attributes that the plug-in's description lists. @throws CARGoSException with file
   * and line. */
  void Init(TConfigurationNode& tree) override { InitAsQtOpenGl(tree); }
};

}  // namespace argos

#endif
