#include <argos3/campaign/store/result_schema.h>
#include <argos3/campaign/store/result_store.h>

#include <cstdlib>

namespace argos {

namespace {

#define NEWEST_GENERATION "(SELECT max(id) FROM generations)"

constexpr const char* kRunColumns =
    "SELECT id, combination, seed, generation, attempt, status, exit_status, signal, start_up, "
    "wall, cpu, total_wall, memory, ticks, robots, digest, log_bytes, started, machine, version, "
    "log FROM runs ";
constexpr int kLogColumn = 20;

SStoredRun ReadRun(const CQuery& query) {
  SStoredRun run;
  run.Id = static_cast<UInt64>(query.GetInteger(0));
  run.Combination = query.GetUInt32(1);
  run.Seed = query.GetUInt32(2);
  run.Generation = query.GetUInt32(3);
  run.Attempt = query.GetUInt32(4);
  run.Result.Status = ToRunStatus(query.GetText(5));
  run.Result.ExitStatus = static_cast<int>(query.GetInteger(6));
  run.Result.Signal = static_cast<int>(query.GetInteger(7));
  run.Result.StartUpTime = query.GetReal(8);
  run.Result.WallTime = query.GetReal(9);
  run.Result.CPUTime = query.GetReal(10);
  run.Result.TotalWallTime = query.GetReal(11);
  run.Result.PeakMemory = static_cast<UInt64>(query.GetInteger(12));
  run.Result.Ticks = query.GetUInt32(13);
  run.Result.Robots = query.GetUInt32(14);
  run.Result.Digest = std::strtoull(query.GetText(15).c_str(), nullptr, 16);
  run.Result.LogBytes = static_cast<UInt64>(query.GetInteger(16));
  run.Started = query.GetText(17);
  run.Machine = query.GetText(18);
  run.Version = query.GetText(19);
  return run;
}

std::vector<std::string> ListCollected(CDatabase& database, bool isSeries) {
  std::vector<std::string> names;
  CQuery query(database, "SELECT name FROM collected WHERE is_series = ? ORDER BY id");
  query.Bind(isSeries ? 1 : 0);
  while (query.Step()) {
    names.push_back(query.GetText(0));
  }
  return names;
}

}  // namespace

std::vector<std::string> CResultStore::ListFactors() const {
  std::vector<std::string> names;
  CQuery query(*m_database->File, "SELECT name FROM factors ORDER BY id");
  while (query.Step()) {
    names.push_back(query.GetText(0));
  }
  return names;
}

std::vector<SStoredCombination> CResultStore::ListCombinations() const {
  std::vector<SStoredCombination> combinations;
  // those that the campaign file does not have any more come last
  CQuery query(*m_database->File,
               "SELECT id, key FROM combinations ORDER BY number IS NULL, number, id");
  while (query.Step()) {
    SStoredCombination& combination = combinations.emplace_back();
    combination.Id = query.GetUInt32(0);
    combination.Key = query.GetText(1);
    CQuery values(*m_database->File,
                  "SELECT value FROM combination_values WHERE combination = ? ORDER BY factor");
    values.Bind(combination.Id);
    while (values.Step()) {
      combination.Values.push_back(values.GetText(0));
    }
  }
  return combinations;
}

std::vector<SStoredRun> CResultStore::ListRuns() const {
  std::vector<SStoredRun> runs;
  CQuery query(*m_database->File, std::string(kRunColumns) + "WHERE generation = " NEWEST_GENERATION
                                                             " ORDER BY combination, seed");
  while (query.Step()) {
    runs.push_back(ReadRun(query));
  }
  return runs;
}

std::optional<SStoredRun> CResultStore::FindRun(UInt64 id) const {
  CQuery query(*m_database->File, std::string(kRunColumns) + "WHERE id = ?");
  if (!query.Bind(id).Step()) {
    return std::nullopt;
  }
  SStoredRun run = ReadRun(query);
  run.Result.Log = query.GetText(kLogColumn);
  CQuery metrics(
      *m_database->File,
      "SELECT m.name, m.unit, m.value FROM metrics m JOIN collected c ON c.name = m.name "
      "AND c.is_series = 0 WHERE m.run = ? ORDER BY c.id");
  metrics.Bind(id);
  while (metrics.Step()) {
    run.Result.Metrics.push_back({metrics.GetText(0), metrics.GetText(1), metrics.GetReal(2)});
  }
  return run;
}

std::vector<std::string> CResultStore::ListMetrics() const {
  return ListCollected(*m_database->File, false);
}

std::vector<std::string> CResultStore::ListSeries() const {
  return ListCollected(*m_database->File, true);
}

std::vector<CResultStore::SValue> CResultStore::ReadMetric(const std::string& name) const {
  std::vector<SValue> values;
  CQuery query(*m_database->File,
               "SELECT r.combination, r.seed, m.value FROM runs r LEFT JOIN metrics m ON m.run = "
               "r.id AND m.name = ? WHERE r.generation = " NEWEST_GENERATION
               " AND r.status IN ('done', 'robots_stopped') ORDER BY r.combination, r.seed");
  query.Bind(name);
  while (query.Step()) {
    values.push_back({query.GetUInt32(0), query.GetUInt32(1), query.GetReal(2)});
  }
  return values;
}

void CResultStore::ForEachPoint(const std::string& name,
                                const std::function<void(UInt32 combination, UInt32 seed,
                                                         UInt32 tick, Real value)>& use) const {
  CQuery query(
      *m_database->File,
      "SELECT r.combination, r.seed, s.tick, s.value FROM runs r CROSS JOIN series s ON "
      "s.run = r.id AND s.name = ? WHERE r.generation = " NEWEST_GENERATION
      " AND r.status IN ('done', 'robots_stopped') ORDER BY r.combination, r.seed, s.tick");
  query.Bind(name);
  while (query.Step()) {
    use(query.GetUInt32(0), query.GetUInt32(1), query.GetUInt32(2), query.GetReal(3));
  }
}

std::vector<CResultStore::SSeriesOfRun> CResultStore::ReadSeries(const std::string& name) const {
  const std::string unit = GetUnit(name, true);
  std::vector<SSeriesOfRun> all;
  ForEachPoint(name, [&](UInt32 combination, UInt32 seed, UInt32 tick, Real value) {
    if (all.empty() || all.back().Combination != combination || all.back().Seed != seed) {
      all.push_back({combination, seed, {name, unit, {}, {}}});
    }
    all.back().Series.Ticks.push_back(tick);
    all.back().Series.Values.push_back(value);
  });
  return all;
}

std::string CResultStore::GetUnit(const std::string& name, bool isSeries) const {
  CQuery query(*m_database->File, "SELECT unit FROM collected WHERE name = ? AND is_series = ?");
  return query.Bind(name).Bind(isSeries ? 1 : 0).Step() ? query.GetText(0) : "";
}

std::string CResultStore::GetText(const std::string& key) const {
  CQuery query(*m_database->File, "SELECT value FROM campaign WHERE key = ?");
  return query.Bind(key).Step() ? query.GetText(0) : "";
}

UInt64 CResultStore::CountOlderRuns() const {
  return static_cast<UInt64>(m_database->File->QueryNumber(
      "SELECT count(*) FROM runs WHERE generation < " NEWEST_GENERATION));
}

}  // namespace argos
