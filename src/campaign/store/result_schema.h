#ifndef ARGOS3_CAMPAIGN_STORE_RESULT_SCHEMA_H
#define ARGOS3_CAMPAIGN_STORE_RESULT_SCHEMA_H

// private: tables and views of a result store

#include <argos3/campaign/store/database.h>
#include <argos3/campaign/store/result_store.h>
#include <argos3/campaign/store/store_lock.h>

#include <sys/types.h>

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace argos {

struct CResultStore::SDatabase {
  std::unique_ptr<CStoreLock> Lock; /**< null if it is read only */
  std::unique_ptr<CDatabase> File;
  std::set<std::pair<bool, std::string>> Collected; /**< (is a series, name) in the database */
  pid_t Owner = 0;
  dev_t Device = 0; /**< device of the file that was opened for writing */
  ino_t Inode = 0;
};

/** Creates the tables in an empty database; the caller has begun a transaction. */
void CreateSchema(CDatabase& database);

/** @throws CARGoSException if it is no database of a campaign, or of another version. */
void CheckSchema(CDatabase& database);

/** @return true if the database has no tables at all. */
bool IsEmptyDatabase(CDatabase& database);

/** Creates the view `results` anew, for the factors and metrics that the database has. */
void CreateResultsView(CDatabase& database);

/** A column of the view and of tables in files. */
struct SResultColumn {
  enum class EKind { Run, Factor, Metric };
  EKind Kind = EKind::Run;
  std::string Title; /**< unique, whatever the case of letters */
  std::string Source; /**< column of the table runs, name of the factor or of the metric */
};

/**
 * run, combination, the factors, what the table runs has, the metrics. A factor keeps its name;
 * other columns with its name begin with "run_" or "metric_".
 */
std::vector<SResultColumn> ListResultColumns(const std::vector<std::string>& factors,
                                             const std::vector<std::string>& metrics);

/** Now, UTC, "2026-01-31T12:00:00Z". */
std::string GetTimeText();

}  // namespace argos

#endif
