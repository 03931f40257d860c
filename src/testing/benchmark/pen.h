#ifndef ARGOS3_TESTING_BENCHMARK_PEN_H
#define ARGOS3_TESTING_BENCHMARK_PEN_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <sstream>
#include <string>

namespace argos::testing {

/** The text of a square arena between four walls, with things at random places. */
class CPen {
 public:
  /** @param half  from the middle to a wall, m. */
  explicit CPen(Real half);

  /**
   * @param margin  from walls to origins, m.
   * @param entity  an element, whose id is the first part of all ids.
   */
  void Distribute(Real margin, UInt32 count, const std::string& entity);

  /** Size of an arena with a margin of 1 m: text of an attribute. */
  std::string GetArenaSize() const;
  /** Children of <arena>. */
  std::string GetText() const { return m_text.str(); }

 private:
  Real m_half;  // m
  std::ostringstream m_text;
};

}  // namespace argos::testing

#endif
