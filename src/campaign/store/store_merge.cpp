#include <argos3/campaign/store/result_schema.h>
#include <argos3/campaign/store/result_store.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <map>

namespace argos {

namespace {

// matches them by digest of the experiment
std::map<SInt64, SInt64> MatchGenerations(CDatabase& own, CDatabase& other) {
  const bool isNew = own.QueryNumber("SELECT count(*) FROM generations") == 0;
  std::map<SInt64, SInt64> matches;
  CQuery query(other,
               "SELECT id, digest, experiment, libraries, started FROM generations ORDER BY id");
  while (query.Step()) {
    if (isNew) {
      CQuery(own,
             "INSERT INTO generations(digest, experiment, libraries, started) VALUES (?, ?, ?, ?)")
          .Bind(query.GetText(1))
          .Bind(query.GetText(2))
          .Bind(query.GetText(3))
          .Bind(query.GetText(4))
          .Execute();
    }
    // an experiment that came back has several generations; the newest counts
    CQuery find(own, "SELECT max(id) FROM generations WHERE digest = ?");
    if (find.Bind(query.GetText(1)).Step() && !find.IsNull(0)) {
      matches[query.GetInteger(0)] = find.GetInteger(0);
    }
  }
  const SInt64 newest = other.QueryNumber("SELECT max(id) FROM generations");
  if (matches.count(newest) == 0) {
    THROW_ARGOSEXCEPTION("\"" << other.GetFile() << "\" has results of another experiment than \""
                              << own.GetFile() << "\": they cannot be merged");
  }
  return matches;
}

void MatchFactors(CDatabase& own, const CResultStore& ownStore, const CResultStore& otherStore,
                  const std::string& otherFile) {
  const std::vector<std::string> names = otherStore.ListFactors();
  if (own.QueryNumber("SELECT count(*) FROM generations") == 0) {
    for (const std::string& name : names) {
      CQuery(own, "INSERT INTO factors(name) VALUES (?)").Bind(name).Execute();
    }
  } else if (names != ownStore.ListFactors()) {
    THROW_ARGOSEXCEPTION("\"" << otherFile << "\" has results of other factors than \""
                              << own.GetFile() << "\": they cannot be merged");
  }
}

SInt64 FindCombination(CDatabase& own, const std::string& key) {
  CQuery query(own, "SELECT id FROM combinations WHERE key = ?");
  return query.Bind(key).Step() ? query.GetInteger(0) : 0;
}

std::map<SInt64, SInt64> MatchCombinations(CDatabase& own, CDatabase& other) {
  std::map<SInt64, SInt64> matches;
  CQuery query(other, "SELECT id, key, number FROM combinations ORDER BY id");
  while (query.Step()) {
    const SInt64 otherId = query.GetInteger(0);
    SInt64& id = matches[otherId];
    id = FindCombination(own, query.GetText(1));
    if (id != 0) {
      continue;
    }
    // its number is that of the other's campaign file
    CQuery(own, "INSERT INTO combinations(key, number) VALUES (?, nullif(?, 0))")
        .Bind(query.GetText(1))
        .Bind(query.GetInteger(2))
        .Execute();
    id = own.GetLastRowId();
    CQuery values(other, "SELECT factor, value FROM combination_values WHERE combination = ?");
    values.Bind(otherId);
    while (values.Step()) {
      CQuery(
          own,
          "INSERT INTO combination_values(combination, factor, value, level) VALUES (?, ?, ?, ?)")
          .Bind(id)
          .Bind(values.GetInteger(0))
          .Bind(values.GetText(1))
          .Bind(values.GetText(1))
          .Execute();
    }
  }
  return matches;
}

bool IsDone(const std::string& status) {
  return status == "done" || status == "robots_stopped";
}

// true if the run is to be copied; removes one that it replaces
bool MakeRoomFor(CDatabase& own, SInt64 generation, SInt64 combination, SInt64 seed,
                 const std::string& status) {
  SInt64 id = 0;
  {
    CQuery query(own,
                 "SELECT id, status FROM runs WHERE generation = ? AND combination = ? AND seed = "
                 "?");
    if (!query.Bind(generation).Bind(combination).Bind(seed).Step()) {
      return true;
    }
    id = query.GetInteger(0);
    if (IsDone(query.GetText(1)) || !IsDone(status)) {
      return false;
    }
  }
  CQuery(own, "DELETE FROM runs WHERE id = ?").Bind(id).Execute();
  return true;
}

void CopyValues(CDatabase& own, CDatabase& other, SInt64 ownRun, SInt64 otherRun) {
  CQuery metrics(other, "SELECT name, unit, value FROM metrics WHERE run = ?");
  metrics.Bind(otherRun);
  while (metrics.Step()) {
    CQuery(own, "INSERT INTO metrics(run, name, unit, value) VALUES (?, ?, ?, ?)")
        .Bind(ownRun)
        .Bind(metrics.GetText(0))
        .Bind(metrics.GetText(1))
        .Bind(metrics.GetReal(2))
        .Execute();
  }
  CQuery points(other, "SELECT name, tick, value FROM series WHERE run = ?");
  points.Bind(otherRun);
  while (points.Step()) {
    CQuery(own, "INSERT INTO series(run, name, tick, value) VALUES (?, ?, ?, ?)")
        .Bind(ownRun)
        .Bind(points.GetText(0))
        .Bind(points.GetInteger(1))
        .Bind(points.GetReal(2))
        .Execute();
  }
}

void CopyRun(CDatabase& own, const CQuery& run, SInt64 generation, SInt64 combination) {
  CQuery insert(
      own,
      "INSERT INTO runs(generation, combination, seed, attempt, status, exit_status, "
      "signal, memory, ticks, robots, log_bytes, start_up, wall, cpu, total_wall, digest, "
      "log, started, machine, version) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
      "?, ?, ?, ?, ?, ?)");
  insert.Bind(generation).Bind(combination).Bind(run.GetInteger(3)).Bind(run.GetInteger(5));
  insert.Bind(run.GetText(4));
  for (int column = 6; column < 12; ++column) {
    insert.Bind(run.GetInteger(column));
  }
  for (int column = 12; column < 16; ++column) {
    insert.Bind(run.GetReal(column));
  }
  for (int column = 16; column < 21; ++column) {
    insert.Bind(run.GetText(column));
  }
  insert.Execute();
}

}  // namespace

UInt64 CResultStore::Merge(const std::string& otherFile) {
  const CResultStore otherStore(otherFile, EMode::ReadOnly);
  CDatabase& own = *m_database->File;
  CDatabase& other = *otherStore.m_database->File;
  // one state of the other database, should a program be writing it
  other.Execute("BEGIN");
  if (other.QueryNumber("SELECT count(*) FROM generations") == 0) {
    return 0;
  }
  CTransaction transaction(own);
  MatchFactors(own, *this, otherStore, otherFile);
  const std::map<SInt64, SInt64> generations = MatchGenerations(own, other);
  const std::map<SInt64, SInt64> combinations = MatchCombinations(own, other);
  UInt64 copied = 0;
  CQuery runs(other,
              "SELECT id, generation, combination, seed, status, attempt, exit_status, signal, "
              "memory, ticks, robots, log_bytes, start_up, wall, cpu, total_wall, digest, log, "
              "started, machine, version FROM runs ORDER BY id");
  while (runs.Step()) {
    const auto generation = generations.find(runs.GetInteger(1));
    const SInt64 combination = combinations.at(runs.GetInteger(2));
    if (generation == generations.end() ||
        !MakeRoomFor(own, generation->second, combination, runs.GetInteger(3), runs.GetText(4))) {
      continue;
    }
    CopyRun(own, runs, generation->second, combination);
    CopyValues(own, other, own.GetLastRowId(), runs.GetInteger(0));
    ++copied;
  }
  if (generations.at(other.QueryNumber("SELECT max(id) FROM generations")) ==
      own.QueryNumber("SELECT max(id) FROM generations")) {
    CQuery collected(other, "SELECT is_series, name, unit FROM collected ORDER BY id");
    while (collected.Step()) {
      CQuery(own, "INSERT OR IGNORE INTO collected(is_series, name, unit) VALUES (?, ?, ?)")
          .Bind(collected.GetInteger(0))
          .Bind(collected.GetText(1))
          .Bind(collected.GetText(2))
          .Execute();
    }
  }
  CQuery texts(other, "SELECT key, value FROM campaign");
  while (texts.Step()) {
    CQuery(own, "INSERT OR IGNORE INTO campaign(key, value) VALUES (?, ?)")
        .Bind(texts.GetText(0))
        .Bind(texts.GetText(1))
        .Execute();
  }
  CreateResultsView(own);
  transaction.Commit();
  CQuery query(own, "SELECT is_series, name FROM collected");
  while (query.Step()) {
    m_database->Collected.emplace(query.GetInteger(0) != 0, query.GetText(1));
  }
  return copied;
}

}  // namespace argos
