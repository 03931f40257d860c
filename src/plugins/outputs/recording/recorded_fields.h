#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_RECORDED_FIELDS_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_RECORDED_FIELDS_H

#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/plugins/simulator/outputs/tables/entity_rows.h>

#include <string>
#include <vector>

namespace argos {

class CSpace;

/** Fields of robots that a recording has besides what pictures show. */
class CRecordedFields {
 public:
  /**
   * @param location  of the element, for messages.
   * @param fields    names with commas, such as "battery,readings:proximity"; not empty.
   * @throws CARGoSException if one is no field, or cannot be recorded; if no robot has it.
   */
  CRecordedFields(const std::string& location, const std::string& fields, CSpace& space);

  /** Adds the columns of now to an update that has its entities. */
  void Take(CSpace& space, SFrameUpdate& update);

 private:
  void FindNumbers(CSpace& space);
  void AddColumn(std::size_t index, const std::string& field, const SColumn& column,
                 SFrameUpdate& update) const;

  CEntityRows m_rows;
  SRowBlock m_block;
  std::vector<UInt32> m_numbers;  // number in the recording of the entity of each row
  std::size_t m_numEntities = 0;
};

}  // namespace argos

#endif
