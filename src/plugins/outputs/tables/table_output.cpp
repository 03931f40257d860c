#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/simulator/outputs/tables/entity_rows.h>
#include <argos3/plugins/simulator/outputs/tables/table_base.h>

#include <optional>

namespace argos {

/* <table>: fields of robots and other entities, a row for each entity and tick. */
class CTableOutput : public CTableBase {
 public:
  void Init(TConfigurationNode& tree) override {
    CTableBase::Init(tree);
    std::string fields = "pose";
    std::string types;
    std::string ids;
    GetNodeAttributeOrDefault(tree, "fields", fields, fields);
    GetNodeAttributeOrDefault(tree, "of", types, types);
    GetNodeAttributeOrDefault(tree, "robots", ids, ids);
    m_rows.emplace(GetLocation(), ReadFieldNames(GetLocation(), fields), SplitAtCommas(types),
                   SplitAtCommas(ids));
    m_rows->Resolve(CurrentSpace());
  }

 private:
  bool Update(CSimulator& simulator) override {
    m_rows->Update(simulator.GetSpace());
    return m_rows->AreColumnsKnown();
  }

  void Describe(STableSchema& schema) const override { m_rows->Describe(schema); }

  std::size_t Read(CSimulator& /*simulator*/, SRowBlock& block) override {
    return m_rows->Read(block);
  }

  const char* ExplainEmptyTable() const override {
    return "there never was an entity that it lists";
  }

  std::optional<CEntityRows> m_rows;
};

REGISTER_RUN_OUTPUT(
    CTableOutput, "table", "the authors of this project", "1.0",
    "A table of fields of robots: poses, wheels, LEDs, readings, messages, Lua variables.",
    R"(Writes a row for each robot and tick, on a thread of its own. doc/get_data_out.md shows how to load
and plot the files. `argos3 -q fields` lists the fields.

REQUIRED XML

  <outputs>
    <table file="poses.csv" />
  </outputs>

  file    ends in .csv, .csv.gz (compressed) or .h5 (HDF5, which Octave, MATLAB and Python load). Its
          folder is created. An existing file is replaced when the run begins.

OPTIONAL XML

  <table file="poses.csv" every="10" fields="pose,wheels,readings:proximity" of="foot-bot,e-puck"
         robots="fb0,fb3" digits="6" />

  every   whole number >= 1, default 1: rows of the ticks 0, every, 2 every, ...
  fields  list, default "pose".
  of      list of tags: the entities that have rows; also boxes and lights. Default: all robots.
  robots  list of ids: only these have rows. They are in the arena at the start. Default: all.
  digits  from 1 to 17: significant digits of numbers in texts. Default: as many as needed to read the
          same number back.

Columns: run (the number of resets before), tick, time (s), robot (its id), and those of the fields. A
robot has rows while it is in the arena. What it does not have is empty (CSV) or NaN (HDF5). After a
reset the rows of the next run follow in the same file.
)",
    "Usable")

}  // namespace argos
