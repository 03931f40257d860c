#ifndef PARAMETERS_H
#define PARAMETERS_H

constexpr double kSpeed = 10.0;  // cm/s

#endif
