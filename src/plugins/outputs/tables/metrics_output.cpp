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
#include <optional>
#include <vector>

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

  void Observe(CSimulator& simulator) override {
    if (IsWanted(simulator)) {
      AppendPending(simulator);
      Keep(simulator);
    }
  }

  // PostExperiment() may have recorded results, or replaced those of the last tick
  void Finish(CSimulator& simulator) override {
    const UInt32 tick = simulator.GetSpace().GetSimulationClock();
    if (m_pending && m_pending->Tick.Tick != tick && simulator.GetMetrics().HasLateRecords()) {
      AppendPending(simulator);
      Keep(simulator);
    } else if (m_pending && m_pending->Tick.Tick == tick) {
      Keep(simulator);
    }
    AppendPending(simulator);
    CTableBase::Finish(simulator);
  }

  // the row of the last tick is still missing after an error
  void Destroy() override {
    try {
      AppendPending(CurrentSimulator());
    } catch (...) {
      CTableBase::Destroy();
      throw;
    }
    CTableBase::Destroy();
  }

 private:
  /* The row of the last tick, which waits: code may record results when the tick is over. */
  struct SRow {
    SRowBlock::STick Tick;
    std::vector<double> Numbers;
  };

  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  void Keep(CSimulator& simulator) {
    if (!m_pending) {
      m_pending.emplace();
    }
    m_pending->Tick = MakeTick(simulator);
    std::vector<double>& numbers = m_pending->Numbers;
    const auto& robots = simulator.GetSpace().GetControllableEntities();
    numbers.assign(1, static_cast<double>(robots.size()));
    numbers.push_back(
        static_cast<double>(std::ranges::count_if(robots, &CControllableEntity::IsStopped)));
    for (const CMetrics::SMetric& metric : simulator.GetMetrics().GetAll()) {
      numbers.push_back(metric.Value);
    }
  }

  void AppendPending(CSimulator& simulator) {
    if (m_pending) {
      AppendTick(simulator, m_pending->Tick);
      m_pending.reset();
    }
  }

  // metrics that are recorded for the first time later on get columns then
  bool Update(CSimulator& simulator) override {
    const std::vector<CMetrics::SMetric>& metrics = simulator.GetMetrics().GetAll();
    const bool isFirst = m_columns.empty();
    if (isFirst) {
      m_columns = {{"robots", ""}, {"stopped", ""}};
    }
    std::vector<SColumn> added;
    for (std::size_t i = m_columns.size() - kNumOwn; i < metrics.size(); ++i) {
      added.push_back({metrics[i].Name, metrics[i].Unit});
    }
    m_columns.insert(m_columns.end(), added.begin(), added.end());
    if (!isFirst && !added.empty()) {
      AddColumns(added);
    }
    return true;
  }

  void Describe(STableSchema& schema) const override {
    schema.HasRobots = false;
    schema.AddColumns(m_columns);
  }

  std::size_t Read(CSimulator& /*simulator*/, SRowBlock& block) override {
    std::vector<double>& numbers = m_pending->Numbers;
    numbers.resize(m_columns.size(), kNone);
    block.Numbers.insert(block.Numbers.end(), numbers.begin(), numbers.end());
    ++block.NumRows;
    return 1;
  }

  const char* ExplainEmptyTable() const override { return "there was no tick"; }

  static constexpr std::size_t kNumOwn = 2;  // robots, stopped

  std::vector<SColumn> m_columns;
  std::optional<SRow> m_pending;
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
errors have stopped), and the metrics in the order in which they were first recorded; rows before
that are empty there. The row of the last tick has what PostExperiment() records, which replaces what
was recorded in the tick; that row is written even if "every" would leave it out.
)",
    "Usable")

}  // namespace argos
