#ifndef ARGOS3_COMPAT_CORE_UTILITY_DATATYPES_STANDARD_HEADERS_H
#define ARGOS3_COMPAT_CORE_UTILITY_DATATYPES_STANDARD_HEADERS_H

// The headers of the standard library and of the system that users' code gets with every header of
// ARGoS. A companion of datatypes.h: code of the simulator includes what it uses.
#include <string.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

#endif
