#ifndef ARGOS3_CAMPAIGN_STORE_RESULT_EXPORT_H
#define ARGOS3_CAMPAIGN_STORE_RESULT_EXPORT_H

#include <argos3/campaign/store/result_store.h>

#include <string>

namespace argos {

/**
 * Writes the newest generation as tables into a folder, which is created:
 *
 * - runs.csv: a row for each run, with the columns of the view `results`;
 * - series_NAME.csv for each series: factors, seed, tick and value, a row for each value of the
 *   runs that are done.
 *
 * Lines that begin with '#' say from which campaign the file is. Numbers have as many digits as
 * are needed to read back the same number; what is missing is empty.
 * @throws CARGoSException if a file cannot be written.
 */
void ExportCSV(const CResultStore& store, const std::string& folder);

/**
 * Writes the newest generation as one JSON object:
 *
 *   {"campaign": "...", "experiment": "...", "factors": [...], "metrics": {"NAME": "unit", ...},
 *    "runs": [{"id": 1, "combination": 1, "factors": {...}, "seed": 1, "status": "done", ...,
 *              "metrics": {...}}, ...],
 *    "series": [{"name": "...", "unit": "...", "combination": 1, "seed": 1, "ticks": [...],
 *                "values": [...]}, ...]}
 *
 * Numbers that are missing, or not finite, are null.
 * @throws CARGoSException if the file cannot be written.
 */
void ExportJSON(const CResultStore& store, const std::string& file);

}  // namespace argos

#endif
