#include "experiment_text.h"

#include <argos3/core/simulator/simulator.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/testing/support/paths.h>

#include <sstream>

namespace argos {

namespace {

/* Captures the output of a log during its lifetime. */
class CCapture {
 public:
  explicit CCapture(CARGoSLog& log)
      : m_log(log), m_colored(log.IsColoredOutput()), m_buffer(log.GetStream().rdbuf()) {
    m_log.Flush();
    m_log.DisableColoredOutput();
    m_log.GetStream().rdbuf(m_text.rdbuf());
  }
  ~CCapture() {
    m_log.Flush();
    m_log.GetStream().rdbuf(m_buffer);
    if (m_colored) {
      m_log.EnableColoredOutput();
    }
  }
  std::string Text() {
    m_log.Flush();
    return m_text.str();
  }

 private:
  CARGoSLog& m_log;
  bool m_colored;
  std::streambuf* m_buffer;
  std::ostringstream m_text;
};

struct SOutcome {
  std::string Error;
  std::string Warnings;
};

SOutcome Try(const std::string& xml, bool run) {
  CCapture log(LOG);
  CCapture logErr(LOGERR);
  SOutcome outcome;
  CConfigurationDocument document;
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  try {
    document.Parse(xml, "test.argos");
    simulator.Load(document);
    if (run) {
      simulator.Execute();
    }
  } catch (const CARGoSException& ex) {
    outcome.Error = ex.what();
  }
  simulator.Destroy();
  outcome.Warnings = logErr.Text();
  return outcome;
}

}  // namespace

std::string SExperimentText::Controller(const std::string& label, const std::string& params,
                                        const std::string& sensors) {
  return "<" + label + " id=\"c\" library=\"" + BadControllersLibrary() +
         "\"><actuators><differential_steering implementation=\"default\"/></actuators>" + sensors +
         params + "</" + label + ">";
}

std::string SExperimentText::RobotAt(const std::string& id, const std::string& position) {
  return "<e-puck id=\"" + id + "\"><body position=\"" + position +
         "\"/><controller config=\"c\"/></e-puck>";
}

std::string SExperimentText::ToXml() const {
  return "<argos-configuration>\n" + Framework + '\n' + Controllers + '\n' + Engines + '\n' +
         Media + "\n<arena " + ArenaAttributes + ">" + Box + Robot + "</arena>\n" + Rest +
         "\n</argos-configuration>\n";
}

std::string BadControllersLibrary() {
  return InBuildTree("testing/plugins/libargos3_test_bad_controllers.so");
}

std::string OtherVersionLibrary() {
  return InBuildTree("testing/plugins/libargos3_test_wrong_build.so");
}

std::string LoadError(const SExperimentText& experiment) {
  return LoadErrorOfXml(experiment.ToXml());
}

std::string LoadErrorOfXml(const std::string& xml) {
  return Try(xml, false).Error;
}

std::string RunError(const SExperimentText& experiment) {
  return Try(experiment.ToXml(), true).Error;
}

std::string LoadWarnings(const SExperimentText& experiment) {
  return LoadWarningsOfXml(experiment.ToXml());
}

std::string LoadWarningsOfXml(const std::string& xml) {
  const SOutcome outcome = Try(xml, false);
  return outcome.Error.empty() ? outcome.Warnings : "loading failed: " + outcome.Error;
}

std::string At(int line) {
  return "test.argos:" + std::to_string(line) + ":";
}

}  // namespace argos
