#include <argos3/testing/support/experiment.h>

#include <sstream>

namespace argos {

std::string SExperiment::ToXml() const {
  std::ostringstream xml;
  xml << "<argos-configuration>\n"
      << "<framework><system threads='" << Threads << "' method='" << Method << "' />\n"
      << "<experiment length='" << Length << "' ticks_per_second='" << TicksPerSecond
      << "' random_seed='" << Seed << "' /></framework>\n"
      << "<controllers>" << Controllers << "</controllers>\n"
      << LoopFunctions << "\n"
      << "<physics_engines>" << Engines << "</physics_engines>\n"
      << "<media>" << Media << "</media>\n"
      << "<arena size='" << ArenaSize << "'"
      << (ArenaCenter.empty() ? "" : " center='" + ArenaCenter + "'") << ' ' << ArenaAttributes
      << ">\n"
      << Arena << "\n</arena>\n"
      << "</argos-configuration>\n";
  return xml.str();
}

CTestWorld::CTestWorld(const std::string& xml, const std::function<void(CSimulator&)>& prepare) {
  m_document.Parse(xml, "test.argos");
  if (prepare) {
    prepare(m_simulator);
  }
  m_simulator.Load(m_document, true);
}

void CTestWorld::Step(UInt32 ticks) {
  for (UInt32 tick = 0; tick < ticks; ++tick) {
    m_simulator.UpdateSpace();
  }
}

std::string LoadError(const SExperiment& experiment) {
  try {
    const CTestWorld world(experiment);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace argos
