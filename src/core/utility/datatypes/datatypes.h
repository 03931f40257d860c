#ifndef ARGOS3_CORE_UTILITY_DATATYPES_DATATYPES_H
#define ARGOS3_CORE_UTILITY_DATATYPES_DATATYPES_H

/*
 * The primitive types of the public interface. C code may include this header and gets only the
 * type names.
 */

#include <argos3/core/config.h>

#ifdef __cplusplus
#include <cstddef>
#include <iosfwd>

namespace argos {
#endif

/* 8-bit integers: 'signed char' rather than 'char', whose sign differs between platforms. */
typedef signed char SInt8;
typedef unsigned char UInt8;

typedef signed short SInt16;
typedef unsigned short UInt16;

typedef signed int SInt32;
typedef unsigned int UInt32;

/* 'long long' on every platform: overload sets distinguish it from 'long'. */
typedef signed long long SInt64;
typedef unsigned long long UInt64;

/* The type of every physical quantity. Its size is part of the binary interface. */
#ifdef ARGOS_USE_DOUBLE
typedef double Real;
#else
typedef float Real;
#endif

#ifdef __cplusplus

/**
 * Print 8-bit integers as numbers.
 *
 * The standard library prints them as characters. These overloads are found inside namespace
 * argos, or after "using namespace argos".
 */
std::ostream& operator<<(std::ostream& stream, const SInt8 value);
std::ostream& operator<<(std::ostream& stream, const UInt8 value);

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/datatypes/standard_headers.h>
#endif
#endif

#endif
