#ifndef ARGOS3_COMPAT_QT_OPENGL_GL_CALLS_H
#define ARGOS3_COMPAT_QT_OPENGL_GL_CALLS_H

/*
 * The OpenGL calls of users' drawing functions: accepted. Those that move the frame of what is
 * drawn next do so in hooks that draw; the others have no effect.
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
#define GL_COMPILE 0x1300
#define GL_COMPILE_AND_EXECUTE 0x1301
#define GL_AMBIENT 0x1200
#define GL_DIFFUSE 0x1201
#define GL_SPECULAR 0x1202
#define GL_POSITION 0x1203
#define GL_EMISSION 0x1600
#define GL_SHININESS 0x1601
#define GL_AMBIENT_AND_DIFFUSE 0x1602
#define GL_MODELVIEW 0x1700
#define GL_PROJECTION 0x1701
#define GL_LINE 0x1B01
#define GL_FILL 0x1B02
#define GL_TEXTURE_MAG_FILTER 0x2800
#define GL_TEXTURE_MIN_FILTER 0x2801
#define GL_TEXTURE_WRAP_S 0x2802
#define GL_TEXTURE_WRAP_T 0x2803
#define GL_NEAREST 0x2600
#define GL_LINEAR 0x2601
#define GL_REPEAT 0x2901
#define GL_RGB 0x1907
#define GL_RGBA 0x1908
#define GL_UNSIGNED_BYTE 0x1401
#define GL_POLYGON_OFFSET_FILL 0x8037
#define GL_FALSE 0
#define GL_TRUE 1
#define GL_FLAT 0x1D00
#define GL_SMOOTH 0x1D01
#endif

namespace argos {
/** Does nothing, with any arguments. */
template <typename... ARGUMENTS>
constexpr void IgnoreGlCall(const ARGUMENTS&...) {}
/** The same for calls that give the number of the first of new objects: 1, which is valid. */
template <typename... ARGUMENTS>
constexpr GLuint IgnoreGlNumbers(const ARGUMENTS&...) {
  return 1;
}
/** As their namesakes of OpenGL; what a display list contains is not drawn. @param angle degrees.
 */
void PushGlMatrix();
void PopGlMatrix();
void TranslateGlMatrix(GLdouble x, GLdouble y, GLdouble z);
void RotateGlMatrix(GLdouble angle, GLdouble x, GLdouble y, GLdouble z);
void BeginGlList(GLuint list, GLenum mode);
void EndGlList();
/** True between BeginGlList() and EndGlList(), if what is called there is only kept. */
bool IsInGlList();
}  // namespace argos

// a qualified call, ::glEnable(...), must compile, too
using argos::BeginGlList;
using argos::EndGlList;
using argos::IgnoreGlCall;
using argos::IgnoreGlNumbers;
using argos::PopGlMatrix;
using argos::PushGlMatrix;
using argos::RotateGlMatrix;
using argos::TranslateGlMatrix;

#define glBegin IgnoreGlCall
#define glBindTexture IgnoreGlCall
#define glBlendFunc IgnoreGlCall
#define glCallList IgnoreGlCall
#define glColor3d IgnoreGlCall
#define glColor3dv IgnoreGlCall
#define glColor3f IgnoreGlCall
#define glColor3fv IgnoreGlCall
#define glColor3ub IgnoreGlCall
#define glColor4d IgnoreGlCall
#define glColor4f IgnoreGlCall
#define glColor4fv IgnoreGlCall
#define glColor4ub IgnoreGlCall
#define glCullFace IgnoreGlCall
#define glDeleteLists IgnoreGlCall
#define glDeleteTextures IgnoreGlCall
#define glDepthMask IgnoreGlCall
#define glDisable IgnoreGlCall
#define glEnable IgnoreGlCall
#define glEnd IgnoreGlCall
#define glEndList EndGlList
#define glFlush IgnoreGlCall
#define glFrontFace IgnoreGlCall
#define glGenLists IgnoreGlNumbers
#define glGenTextures IgnoreGlCall
#define glHint IgnoreGlCall
#define glLightModelfv IgnoreGlCall
#define glLightfv IgnoreGlCall
#define glLineStipple IgnoreGlCall
#define glLineWidth IgnoreGlCall
#define glLoadIdentity IgnoreGlCall
#define glMaterialf IgnoreGlCall
#define glMaterialfv IgnoreGlCall
#define glMatrixMode IgnoreGlCall
#define glMultMatrixd IgnoreGlCall
#define glMultMatrixf IgnoreGlCall
#define glNewList BeginGlList
#define glNormal3d IgnoreGlCall
#define glNormal3dv IgnoreGlCall
#define glNormal3f IgnoreGlCall
#define glNormal3fv IgnoreGlCall
#define glPointSize IgnoreGlCall
#define glPolygonMode IgnoreGlCall
#define glPolygonOffset IgnoreGlCall
#define glPopAttrib IgnoreGlCall
#define glPopMatrix PopGlMatrix
#define glPushAttrib IgnoreGlCall
#define glPushMatrix PushGlMatrix
#define glRectd IgnoreGlCall
#define glRectf IgnoreGlCall
#define glRotated RotateGlMatrix
#define glRotatef RotateGlMatrix
#define glScaled IgnoreGlCall
#define glScalef IgnoreGlCall
#define glShadeModel IgnoreGlCall
#define glTexCoord2d IgnoreGlCall
#define glTexCoord2f IgnoreGlCall
#define glTexEnvf IgnoreGlCall
#define glTexEnvi IgnoreGlCall
#define glTexImage2D IgnoreGlCall
#define glTexParameterf IgnoreGlCall
#define glTexParameteri IgnoreGlCall
#define glTranslated TranslateGlMatrix
#define glTranslatef TranslateGlMatrix
#define glVertex2d IgnoreGlCall
#define glVertex2f IgnoreGlCall
#define glVertex2i IgnoreGlCall
#define glVertex3d IgnoreGlCall
#define glVertex3dv IgnoreGlCall
#define glVertex3f IgnoreGlCall
#define glVertex3fv IgnoreGlCall

#endif
