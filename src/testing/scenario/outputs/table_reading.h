#ifndef ARGOS3_TESTING_SCENARIO_OUTPUTS_TABLE_READING_H
#define ARGOS3_TESTING_SCENARIO_OUTPUTS_TABLE_READING_H

#include <map>
#include <string>
#include <vector>

namespace argos {

/** A table that was read back. */
struct SReadTable {
  std::vector<std::string> Header; /**< lines that begin with '#' */
  std::vector<std::string> Names; /**< of the columns, in order */
  std::map<std::string, std::vector<std::string>> Columns; /**< texts, by name */

  std::size_t GetNumRows() const { return Columns.at("tick").size(); }
  /** As C's strtod() reads them; NaN for empty texts. */
  std::vector<double> GetNumbers(const std::string& column) const;
};

/** The text of a CSV file without quotes. */
SReadTable ReadCSV(const std::string& text);
/** The text of a compressed file, with zlib. @throws CARGoSException if it is damaged. */
std::string Unzip(const std::string& path);
/** A data set of numbers. @throws CARGoSException if there is none. */
std::vector<double> ReadHDF5Numbers(const std::string& path, const std::string& name);
/** A data set of texts of fixed length, without the zeros after them. */
std::vector<std::string> ReadHDF5Texts(const std::string& path, const std::string& name);

}  // namespace argos

#endif
