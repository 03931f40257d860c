// Outputs of a run: what is called when, and which children of <visualization> and <outputs> there
// may be.

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/outputs/run_outputs.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/forked.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace argos::run_outputs_test {

namespace {

using Catch::Matchers::Contains;

// what the outputs of the running test were told, in order
std::vector<std::string> calls;

class CTestOutput : public CRunOutput {
 public:
  void Init(TConfigurationNode& tree) override {
    GetNodeAttributeOrDefault(tree, "name", m_name, m_name);
    GetNodeAttributeOrDefault(tree, "fail_at", m_failAt, m_failAt);
  }
  void Reset() override { Tell("reset"); }
  void Destroy() override { Tell("destroy"); }
  void Observe(CSimulator& simulator) override {
    const UInt32 tick = simulator.GetSpace().GetSimulationClock();
    Tell("tick " + std::to_string(tick));
    if (static_cast<SInt32>(tick) == m_failAt) {
      THROW_ARGOSEXCEPTION("the output fails");
    }
  }
  void Finish(CSimulator& simulator) override {
    Tell("finish at " + std::to_string(simulator.GetSpace().GetSimulationClock()));
  }

 private:
  void Tell(const std::string& what) { calls.push_back(m_name + ": " + what); }

  std::string m_name = "a";
  SInt32 m_failAt = -1;
};

REGISTER_RUN_OUTPUT(CTestOutput, "test_output", "a test", "1.0", "Tells.", "Tells.", "Usable")

// runs the loop itself, two ticks
class CTestLoop : public CVisualization {
 public:
  void Execute() override {
    m_cSimulator.UpdateSpace();
    m_cSimulator.UpdateSpace();
  }
  void Destroy() override { calls.emplace_back("loop: destroy"); }
};

REGISTER_VISUALIZATION(CTestLoop, "test_loop", "a test", "1.0", "Loops.", "Loops.", "Usable")

// resets the experiment in PostStep() of the second tick, once
class CResettingFunctions : public CLoopFunctions {
 public:
  void PostStep() override {
    if (GetSpace().GetSimulationClock() == 2 && !m_hasReset) {
      m_hasReset = true;
      CSimulator::GetInstance().Reset();
    }
    calls.push_back("post step");
  }
  void PostExperiment() override { calls.push_back("post experiment"); }

 private:
  bool m_hasReset = false;
};

REGISTER_LOOP_FUNCTIONS(CResettingFunctions, "resetting_functions")

// three ticks; sections: added to the root element
class CObservedRun {
 public:
  explicit CObservedRun(const std::string& sections, const std::string& loopFunctions = "",
                        const std::function<void(CSimulator&)>& prepare = {})
      : m_scope(m_simulator) {
    calls.clear();
    SExperiment experiment;
    experiment.Length = 0.3;
    experiment.LoopFunctions = loopFunctions;
    std::string xml = experiment.ToXml();
    const std::string end = "</argos-configuration>";
    xml.insert(xml.rfind(end), sections);
    m_document.Parse(xml, "run.argos");
    if (prepare) {
      prepare(m_simulator);
    }
    m_simulator.Load(m_document);
  }
  CSimulator& GetSimulator() { return m_simulator; }

 private:
  CConfigurationDocument m_document;
  CSimulator m_simulator;
  CSimulator::CScope m_scope;
};

typedef std::vector<std::string> TCalls;

const std::string kOutput = "<outputs><test_output/></outputs>";

}  // namespace

TEST_CASE("outputs: they see the first state and each tick, and the end of Execute()",
          "[core][outputs]") {
  {
    CObservedRun run(kOutput);
    run.GetSimulator().Execute();
    CHECK(calls == TCalls{"a: tick 0", "a: tick 1", "a: tick 2", "a: tick 3", "a: finish at 3"});
  }
  CHECK(calls.size() == 6);
  CHECK(calls.back() == "a: destroy");
}

TEST_CASE("outputs: a program that steps the simulator itself ends the run by Destroy()",
          "[core][outputs]") {
  CObservedRun run(kOutput);
  run.GetSimulator().UpdateSpace();
  run.GetSimulator().UpdateSpace();
  run.GetSimulator().Destroy();
  CHECK(calls == TCalls{"a: tick 0", "a: tick 1", "a: tick 2", "a: finish at 2", "a: destroy"});
}

TEST_CASE("outputs: a reset ends one run and begins another", "[core][outputs]") {
  CObservedRun run(kOutput);
  run.GetSimulator().UpdateSpace();
  run.GetSimulator().Reset();
  run.GetSimulator().Execute();
  CHECK(calls == TCalls{"a: tick 0", "a: tick 1", "a: finish at 1", "a: reset", "a: tick 0",
                        "a: tick 1", "a: tick 2", "a: tick 3", "a: finish at 3"});
  run.GetSimulator().Reset();
  CHECK(calls.back() == "a: reset");
}

TEST_CASE("outputs: a reset inside of a tick ends a run with that tick, and begins another",
          "[core][outputs]") {
  CObservedRun run(kOutput, "<loop_functions label='resetting_functions'/>");
  run.GetSimulator().UpdateSpace();
  run.GetSimulator().UpdateSpace();
  CHECK(calls == TCalls{"a: tick 0", "post step", "a: tick 1", "a: tick 2", "a: finish at 2",
                        "a: reset", "post step", "a: tick 0"});
}

TEST_CASE("outputs: a reset of the space alone, and a clock that goes back, begin another run",
          "[core][outputs]") {
  CObservedRun run(kOutput);
  run.GetSimulator().UpdateSpace();
  run.GetSimulator().UpdateSpace();
  run.GetSimulator().GetSpace().Reset();
  // of a run that has ended
  run.GetSimulator().GetSpace().Reset();
  run.GetSimulator().UpdateSpace();
  CHECK(calls == TCalls{"a: tick 0", "a: tick 1", "a: tick 2", "a: finish at 2", "a: reset",
                        "a: tick 0", "a: tick 1"});
  calls.clear();
  run.GetSimulator().GetSpace().SetSimulationClock(0);
  run.GetSimulator().UpdateSpace();
  CHECK(calls == TCalls{"a: finish at 0", "a: reset", "a: tick 0", "a: tick 1"});
}

TEST_CASE("outputs: the run is finished after PostExperiment()", "[core][outputs]") {
  CObservedRun run(kOutput, "<loop_functions label='resetting_functions'/>");
  run.GetSimulator().Execute();
  REQUIRE(calls.size() > 2);
  CHECK(calls[calls.size() - 2] == "post experiment");
  CHECK(calls.back() == "a: finish at 3");
}

TEST_CASE("outputs: one that fails ends the run; none is called again but for its destruction",
          "[core][outputs]") {
  {
    CObservedRun run(
        "<outputs><test_output name='good'/><test_output name='bad' fail_at='1'/></outputs>");
    CHECK_THROWS_WITH(run.GetSimulator().Execute(), Contains("the output fails"));
  }
  CHECK(calls == TCalls{"good: tick 0", "bad: tick 0", "good: tick 1", "bad: tick 1",
                        "bad: destroy", "good: destroy"});
}

TEST_CASE("outputs: several views and one loop may be children of <visualization>",
          "[core][outputs]") {
  CObservedRun run(
      "<visualization><test_output name='b'/><test_loop/><test_output name='c'/></visualization>" +
      kOutput);
  run.GetSimulator().Execute();
  CHECK(calls == TCalls{"b: tick 0", "c: tick 0", "a: tick 0", "b: tick 1", "c: tick 1",
                        "a: tick 1", "b: tick 2", "c: tick 2", "a: tick 2", "b: finish at 2",
                        "c: finish at 2", "a: finish at 2"});
}

TEST_CASE("outputs: the loop is destroyed after them", "[core][outputs]") {
  {
    CObservedRun run("<visualization><test_loop/></visualization>" + kOutput);
    calls.clear();
  }
  CHECK(calls == TCalls{"a: destroy", "loop: destroy"});
}

TEST_CASE("outputs: two visualizations that run the loop are an error", "[core][outputs]") {
  CHECK_THROWS_WITH(CObservedRun("<visualization><test_loop/>\n<test_loop/></visualization>"),
                    Contains("<test_loop> runs the experiment itself") && Contains("run.argos:"));
}

TEST_CASE("outputs: an unknown one is an error with the nearest names", "[core][outputs]") {
  CHECK_THROWS_WITH(CObservedRun("<outputs><test_outpt/></outputs>"),
                    Contains("run.argos:") && Contains("there is no output of type <test_outpt>") &&
                        Contains("test_output"));
}

TEST_CASE("outputs: without visualization, those of <outputs> remain", "[core][outputs]") {
  CConfigurationDocument document;
  std::string xml = SExperiment{.Length = 0.1}.ToXml();
  xml.insert(xml.rfind("</argos-configuration>"),
             "<visualization><test_output name='view'/></visualization>" + kOutput);
  document.Parse(xml, "run.argos");
  CSimulator simulator;
  const CSimulator::CScope scope(simulator);
  calls.clear();
  simulator.Load(document, true);
  simulator.Execute();
  CHECK(calls == TCalls{"a: tick 0", "a: tick 1", "a: finish at 1"});
}

TEST_CASE("outputs: a program adds them, and overrides reach them", "[core][outputs]") {
  CObservedRun run("", "", [](CSimulator& simulator) {
    simulator.AddOutput("test_output", {{"name", "x"}});
    simulator.AddOverride("outputs/test_output/@name", "y");
  });
  run.GetSimulator().UpdateSpace();
  CHECK(calls == TCalls{"y: tick 0", "y: tick 1"});
  CHECK(run.GetSimulator().GetOutputs().GetSeconds() > 0.0);
}

TEST_CASE("outputs: an error in the attributes of an added one names the option's element",
          "[core][outputs]") {
  CHECK_THROWS_WITH(CObservedRun("", "",
                                 [](CSimulator& simulator) {
                                   simulator.AddOutput("test_output", {{"fail_at", "never"}});
                                 }),
                    Contains("<test_output>") && Contains("never"));
}

TEST_CASE("outputs: those of a run that has begun remain with the process that called fork()",
          "[core][outputs]") {
  CObservedRun run(kOutput);
  CSimulator& simulator = run.GetSimulator();
  simulator.UpdateSpace();
  const TCalls before = calls;
  const auto goOn = [&] {
    simulator.UpdateSpace();
    simulator.Reset();
    simulator.UpdateSpace();
    simulator.Destroy();
    const bool isWarned = TakeLogErr().find("[WARNING] fork() was called") != std::string::npos;
    return isWarned && calls == before ? 0 : 1;
  };
  CHECK(CallInFork(goOn) == 0);
  simulator.UpdateSpace();
  CHECK(calls.size() == before.size() + 1);
}

}  // namespace argos::run_outputs_test
