#ifndef ARGOS3_COMPAT_QT_OPENGL_GL_CALLS_H
#define ARGOS3_COMPAT_QT_OPENGL_GL_CALLS_H

/*
 * The OpenGL calls of users' drawing functions: those of the immediate mode, of matrices and of
 * display lists draw faces, lines and points in hooks that draw; the others have no effect.
 *
 * Drawing functions fill a list; the context that draws frames is not theirs. So the names below
 * are macros for functions of this project, and users' libraries need no OpenGL library. Other
 * OpenGL functions are those of GL/gl.h, if it is installed, and of the library that the user
 * links.
 */

#if __has_include(<GL/gl.h>)
#include <GL/gl.h>
#else
typedef unsigned int GLenum;
typedef unsigned int GLuint;
typedef unsigned int GLbitfield;
typedef int GLint;
typedef int GLsizei;
typedef float GLfloat;
typedef double GLdouble;
typedef unsigned char GLubyte;
typedef unsigned char GLboolean;
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
#define GL_LIGHTING_BIT 0x00000040
#define GL_CURRENT_BIT 0x00000001
#define GL_ENABLE_BIT 0x00002000
#define GL_ALL_ATTRIB_BITS 0x000FFFFF
#define GL_TEXTURE 0x1702
#define GL_FALSE 0
#define GL_TRUE 1
#define GL_FLAT 0x1D00
#define GL_SMOOTH 0x1D01
#endif

namespace argos {
/** Does nothing, with any arguments. */
template <typename... ARGUMENTS>
constexpr void IgnoreGlCall(const ARGUMENTS&...) {}

/**
 * As their namesakes of OpenGL, with any type of numbers. Each hook begins with OpenGL's own
 * attributes, and with the frame of what it draws. Material is lit from above, a colour that was
 * set later is even.
 */
void BeginGl(GLenum shape);
void EndGl();
void AddGlVertex(GLdouble x, GLdouble y, GLdouble z = 0.0);
void SetGlNormal(GLdouble x, GLdouble y, GLdouble z);
/** From 0 to 1. */
void SetGlColor(GLdouble red, GLdouble green, GLdouble blue, GLdouble alpha = 1.0);
void SetGlColorBytes(GLubyte red, GLubyte green, GLubyte blue, GLubyte alpha = 255);
/** @param kind  GL_DIFFUSE, GL_AMBIENT_AND_DIFFUSE or GL_EMISSION; others have no effect. */
void SetGlMaterial(GLenum face, GLenum kind, const GLfloat* values);
/** Of GL_LIGHTING and GL_BLEND; others have no effect. */
void SwitchGlOn(GLenum what);
void SwitchGlOff(GLenum what);
/** @param width  pixels. */
void SetGlLineWidth(GLdouble width);
/** @param size  pixels. */
void SetGlPointSize(GLdouble size);
void PushGlAttributes(GLbitfield kinds);
void PopGlAttributes();
void DrawGlRectangle(GLdouble x1, GLdouble y1, GLdouble x2, GLdouble y2);

/** Matrices other than that of GL_MODELVIEW stay as they are. */
void SetGlMatrixMode(GLenum mode);
void PushGlMatrix();
void PopGlMatrix();
void TranslateGlMatrix(GLdouble x, GLdouble y, GLdouble z);
/** @param angle degrees. */
void RotateGlMatrix(GLdouble angle, GLdouble x, GLdouble y, GLdouble z);
void ScaleGlMatrix(GLdouble x, GLdouble y, GLdouble z);
/** @param column  0 to 2; the last one applies the matrix. */
void SetGlMatrixColumn(GLuint column, GLdouble x, GLdouble y, GLdouble z);

/** Lists are those of the process; also outside of hooks. A list has at most 1,000,000 calls. */
GLuint ReserveGlLists(GLsizei count);
void BeginGlList(GLuint list, GLenum mode);
void EndGlList();
void CallGlList(GLuint list);
void DeleteGlLists(GLuint first, GLsizei count);
GLboolean IsGlList(GLuint list);

template <typename NUMBER>
void AddGlVertex2(const NUMBER* v) {
  AddGlVertex(v[0], v[1]);
}
template <typename NUMBER>
void AddGlVertex3(const NUMBER* v) {
  AddGlVertex(v[0], v[1], v[2]);
}
template <typename NUMBER>
void SetGlNormal3(const NUMBER* v) {
  SetGlNormal(v[0], v[1], v[2]);
}
template <typename NUMBER>
void SetGlColor3(const NUMBER* v) {
  SetGlColor(v[0], v[1], v[2]);
}
template <typename NUMBER>
void SetGlColor4(const NUMBER* v) {
  SetGlColor(v[0], v[1], v[2], v[3]);
}
/** @param m  four columns; the last row counts as 0, 0, 0, 1. */
template <typename NUMBER>
void MultiplyGlMatrix(const NUMBER* m) {
  TranslateGlMatrix(m[12], m[13], m[14]);
  for (GLuint i = 0; i < 3; ++i) {
    SetGlMatrixColumn(i, m[4 * i], m[4 * i + 1], m[4 * i + 2]);
  }
}
}  // namespace argos

