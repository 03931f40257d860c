#ifndef ARGOS3_TESTING_BENCHMARK_PILES_H
#define ARGOS3_TESTING_BENCHMARK_PILES_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>

namespace argos::testing {

/** Towers of ten boxes, each turned by 7 degrees against the one below: an experiment. */
std::string MakeTowers(UInt32 boxes, UInt32 threads, const std::string& engine,
                       const std::string& attributes = "");
/** Boxes in rows on each other, pyramids of 20 rows, 210 boxes each. */
std::string MakeStack(UInt32 boxes, UInt32 threads, const std::string& engine,
                      const std::string& attributes = "");
/** Balls of 0.1 m that fall into a pen from ten layers. */
std::string MakePile(UInt32 balls, UInt32 threads, const std::string& engine,
                     const std::string& attributes = "");

}  // namespace argos::testing

#endif
