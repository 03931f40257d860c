#include <argos3/testing/benchmark/pen.h>

namespace argos::testing {

CPen::CPen(Real half) : m_half(half) {
  for (const int side : {-1, 1}) {
    const Real at = side * (half + 0.05);
    m_text << "<box id='x" << side << "' size='0.1," << 2.0 * half << ",0.2' movable='false'><body "
           << "position='" << at << ",0,0'/></box><box id='y" << side << "' size='" << 2.0 * half
           << ",0.1,0.2' movable='false'><body position='0," << at << ",0'/></box>";
  }
}

void CPen::Distribute(Real margin, UInt32 count, const std::string& entity) {
  const Real most = m_half - margin;
  m_text << "<distribute><position method='uniform' min='" << -most << "," << -most << ",0' max='"
         << most << "," << most
         << ",0'/><orientation method='uniform' min='0,0,0' max='360,0,0'/><entity quantity='"
         << count << "' max_trials='1000'>" << entity << "</entity></distribute>";
}

std::string CPen::GetArenaSize() const {
  const std::string side = std::to_string(2.0 * m_half + 2.0);
  return side + "," + side + ",2";
}

}  // namespace argos::testing
