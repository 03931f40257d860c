#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/plugins/simulator/outputs/tables/entity_rows.h>
#include <argos3/plugins/simulator/outputs/tables/table_base.h>

#include <algorithm>
#include <limits>

namespace argos {

/* <metrics>: the metrics of the run, a row for each tick. */
class CMetricsOutput : public CTableBase {
 public:
  void Init(TConfigurationNode& tree) override {
    CTableBase::Init(tree);
    std::string builtIns;
    GetNodeAttributeOrDefault(tree, "builtin", builtIns, builtIns);
    try {
      for (const std::string& name : SplitAtCommas(builtIns)) {
        CurrentSimulator().GetMetrics().EnableBuiltIn(name);
      }
    } catch (std::exception& error) {
      THROW_ARGOSEXCEPTION_NESTED(GetLocation() << ": \"builtin\"", error);
    }
  }

 private:
  static constexpr std::size_t kNumOwn = 2;  // robots, stopped
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  // the first row waits for the second: by then code has recorded what it records in each tick
  bool Update(CSimulator& simulator, SRowBlock& block, bool isLast) override {
    const CMetrics& metrics = simulator.GetMetrics();
    if (!m_areColumnsKnown && block.NumRows == 0 && !isLast) {
      return false;
    }
    if (!m_areColumnsKnown) {
      m_areColumnsKnown = true;
      m_columns = {{"robots", ""}, {"stopped", ""}};
      for (const CMetrics::SMetric& metric : metrics.GetAll()) {
        m_columns.push_back({metric.Name, metric.Unit});
      }
      m_numReported = metrics.GetAll().size();
      block.Numbers.resize(block.NumRows * m_columns.size(), kNone);
    }
    for (; m_numReported < metrics.GetAll().size(); ++m_numReported) {
      const std::string& name = metrics.GetAll()[m_numReported].Name;
      LOGERR << "[WARNING] " << GetLocation() << ": the metric \"" << name
             << "\" was first recorded in tick " << simulator.GetSpace().GetSimulationClock()
             << ", when the table had begun: it is left out. Record it in Init() or in the first "
                "tick, "
                "to any value"
             << std::endl;
    }
    return true;
  }

  void Describe(STableSchema& schema) const override {
    schema.HasRobots = false;
    schema.Columns = m_columns;
    schema.NumNumbers = m_columns.size();
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
      schema.Places.push_back(i);
    }
  }

  std::size_t Read(CSimulator& simulator, SRowBlock& block) override {
    CSpace& space = simulator.GetSpace();
    const auto& robots = space.GetControllableEntities();
    block.Numbers.push_back(static_cast<double>(robots.size()));
    block.Numbers.push_back(static_cast<double>(
        std::count_if(robots.begin(), robots.end(),
                      [](const CControllableEntity* robot) { return robot->IsStopped(); })));
    const std::vector<CMetrics::SMetric>& metrics = simulator.GetMetrics().GetAll();
    const std::size_t numMetrics = m_areColumnsKnown ? m_columns.size() - kNumOwn : metrics.size();
    for (std::size_t i = 0; i < numMetrics; ++i) {
      block.Numbers.push_back(metrics[i].Value);
    }
    ++block.NumRows;
    return 1;
  }

  const char* ExplainEmptyTable() const override { return "there was no tick"; }

  bool m_areColumnsKnown = false;
  std::vector<SColumn> m_columns;
  std::size_t m_numReported = 0;  // metrics that are columns, or were reported
};

REGISTER_RUN_OUTPUT(
    CMetricsOutput, "metrics", "the authors of this project", "1.0",
    "A table of the metrics that robots and loop functions record, and of built-in ones.",
    R"(Writes a row for each tick. Robots and loop functions record metrics with GetMetrics().Record() (C++) or
metrics.record() (Lua); doc/get_data_out.md has examples. `argos3 -q built_in_metrics` lists those
that need no code.

REQUIRED XML

  <outputs>
    <metrics file="metrics.csv" />
  </outputs>

  file    as for <table>: ends in .csv, .csv.gz or .h5.

OPTIONAL XML

  <metrics file="metrics.csv" every="10" digits="6" builtin="dispersion, collisions" />

  builtin  names of built-in metrics, separated by commas: they are computed in this run, and recordings
           have them, too. By default none.
  every    whole number >= 1, default 1: rows of the ticks 0, every, 2 every, ...
  digits   from 1 to 17: significant digits of numbers in texts. Default: as many as needed.

Columns: run (the number of resets before), tick, time (s), robots (in the arena), stopped (those that
errors have stopped), and the metrics in the order in which they were first recorded. A metric is a
column if it was recorded before the second row is written.
)",
    "Usable")

}  // namespace argos
