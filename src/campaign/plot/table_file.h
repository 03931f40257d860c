#ifndef ARGOS3_CAMPAIGN_PLOT_TABLE_FILE_H
#define ARGOS3_CAMPAIGN_PLOT_TABLE_FILE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/non_copyable.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace argos {

/** A rectangle of the plane, m. */
struct SPlotArea {
  Real LowX = 0.0, LowY = 0.0, HighX = 0.0, HighY = 0.0;
};

/** Numbers of a header line, in groups that were separated by blanks: "0,0 1,0". */
typedef std::vector<std::vector<Real>> TNumberGroups;

/**
 * Reads a table that argos3 has written, .csv or .csv.gz, row by row.
 *
 * The table may be of anyone: its texts are never more than texts, and what must be a number and is
 * none is an error.
 */
class CTableFile : private CNonCopyable {
 public:
  /**
   * Reads the header.
   * @throws CARGoSException, as all functions, with file and line, if it is no such table or cannot
   *   be read.
   */
  explicit CTableFile(const std::string& path);
  ~CTableFile();

  const std::string& GetPath() const { return m_path; }
  bool HasColumn(const std::string& name) const { return m_columns.count(name) > 0; }
  /** @throws CARGoSException with the names of all columns if there is none of that name. */
  size_t FindColumn(const std::string& name) const;
  /** Empty if the table gives none. */
  std::string GetUnit(const std::string& column) const;
  const std::optional<SPlotArea>& GetArena() const { return m_arena; }
  /** Each with three corners or more. */
  const std::vector<TNumberGroups>& GetPolygons() const { return m_polygons; }
  /** Each with x, y and radius. */
  const std::vector<std::vector<Real>>& GetCircles() const { return m_circles; }

  /** Reads the next row. @return false after the last. */
  bool ReadRow();
  /** A field of the row; empty if the row is too short. */
  const std::string& GetText(size_t column) const;
  /** @return NaN for an empty field and for what is not finite. */
  Real GetNumber(size_t column) const;

 private:
  struct SStream;

  bool ReadLine(std::string& line);
  void ReadHeaderLine(const std::string& line);
  void ReadUnits(const std::string& text);
  TNumberGroups ReadGroups(const std::string& text, size_t numbers) const;
  void SplitFields(const std::string& line);
  [[noreturn]] void Throw(const std::string& problem) const;

  std::string m_path;
  std::unique_ptr<SStream> m_stream;
  UInt64 m_line = 0;
  std::vector<std::string> m_names;
  std::map<std::string, size_t> m_columns;
  std::map<std::string, std::string> m_units;
  std::optional<SPlotArea> m_arena;
  std::vector<TNumberGroups> m_polygons;
  std::vector<std::vector<Real>> m_circles;
  std::vector<std::string> m_fields;  // fields of the row
};

}  // namespace argos

#endif
