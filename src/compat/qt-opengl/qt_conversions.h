#ifndef ARGOS3_COMPAT_QT_OPENGL_QT_CONVERSIONS_H
#define ARGOS3_COMPAT_QT_OPENGL_QT_CONVERSIONS_H

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>

namespace argos {

/** Aligned to the left; at 96 pixels an inch, a point is 4/3 of a pixel. */
STextStyle ToTextStyle(const QFont& font);

}  // namespace argos

#endif
