#include <argos3/campaign/store/result_schema.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <array>
#include <ctime>

namespace argos {

namespace {

constexpr SInt64 kApplicationId = 0x41524743;  // "ARGC"
constexpr SInt64 kFormatVersion = 1;

// level: the value of a factor as a number if it is one, so that ORDER BY and avg() work
constexpr const char* kTables = R"(
CREATE TABLE campaign(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE generations(id INTEGER PRIMARY KEY, digest TEXT NOT NULL, experiment TEXT NOT NULL,
  libraries TEXT NOT NULL, started TEXT NOT NULL);
CREATE TABLE factors(id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE);
CREATE TABLE combinations(id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, number INTEGER);
CREATE TABLE combination_values(
  combination INTEGER NOT NULL REFERENCES combinations(id) ON DELETE CASCADE,
  factor INTEGER NOT NULL REFERENCES factors(id), value TEXT NOT NULL, level NUMERIC NOT NULL,
  PRIMARY KEY(combination, factor)) WITHOUT ROWID;
CREATE TABLE runs(id INTEGER PRIMARY KEY AUTOINCREMENT,
  combination INTEGER NOT NULL REFERENCES combinations(id), seed INTEGER NOT NULL,
  generation INTEGER NOT NULL REFERENCES generations(id), attempt INTEGER NOT NULL,
  status TEXT NOT NULL, exit_status INTEGER NOT NULL, signal INTEGER NOT NULL,
  start_up REAL, wall REAL, cpu REAL, total_wall REAL, memory INTEGER NOT NULL,
  ticks INTEGER NOT NULL, robots INTEGER NOT NULL, digest TEXT NOT NULL, log TEXT NOT NULL,
  log_bytes INTEGER NOT NULL, started TEXT NOT NULL, machine TEXT NOT NULL, version TEXT NOT NULL,
  UNIQUE(generation, combination, seed));
CREATE TABLE metrics(run INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  name TEXT NOT NULL, unit TEXT NOT NULL, value REAL, PRIMARY KEY(run, name)) WITHOUT ROWID;
CREATE TABLE series(run INTEGER NOT NULL REFERENCES runs(id) ON DELETE CASCADE,
  name TEXT NOT NULL, tick INTEGER NOT NULL, value REAL,
  PRIMARY KEY(run, name, tick)) WITHOUT ROWID;
CREATE TABLE collected(id INTEGER PRIMARY KEY, is_series INTEGER NOT NULL, name TEXT NOT NULL,
  unit TEXT NOT NULL, UNIQUE(is_series, name));
)";

// quotes for SQL: names are letters, digits and '_', or come from another program's database
std::string Quote(const std::string& text, char quote) {
  std::string quoted(1, quote);
  for (const char c : text) {
    quoted += c;
    if (c == quote) {
      quoted += c;
    }
  }
  return quoted + quote;
}

std::vector<std::string> ListNames(CDatabase& database, const std::string& statement) {
  std::vector<std::string> names;
  CQuery query(database, statement);
  while (query.Step()) {
    names.push_back(query.GetText(0));
  }
  return names;
}

}  // namespace

void CreateSchema(CDatabase& database) {
  database.Execute(kTables);
  database.Execute("PRAGMA application_id = " + std::to_string(kApplicationId));
  database.Execute("PRAGMA user_version = " + std::to_string(kFormatVersion));
  CreateResultsView(database);
}

bool IsEmptyDatabase(CDatabase& database) {
  return database.QueryNumber("SELECT count(*) FROM sqlite_master") == 0;
}

void CheckSchema(CDatabase& database) {
  if (database.QueryNumber("PRAGMA application_id") != kApplicationId) {
    THROW_ARGOSEXCEPTION("\"" << database.GetFile()
                              << "\" is a database, but not one of a campaign: choose another name "
                                 "for the results");
  }
  const SInt64 version = database.QueryNumber("PRAGMA user_version");
  if (version != kFormatVersion) {
    THROW_ARGOSEXCEPTION("the results file \""
                         << database.GetFile() << "\" has format " << version
                         << ", but this program knows format " << kFormatVersion
                         << ": use the version of argos3-campaign that wrote it, or choose another "
                            "name for the results");
  }
}

std::vector<SResultColumn> ListResultColumns(const std::vector<std::string>& factors,
                                             const std::vector<std::string>& metrics) {
  using EKind = SResultColumn::EKind;
  std::set<std::string> titles;
  for (const std::string& factor : factors) {
    titles.insert(StringToLowerCase(factor));
  }
  std::vector<SResultColumn> columns;
  const auto add = [&](EKind kind, const std::string& source, const std::string& prefix) {
    std::string title = source;
    while (kind != EKind::Factor && !titles.insert(StringToLowerCase(title)).second) {
      title.insert(0, prefix);
    }
    columns.push_back({kind, title, source});
  };
  add(EKind::Run, "id", "run_");
  add(EKind::Run, "combination", "run_");
  for (const std::string& factor : factors) {
    add(EKind::Factor, factor, "");
  }
  for (const char* column :
       {"seed", "status", "attempt", "exit_status", "signal", "start_up", "wall", "cpu",
        "total_wall", "memory", "ticks", "robots", "digest", "machine", "version", "started"}) {
    add(EKind::Run, column, "run_");
  }
  for (const std::string& metric : metrics) {
    add(EKind::Metric, metric, "metric_");
  }
  return columns;
}

void CreateResultsView(CDatabase& database) {
  const auto columns = ListResultColumns(
      ListNames(database, "SELECT name FROM factors ORDER BY id"),
      ListNames(database, "SELECT name FROM collected WHERE is_series = 0 ORDER BY id"));
  std::string list;
  for (const SResultColumn& column : columns) {
    list += list.empty() ? "" : ",\n  ";
    switch (column.Kind) {
      case SResultColumn::EKind::Run:
        list += "r." + column.Source;
        break;
      case SResultColumn::EKind::Factor:
        list +=
            "(SELECT v.level FROM combination_values v JOIN factors f ON f.id = v.factor WHERE "
            "v.combination = r.combination AND f.name = " +
            Quote(column.Source, '\'') + ")";
        break;
      case SResultColumn::EKind::Metric:
        list += "(SELECT m.value FROM metrics m WHERE m.run = r.id AND m.name = " +
                Quote(column.Source, '\'') + ")";
        break;
    }
    list += " AS " + Quote(column.Title, '"');
  }
  database.Execute("DROP VIEW IF EXISTS results; CREATE VIEW results AS SELECT " + list +
                   "\nFROM runs r WHERE r.generation = (SELECT max(id) FROM generations)");
}

std::string GetTimeText() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  const size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return std::string(text.data(), size);
}

}  // namespace argos
