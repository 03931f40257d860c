#ifndef ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_CAMERA_H
#define ARGOS3_COMPAT_QT_OPENGL_QTOPENGL_CAMERA_H

namespace argos {

/** The camera of the window that this simulator does not have. */
class CQTOpenGLCamera {};

}  // namespace argos

#endif
