#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_VIEW_DRAWING_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_VIEW_DRAWING_H

// the path of earlier versions
#include <argos3/core/simulator/visualization/view_drawing.h>

#endif
