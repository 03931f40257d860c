#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_COLORED_BLOBS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_COLORED_BLOBS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <ostream>
#include <vector>

namespace argos {

/** A sensor that Lua scripts enable and disable with functions of its table. */
class CSwitchedTableSensor : public CTableSensor {
 private:
  /** enable(), disable() */
  void WriteConstants(CLuaTable& table) override;
};

/**
 * Base of the control interfaces of cameras that list coloured blobs.
 *
 * Starts disabled: a controller calls Enable(), and has its first readings in the next step.
 * @tparam BLOB  one coloured light.
 */
template <class BLOB>
class CColoredBlobs : public CSwitchedTableSensor {
 public:
  typedef BLOB SBlob;
  typedef std::vector<BLOB*> TBlobList;

  struct SReadings {
    TBlobList BlobList; /**< not owned; the blobs are valid until the next step */
    UInt64 Counter = 0; /**< number of images since the start */

    template <int = 0>
    friend std::ostream& operator<<(std::ostream& stream, const SReadings& readings) {
      return stream << readings.BlobList;
    }
  };

  const SReadings& GetReadings() const { return m_sReadings; }

 protected:
  SReadings m_sReadings;

 private:
  void ListNumbers(CNumberList& list) const override {
    list.Add("count", "", static_cast<Real>(m_sReadings.BlobList.size()));
  }
};

}  // namespace argos

#endif
