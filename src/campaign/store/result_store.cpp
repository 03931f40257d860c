#include <argos3/campaign/store/result_store.h>

#include <argos3/campaign/store/result_schema.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/input_file.h>

#include <fmt/format.h>

#include <sys/stat.h>
#include <unistd.h>

namespace argos {

namespace {

constexpr const char* kInsertRun =
    "INSERT INTO runs(combination, seed, generation, attempt, status, exit_status, signal, "
    "start_up, wall, cpu, total_wall, memory, ticks, robots, digest, log, log_bytes, started, "
    "machine, version) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)";

// removes an earlier attempt. Returns its number; 0 if there is none
UInt32 RemoveRun(CDatabase& database, UInt32 generation, UInt32 combination, UInt32 seed) {
  SInt64 id = 0;
  UInt32 attempt = 0;
  {
    CQuery query(database,
                 "SELECT id, attempt FROM runs WHERE generation = ? AND combination = ? AND seed = "
                 "?");
    if (!query.Bind(generation).Bind(combination).Bind(seed).Step()) {
      return 0;
    }
    id = query.GetInteger(0);
    attempt = query.GetUInt32(1);
  }
  // metrics and series go with it
  CQuery(database, "DELETE FROM runs WHERE id = ?").Bind(id).Execute();
  return attempt;
}

void InsertMetrics(CDatabase& database, SInt64 run, const SRunResult& result) {
  CQuery insertMetric(database,
                      "INSERT OR REPLACE INTO metrics(run, name, unit, value) VALUES (?, ?, ?, ?)");
  for (const SMetricValue& metric : result.Metrics) {
    insertMetric.Bind(run).Bind(metric.Name).Bind(metric.Unit).Bind(metric.Value).Execute();
  }
  CQuery insertPoint(database,
                     "INSERT OR REPLACE INTO series(run, name, tick, value) VALUES (?, ?, ?, ?)");
  for (const SMetricSeries& series : result.Series) {
    for (size_t i = 0; i < series.Ticks.size(); ++i) {
      insertPoint.Bind(run)
          .Bind(series.Name)
          .Bind(series.Ticks[i])
          .Bind(series.Values[i])
          .Execute();
    }
  }
}

void SetJournal(CDatabase& database, bool isShared) {
  if (!isShared) {
    database.Execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
    return;
  }
  database.Execute("PRAGMA synchronous = FULL");
  CQuery query(database, "PRAGMA journal_mode = DELETE");
  if (!query.Step() || query.GetText(0) != "delete") {
    THROW_ARGOSEXCEPTION("the results file \""
                         << database.GetFile()
                         << "\" is open in another program, so that it cannot be prepared for use "
                            "by several computers: close that program");
  }
}

}  // namespace

CResultStore::CResultStore(const std::string& file, EMode mode)
    : m_database(std::make_unique<SDatabase>()) {
  m_database->Owner = getpid();
  if (mode == EMode::ReadOnly) {
    const std::string problem = FindInputProblem(file);
    if (!problem.empty()) {
      THROW_ARGOSEXCEPTION("the results file \"" << file << "\" cannot be read: " << problem
                                                 << "; argos3-campaign run FILE creates it");
    }
    m_database->File = std::make_unique<CDatabase>(file, CDatabase::EAccess::ReadOnly);
    CheckSchema(*m_database->File);
    return;
  }
  m_database->Lock = std::make_unique<CStoreLock>(file);
  m_database->File = std::make_unique<CDatabase>(file, CDatabase::EAccess::Write);
  CDatabase& database = *m_database->File;
  const bool isNew = IsEmptyDatabase(database);
  if (!isNew) {
    CheckSchema(database);
  }
  SetJournal(database, mode == EMode::WriteShared);
  database.Execute("PRAGMA foreign_keys = ON");
  if (isNew) {
    CTransaction transaction(database);
    CreateSchema(database);
    transaction.Commit();
  }
  struct stat status {};
  if (stat(file.c_str(), &status) == 0) {
    m_database->Device = status.st_dev;
    m_database->Inode = status.st_ino;
  }
  CQuery query(database, "SELECT is_series, name FROM collected");
  while (query.Step()) {
    m_database->Collected.emplace(query.GetInteger(0) != 0, query.GetText(1));
  }
}

CResultStore::~CResultStore() {
  // a forked process has a copy, but neither the lock nor the right to close the database
  if (m_database != nullptr && m_database->Owner != getpid()) {
    static_cast<void>(m_database.release());
  }
}

void CResultStore::ThrowIfRemoved() const {
  const std::string& file = m_database->File->GetFile();
  struct stat status {};
  const bool isThere = stat(file.c_str(), &status) == 0;
  if (!isThere || status.st_dev != m_database->Device || status.st_ino != m_database->Inode) {
    THROW_ARGOSEXCEPTION("the results file \""
                         << file << "\" was " << (isThere ? "replaced" : "removed or renamed")
                         << " while the campaign was running: results that are not in it are lost, "
                            "and missing at the next run");
  }
}

bool CResultStore::IsStored(const std::string& combinationKey, UInt32 seed) const {
  CQuery query(
      *m_database->File,
      "SELECT 1 FROM runs r JOIN combinations c ON c.id = r.combination WHERE r.generation "
      "= (SELECT max(id) FROM generations) AND c.key = ? AND r.seed = ?");
  return query.Bind(combinationKey).Bind(seed).Step();
}

UInt32 CResultStore::GetCombinationId(const std::string& combinationKey) const {
  CQuery query(*m_database->File, "SELECT id FROM combinations WHERE key = ?");
  if (!query.Bind(combinationKey).Step()) {
    THROW_ARGOSEXCEPTION("the results file \"" << m_database->File->GetFile()
                                               << "\" has no combination with the values\n"
                                               << combinationKey);
  }
  return query.GetUInt32(0);
}

void CResultStore::Add(const std::vector<SStoredRun>& runs) {
  ThrowIfRemoved();
  CDatabase& database = *m_database->File;
  const auto collected = m_database->Collected;
  CTransaction transaction(database);
  const auto generation =
      static_cast<UInt32>(database.QueryNumber("SELECT max(id) FROM generations"));
  try {
    bool hasNewMetric = false;
    const auto noteName = [&](bool isSeries, const std::string& name, const std::string& unit) {
      if (m_database->Collected.emplace(isSeries, name).second) {
        CQuery(database, "INSERT INTO collected(is_series, name, unit) VALUES (?, ?, ?)")
            .Bind(isSeries ? 1 : 0)
            .Bind(name)
            .Bind(unit)
            .Execute();
        hasNewMetric = hasNewMetric || !isSeries;
      }
    };
    for (const SStoredRun& run : runs) {
      const SRunResult& result = run.Result;
      if (result.Status == ERunStatus::Interrupted) {
        continue;
      }
      const UInt32 attempt = RemoveRun(database, generation, run.Combination, run.Seed) + 1;
      CQuery insert(database, kInsertRun);
      insert.Bind(run.Combination).Bind(run.Seed).Bind(generation).Bind(attempt);
      insert.Bind(std::string(ToText(result.Status))).Bind(result.ExitStatus).Bind(result.Signal);
      insert.Bind(result.StartUpTime).Bind(result.WallTime).Bind(result.CPUTime);
      insert.Bind(result.TotalWallTime).Bind(result.PeakMemory).Bind(result.Ticks);
      insert.Bind(result.Robots).Bind(fmt::format("{:016x}", result.Digest)).Bind(result.Log);
      insert.Bind(result.LogBytes).Bind(run.Started).Bind(run.Machine).Bind(run.Version).Execute();
      InsertMetrics(database, database.GetLastRowId(), result);
      for (const SMetricValue& metric : result.Metrics) {
        noteName(false, metric.Name, metric.Unit);
      }
      for (const SMetricSeries& series : result.Series) {
        noteName(true, series.Name, series.Unit);
      }
    }
    if (hasNewMetric) {
      CreateResultsView(database);
    }
    transaction.Commit();
  } catch (...) {
    m_database->Collected = collected;
    throw;
  }
}

}  // namespace argos