// a qualified call, ::glEnable(...), must compile, too
using argos::AddGlVertex;
using argos::AddGlVertex2;
using argos::AddGlVertex3;
using argos::BeginGl;
using argos::BeginGlList;
using argos::CallGlList;
using argos::DeleteGlLists;
using argos::DrawGlRectangle;
using argos::EndGl;
using argos::EndGlList;
using argos::IgnoreGlCall;
using argos::IsGlList;
using argos::MultiplyGlMatrix;
using argos::PopGlAttributes;
using argos::PopGlMatrix;
using argos::PushGlAttributes;
using argos::PushGlMatrix;
using argos::ReserveGlLists;
using argos::RotateGlMatrix;
using argos::ScaleGlMatrix;
using argos::SetGlColor;
using argos::SetGlColor3;
using argos::SetGlColor4;
using argos::SetGlColorBytes;
using argos::SetGlLineWidth;
using argos::SetGlMaterial;
using argos::SetGlMatrixMode;
using argos::SetGlNormal;
using argos::SetGlNormal3;
using argos::SetGlPointSize;
using argos::SwitchGlOff;
using argos::SwitchGlOn;
using argos::TranslateGlMatrix;

#define glBegin BeginGl
#define glBindTexture IgnoreGlCall
#define glBlendFunc IgnoreGlCall
#define glCallList CallGlList
#define glColor3d SetGlColor
#define glColor3dv SetGlColor3
#define glColor3f SetGlColor
#define glColor3fv SetGlColor3
#define glColor3ub SetGlColorBytes
#define glColor4d SetGlColor
#define glColor4dv SetGlColor4
#define glColor4f SetGlColor
#define glColor4fv SetGlColor4
#define glColor4ub SetGlColorBytes
#define glCullFace IgnoreGlCall
#define glDeleteLists DeleteGlLists
#define glDeleteTextures IgnoreGlCall
#define glDepthMask IgnoreGlCall
#define glDisable SwitchGlOff
#define glEnable SwitchGlOn
#define glEnd EndGl
#define glEndList EndGlList
#define glFlush IgnoreGlCall
#define glFrontFace IgnoreGlCall
#define glGenLists ReserveGlLists
#define glGenTextures IgnoreGlCall
#define glHint IgnoreGlCall
#define glIsList IsGlList
#define glLightModelfv IgnoreGlCall
#define glLightfv IgnoreGlCall
#define glLineStipple IgnoreGlCall
#define glLineWidth SetGlLineWidth
#define glLoadIdentity IgnoreGlCall
#define glMaterialf IgnoreGlCall
#define glMaterialfv SetGlMaterial
#define glMatrixMode SetGlMatrixMode
#define glMultMatrixd MultiplyGlMatrix
#define glMultMatrixf MultiplyGlMatrix
#define glNewList BeginGlList
#define glNormal3d SetGlNormal
#define glNormal3dv SetGlNormal3
#define glNormal3f SetGlNormal
#define glNormal3fv SetGlNormal3
#define glPointSize SetGlPointSize
#define glPolygonMode IgnoreGlCall
#define glPolygonOffset IgnoreGlCall
#define glPopAttrib PopGlAttributes
#define glPopMatrix PopGlMatrix
#define glPushAttrib PushGlAttributes
#define glPushMatrix PushGlMatrix
#define glRectd DrawGlRectangle
#define glRectf DrawGlRectangle
#define glRotated RotateGlMatrix
#define glRotatef RotateGlMatrix
#define glScaled ScaleGlMatrix
#define glScalef ScaleGlMatrix
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
#define glVertex2d AddGlVertex
#define glVertex2dv AddGlVertex2
#define glVertex2f AddGlVertex
#define glVertex2fv AddGlVertex2
#define glVertex2i AddGlVertex
#define glVertex3d AddGlVertex
#define glVertex3dv AddGlVertex3
#define glVertex3f AddGlVertex
#define glVertex3fv AddGlVertex3
#define glVertex3i AddGlVertex

#endif
