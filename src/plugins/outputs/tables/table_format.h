#ifndef ARGOS3_PLUGINS_OUTPUTS_TABLES_TABLE_FORMAT_H
#define ARGOS3_PLUGINS_OUTPUTS_TABLES_TABLE_FORMAT_H

#include <argos3/core/utility/plugins/factory.h>
#include <argos3/plugins/simulator/outputs/tables/row_block.h>

#include <string>
#include <vector>

namespace argos {

/**
 * A format of table files. The label of a class is the ending of the files' names, such as "csv".
 *
 * One thread at a time calls it. Every function throws CARGoSException with the file's name and the
 * reason if the file cannot be written; the file then ends with the last whole row.
 */
class CTableFormat {
 public:
  virtual ~CTableFormat() = default;

  /** Creates the file, or empties it, and writes what precedes the rows. */
  virtual void Open(const std::string& path, const STableSchema& schema) = 0;
  /** Adds columns of numbers after the others: the rows that are there have no values in them. */
  virtual void AddColumns(const std::vector<SColumn>& columns) = 0;
  /** Writes rows, so that they are in the file if the process is killed afterwards. */
  virtual void Write(const SRowBlock& block) = 0;
  /** Nothing is written afterwards. */
  virtual void Close() = 0;
};

}  // namespace argos

#define REGISTER_TABLE_FORMAT(CLASSNAME, LABEL, BRIEF_DESCRIPTION)                      \
  REGISTER_SYMBOL(CTableFormat, CLASSNAME, LABEL, "the authors of this project", "1.0", \
                  BRIEF_DESCRIPTION, "See doc/get_data_out.md.", "Usable")

#endif
