#ifndef ARGOS3_COMPAT_QT_OPENGL_GL_CALLS_H
#define ARGOS3_COMPAT_QT_OPENGL_GL_CALLS_H

/*
 * The OpenGL calls of users' drawing functions: accepted, without effect.
 *
 * Drawing functions fill a list, so there is no OpenGL state that such calls could change; the
 * context that draws frames is not theirs. The names below are macros for functions that do
 * nothing, so users' libraries need no OpenGL library. Other OpenGL functions are those of GL/gl.h,
 * if it is installed, and of the library that the user links.
 */

#if __has_include(<GL/gl.h>)
#include <GL/gl.h>
#else
typedef unsigned int GLenum;
typedef unsigned int GLuint;
typedef unsigned int GLbitfield;
typedef int GLint;
typedef float GLfloat;
typedef double GLdouble;
typedef unsigned char GLubyte;
// source: the OpenGL registry
#define GL_POINTS 0x0000
#define GL_LINES 0x0001
#define GL_LINE_LOOP 0x0002
#define GL_LINE_STRIP 0x0003
#define GL_TRIANGLES 0x0004
#define GL_TRIANGLE_STRIP 0x0005
#define GL_TRIANGLE_FAN 0x0006
#define GL_QUADS 0x0007
#define GL_QUAD_STRIP 0x0008
#define GL_POLYGON 0x0009
#define GL_ONE 1
#define GL_SRC_ALPHA 0x0302
#define GL_ONE_MINUS_SRC_ALPHA 0x0303
#define GL_FRONT 0x0404
#define GL_BACK 0x0405
#define GL_FRONT_AND_BACK 0x0408
#define GL_POINT_SMOOTH 0x0B10
#define GL_LINE_SMOOTH 0x0B20
#define GL_CULL_FACE 0x0B44
#define GL_LIGHTING 0x0B50
#define GL_DEPTH_TEST 0x0B71
#define GL_NORMALIZE 0x0BA1
#define GL_BLEND 0x0BE2
#define GL_TEXTURE_2D 0x0DE1
#define GL_FLAT 0x1D00
#define GL_SMOOTH 0x1D01
#endif

namespace argos {
/** Does nothing, with any arguments. */
template <typename... ARGUMENTS>
constexpr void IgnoreGlCall(const ARGUMENTS&...) {}
}  // namespace argos

// a qualified call, ::glEnable(...), must compile, too
using argos::IgnoreGlCall;

#define glBegin IgnoreGlCall
#define glBlendFunc IgnoreGlCall
#define glColor3d IgnoreGlCall
#define glColor3f IgnoreGlCall
#define glColor3ub IgnoreGlCall
#define glColor4d IgnoreGlCall
#define glColor4f IgnoreGlCall
#define glColor4ub IgnoreGlCall
#define glDepthMask IgnoreGlCall
#define glDisable IgnoreGlCall
#define glEnable IgnoreGlCall
#define glEnd IgnoreGlCall
#define glLineWidth IgnoreGlCall
#define glMaterialf IgnoreGlCall
#define glMaterialfv IgnoreGlCall
#define glNormal3d IgnoreGlCall
#define glNormal3f IgnoreGlCall
#define glPointSize IgnoreGlCall
#define glPopAttrib IgnoreGlCall
#define glPopMatrix IgnoreGlCall
#define glPushAttrib IgnoreGlCall
#define glPushMatrix IgnoreGlCall
#define glRotated IgnoreGlCall
#define glRotatef IgnoreGlCall
#define glScaled IgnoreGlCall
#define glScalef IgnoreGlCall
#define glShadeModel IgnoreGlCall
#define glTranslated IgnoreGlCall
#define glTranslatef IgnoreGlCall
#define glVertex2d IgnoreGlCall
#define glVertex2f IgnoreGlCall
#define glVertex3d IgnoreGlCall
#define glVertex3f IgnoreGlCall

#endif
