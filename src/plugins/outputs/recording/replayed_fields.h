#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_REPLAYED_FIELDS_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_REPLAYED_FIELDS_H

#include <argos3/core/simulator/outputs/field.h>
#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/** The recorded columns of the state that a replay shows; shared by all its entities. */
struct SReplayedColumns {
  std::vector<SRecordedColumn> Columns;
};

/** The recorded fields of one entity. */
class CReplayedFields {
 public:
  void Set(std::shared_ptr<const SReplayedColumns> columns) { m_columns = std::move(columns); }
  /** @param row  of the entity in each column of the present state. */
  void SetRow(std::size_t row) { *m_row = row; }

  /** As CFieldSource. */
  SBoundField Bind(const std::string& name) const;
  void List(std::vector<std::string>& names) const;

 private:
  std::shared_ptr<const SReplayedColumns> m_columns;  // null: none
  // shared with readers, which may be destroyed after the entity
  std::shared_ptr<std::size_t> m_row = std::make_shared<std::size_t>(0);
};

}  // namespace argos

#endif
