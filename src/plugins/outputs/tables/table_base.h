#ifndef ARGOS3_PLUGINS_OUTPUTS_TABLES_TABLE_BASE_H
#define ARGOS3_PLUGINS_OUTPUTS_TABLES_TABLE_BASE_H

#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/simulator/outputs/tables/row_block.h>
#include <argos3/plugins/simulator/outputs/tables/table_writer.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Base of outputs that write one file with rows: reads the attributes that all of them have, counts
 * the runs, and has the rows written.
 *
 * The file is created when the first rows are known, and one file has the rows of all runs of an
 * experiment that is reset, with their number in the column "run".
 */
class CTableBase : public CRunOutput {
 public:
  /**
   * Reads `file`, `every` and `digits`, and creates the folder of the file.
   * @throws CARGoSException if a value is wrong, or if the file cannot be written.
   */
  void Init(TConfigurationNode& tree) override;
  void Reset() override { ++m_run; }
  void Observe(CSimulator& simulator) override;
  void Finish(CSimulator& simulator) override;
  void Destroy() override;

 protected:
  /** @return true if the present tick has rows. */
  bool IsWanted(const CSimulator& simulator) const;
  /** The present tick, without rows. */
  SRowBlock::STick MakeTick(const CSimulator& simulator) const;
  /** Creates the file if its columns are known, and appends the rows of a tick. */
  void AppendTick(CSimulator& simulator, SRowBlock::STick tick);
  /** Adds columns of numbers at the end: rows until now have no values there. */
  void AddColumns(const std::vector<SColumn>& columns) { m_writer->AddColumns(columns); }

  /** "file:line: <table>", for messages. */
  const std::string& GetLocation() const { return m_location; }
  const std::string& GetPath() const { return m_path; }

 private:
  /** Follows what there is. @return true if the columns are known: the file can be created. */
  virtual bool Update(CSimulator& simulator) = 0;
  /** Sets columns and places. */
  virtual void Describe(STableSchema& schema) const = 0;
  /** Appends rows, also before the file is created. @return their number. */
  virtual std::size_t Read(CSimulator& simulator, SRowBlock& block) = 0;
  /** The end of "no rows were written: ...". */
  virtual const char* ExplainEmptyTable() const = 0;

  void Open(CSimulator& simulator);

  std::string m_location;
  std::string m_path;
  UInt32 m_every = 1;  // ticks
  int m_digits = 0;
  UInt32 m_run = 0;
  std::unique_ptr<CTableWriter> m_writer;
};

}  // namespace argos

#endif
