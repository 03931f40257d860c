#ifndef ARGOS3_PLUGINS_OUTPUTS_TABLES_ROW_BLOCK_H
#define ARGOS3_PLUGINS_OUTPUTS_TABLES_ROW_BLOCK_H

#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/** What a table contains, fixed when its first row is written. */
struct STableSchema {
  /** A field whose columns are computed from the numbers of a row. */
  struct SDerivation {
    const CField* Field; /**< is not owned */
    std::size_t Start; /**< place of its numbers in the row */
  };

  std::vector<SColumn> Columns; /**< follow run, tick, time and robot */
  std::vector<std::size_t> Places; /**< place of each column in the numbers of a row */
  std::size_t NumNumbers = 0; /**< numbers in a row */
  std::vector<SDerivation> Derivations;
  bool HasRobots = true; /**< the rows are those of robots, or other entities */
  int Digits = 0; /**< significant ones of numbers in texts; 0: as many as needed */
  std::string Version; /**< version of the program that writes it */
  /** Key and value of what is known about the run; a key may be repeated. */
  std::vector<std::pair<std::string, std::string>> Header;

  /** Adds columns of numbers, which follow the other numbers of a row. */
  void AddColumns(const std::vector<SColumn>& columns) {
    for (const SColumn& column : columns) {
      Columns.push_back(column);
      Places.push_back(NumNumbers++);
    }
  }
};

/** Rows on their way to the thread that writes them. Blocks are used again. */
struct SRowBlock {
  /** The rows of one tick. */
  struct STick {
    UInt32 Run; /**< number of resets before */
    UInt32 Seed; /**< seed of the run */
    UInt32 Tick;
    double Time; /**< s */
    std::size_t NumRows;
  };

  std::vector<STick> Ticks;
  std::vector<double> Numbers; /**< row by row, STableSchema::NumNumbers each */
  std::vector<UInt32> Robots; /**< number of each row's robot; empty without robots */
  CRowTexts Texts;
  /** Ids of robots with rows from this block on; their numbers follow those of earlier blocks. */
  std::vector<std::string> NewRobots;
  std::vector<SColumn> NewColumns; /**< contain numbers: rows from this block on have them, too */
  std::size_t NumRows = 0;

  void Clear() {
    Ticks.clear();
    Numbers.clear();
    Robots.clear();
    Texts.Clear();
    NewRobots.clear();
    NewColumns.clear();
    NumRows = 0;
  }
};

}  // namespace argos

#endif
