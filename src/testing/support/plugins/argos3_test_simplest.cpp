// The simplest plug-in of each kind in "To add something" of doc/internals/contributing.md that has
// no example of its own: nothing but what a table row there names is needed.

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/space/built_in_metric.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/plugins/plugin_kind.h>

#include <iostream>
#include <memory>
#include <string>

namespace argos {

namespace {

/* Accepts every body, and moves none. */
class CSimplestEngine : public CDescribedBodyEngine {
 protected:
  void UpdateWorld() override {
    ListModelsForWorld();
    m_hasWorld = true;
  }
  void DropWorld() override { m_hasWorld = false; }
  bool HasWorld() const override { return m_hasWorld; }
  bool Accepts(const CEmbodiedEntity&) const override { return true; }
  void CheckBody(CEmbodiedEntity&) const override {}
  std::unique_ptr<CDescribedBodyModel> CreateModel(CEmbodiedEntity& body,
                                                   const CRecordedBody*) override {
    return std::make_unique<CDescribedBodyModel>(*this, body);
  }
  void Enter(CDescribedBodyModel&) override {}
  void Leave(CDescribedBodyModel&) override {}
  void Reposition(CDescribedBodyModel&) override {}

 private:
  bool m_hasWorld = false;
};

class CSimplestMedium : public CMedium {
 public:
  void Update() override {}
};

/* Prints the number of states that it has seen. */
class CSimplestOutput : public CRunOutput {
 public:
  void Observe(CSimulator&) override { ++m_numStates; }
  void Finish(CSimulator&) override { std::cout << "states: " << m_numStates << '\n'; }

 private:
  int m_numStates = 0;
};

/* A column of sevens. */
class CSimplestField : public CField {
 public:
  SBoundField Bind(CEntity&, const std::string&) const override {
    return {std::make_unique<CReader>(), {{"simplest_column", "m"}}};
  }

 private:
  class CReader : public CFieldReader {
   public:
    void Read(std::size_t, SFieldRow row) override { row.Numbers[0] = 7.0; }
  };
};

/* The tick. */
class CSimplestMetric : public CBuiltInMetric {
 public:
  void Init(CSpace& space) override { m_space = &space; }
  Real Compute() override { return m_space->GetSimulationClock(); }

 private:
  CSpace* m_space = nullptr;
};

class CSimplestView : public CVisualization {
 public:
  void Execute() override {
    while (!m_cSimulator.IsExperimentFinished()) {
      m_cSimulator.UpdateSpace();
    }
    std::cout << "view\n";
  }
};

const CElementText kElement("test_simplest_element", "A. Author", "An element.",
                            "An example:\n\n  <test_simplest_element size=\"1\" />\n\n"
                            "  size  m, default 1.\n");

}  // namespace

REGISTER_PHYSICS_ENGINE(CSimplestEngine, "test_simplest_engine", "A. Author", "1.0", "An engine.",
                        "About it.\n", "Usable")
REGISTER_MEDIUM(CSimplestMedium, "test_simplest_medium", "A. Author", "1.0", "A medium.",
                "About it.\n", "Usable")
REGISTER_RUN_OUTPUT(CSimplestOutput, "test_simplest_output", "A. Author", "1.0", "An output.",
                    "About it.\n", "Usable")
REGISTER_FIELD(CSimplestField, "test_simplest_field", "A. Author", "1.0", "A field.", "About it.\n",
               "Usable")
REGISTER_BUILT_IN_METRIC(CSimplestMetric, "test_simplest_metric", "A. Author", "1.0", "A metric.",
                         "About it.\n", "Usable")
REGISTER_VISUALIZATION(CSimplestView, "test_simplest_view", "A. Author", "1.0", "A view.",
                       "About it.\n", "Usable")

}  // namespace argos
