#include <argos3/campaign/store/experiment_files.h>
#include <argos3/campaign/store/result_schema.h>
#include <argos3/campaign/store/result_store.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/lists.h>

#include <fmt/format.h>

#include <filesystem>

namespace argos {

namespace {

std::string Join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    AppendQuoted(text, name);
  }
  return text.empty() ? "none" : text;
}

void SetText(CDatabase& database, const std::string& key, const std::string& value) {
  CQuery(database, "INSERT OR REPLACE INTO campaign(key, value) VALUES (?, ?)")
      .Bind(key)
      .Bind(value)
      .Execute();
}

std::vector<std::string> ListMetricLibraries(const SCampaign& campaign) {
  std::vector<std::string> libraries;
  for (const SCollectedMetric& metric : campaign.Metrics) {
    if (!metric.Library.empty()) {
      libraries.push_back(metric.Library);
    }
  }
  return libraries;
}

// describes what the campaign collects, for comparison
std::string DescribeCollected(const SCampaign& campaign) {
  std::string text;
  for (const SCollectedMetric& metric : campaign.Metrics) {
    text += fmt::format("{} source {} reduction {} series {} every {} {} {} {}\n", metric.Name,
                        static_cast<int>(metric.Source), static_cast<int>(metric.Reduction),
                        metric.IsSeries, metric.Every, metric.Pattern, metric.TimeColumn,
                        metric.ValueColumn);
  }
  return text.empty() ? "all metrics that a run sets\n" : text;
}

void RegisterFactors(CDatabase& database, const CResultStore& store, const SCampaign& campaign) {
  const std::vector<std::string> names = campaign.ListFactors();
  const bool isNew = database.QueryNumber("SELECT count(*) FROM generations") == 0;
  const std::vector<std::string> stored = store.ListFactors();
  if (!isNew && stored != names) {
    THROW_ARGOSEXCEPTION("the results file \""
                         << database.GetFile() << "\" has the factors " << Join(stored)
                         << ", but \"" << campaign.File << "\" has " << Join(names)
                         << ": choose another name for the results, with results=\"...\" of "
                            "<argos-campaign>");
  }
  if (isNew) {
    for (const std::string& name : names) {
      CQuery(database, "INSERT INTO factors(name) VALUES (?)").Bind(name).Execute();
    }
  }
}

void RegisterCombination(CDatabase& database, const SCombination& combination, size_t number) {
  const std::string key = combination.ComputeKey();
  {
    CQuery find(database, "SELECT id FROM combinations WHERE key = ?");
    if (find.Bind(key).Step()) {
      CQuery(database, "UPDATE combinations SET number = ? WHERE id = ?")
          .Bind(static_cast<UInt64>(number))
          .Bind(find.GetInteger(0))
          .Execute();
      return;
    }
  }
  CQuery(database, "INSERT INTO combinations(key, number) VALUES (?, ?)")
      .Bind(key)
      .Bind(static_cast<UInt64>(number))
      .Execute();
  const SInt64 id = database.GetLastRowId();
  CQuery insert(
      database,
      "INSERT INTO combination_values(combination, factor, value, level) SELECT ?, id, ?, "
      "? FROM factors ORDER BY id LIMIT 1 OFFSET ?");
  for (size_t f = 0; f < combination.Values.size(); ++f) {
    const std::string& value = combination.Values[f];
    insert.Bind(id).Bind(value).Bind(value).Bind(static_cast<UInt64>(f)).Execute();
  }
}

// returns a warning if runs are left out
std::string RegisterCombinations(CDatabase& database, const SCampaign& campaign) {
  database.Execute("UPDATE combinations SET number = NULL");
  for (size_t c = 0; c < campaign.Combinations.size(); ++c) {
    RegisterCombination(database, campaign.Combinations[c], c + 1);
  }
  database.Execute(
      "DELETE FROM combinations WHERE number IS NULL AND NOT EXISTS (SELECT 1 FROM runs WHERE "
      "combination = combinations.id)");
  const SInt64 left =
      database.QueryNumber("SELECT count(*) FROM combinations WHERE number IS NULL");
  return left == 0
             ? ""
             : fmt::format(
                   "{}: {} combination(s) of earlier runs are no longer in the campaign; their "
                   "results stay in \"{}\"\n",
                   campaign.File, left, database.GetFile());
}

struct SGeneration {
  std::string Digest, Experiment, Libraries, Started;
};

SGeneration ReadNewestGeneration(CDatabase& database) {
  CQuery query(database,
               "SELECT digest, experiment, libraries, started FROM generations ORDER BY id DESC "
               "LIMIT 1");
  return query.Step()
             ? SGeneration{query.GetText(0), query.GetText(1), query.GetText(2), query.GetText(3)}
             : SGeneration();
}

void RefuseChange(const SCampaign& campaign, const SGeneration& newest, const CDatabase& database) {
  THROW_ARGOSEXCEPTION(campaign.ExperimentFile
                       << " has changed since the runs of " << newest.Started << " in \""
                       << database.GetFile() << "\" ("
                       << DescribeFirstDifference(newest.Experiment, campaign.ExperimentText)
                       << "): results of different experiments would be mixed. Undo the change, "
                          "choose another name for the results, or begin a new generation of runs "
                          "with --accept-change");
}

void BeginGeneration(CDatabase& database, const SCampaign& campaign, const std::string& digest,
                     const std::string& libraries) {
  CQuery(database,
         "INSERT INTO generations(digest, experiment, libraries, started) VALUES (?, ?, ?, ?)")
      .Bind(digest)
      .Bind(campaign.ExperimentText)
      .Bind(libraries)
      .Bind(GetTimeText())
      .Execute();
  database.Execute("DELETE FROM collected");
}

}  // namespace

std::string CResultStore::Register(const SCampaign& campaign, bool acceptChange) {
  CDatabase& database = *m_database->File;
  const std::string digest = ComputeTextDigest(campaign.ExperimentText);
  const std::string libraries = DescribeExperimentFiles(
      campaign.ExperimentText, campaign.ExperimentFile, ListMetricLibraries(campaign));
  CTransaction transaction(database);
  RegisterFactors(database, *this, campaign);
  const SGeneration newest = ReadNewestGeneration(database);
  std::string warnings;
  const bool begins = newest.Digest != digest;
  if (begins) {
    if (!newest.Digest.empty() && !acceptChange) {
      RefuseChange(campaign, newest, database);
    }
    BeginGeneration(database, campaign, digest, libraries);
  } else {
    const std::string changed = ListChangedFiles(newest.Libraries, libraries);
    if (!changed.empty()) {
      warnings += fmt::format(
          "{} changed since the runs of {}: if that affects results, runs of \"{}\" are mixed\n",
          changed, newest.Started, database.GetFile());
    }
    const std::string collected = GetText("collect");
    if (!collected.empty() && collected != DescribeCollected(campaign)) {
      warnings += campaign.File +
                  ": <collect> has changed; runs that are stored lack what was added since\n";
    }
  }
  warnings += RegisterCombinations(database, campaign);
  SetText(database, "name", std::filesystem::path(campaign.File).stem().string());
  SetText(database, "file", campaign.File);
  SetText(database, "text", campaign.Text);
  SetText(database, "experiment_file", campaign.ExperimentFile);
  SetText(database, "collect", DescribeCollected(campaign));
  CreateResultsView(database);
  transaction.Commit();
  if (begins) {
    m_database->Collected.clear();
  }
  return warnings;
}

}  // namespace argos
