// The field of the messages that a range-and-bearing sensor receives.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>

namespace argos {

namespace {

// the first range-and-bearing sensor of the controller; null if there is none
CCI_RangeAndBearingSensor* FindRABSensor(CControllableEntity& robot) {
  if (robot.HasController()) {
    for (const auto& [label, sensor] : robot.GetController().GetAllSensors()) {
      if (auto* const found = dynamic_cast<CCI_RangeAndBearingSensor*>(sensor)) {
        return found;
      }
    }
  }
  return nullptr;
}

class CMessagesReader : public CFieldReader {
 public:
  explicit CMessagesReader(CControllableEntity& robot) : m_robot(robot) { Resolve(); }

  std::size_t CountRows() override {
    if (m_numControllers != m_robot.GetNumControllers()) {
      Resolve();
    }
    return m_sensor != nullptr ? m_sensor->GetReadings().size() : 0;
  }

  void Read(std::size_t index, SFieldRow row) override {
    const CCI_RangeAndBearingSensor::SPacket& packet = m_sensor->GetReadings()[index];
    row.Numbers[0] = packet.Range;
    row.Numbers[1] = packet.HorizontalBearing.GetValue();
    row.Numbers[2] = packet.VerticalBearing.GetValue();
    row.Numbers[3] = row.Texts.AddHexadecimal(packet.Data.ToCArray(), packet.Data.Size());
  }

 private:
  void Resolve() {
    m_numControllers = m_robot.GetNumControllers();
    m_sensor = FindRABSensor(m_robot);
  }

  CControllableEntity& m_robot;
  CCI_RangeAndBearingSensor* m_sensor = nullptr;  // sensor of the current controller
  UInt32 m_numControllers = 0;
};

class CMessagesField : public CField {
 public:
  bool IsList() const override { return true; }
  bool NeedsController() const override { return true; }

  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    SBoundField bound;
    auto* const robot = FindExisting<CControllableEntity>(root);
    if (robot != nullptr && FindRABSensor(*robot) != nullptr) {
      bound.Reader = std::make_unique<CMessagesReader>(*robot);
      bound.Columns = {{"message_range", "cm"},
                       {"message_horizontal_bearing", "rad"},
                       {"message_vertical_bearing", "rad"},
                       {"message_data", "", EColumnKind::Text}};
    }
    return bound;
  }
};

}  // namespace

REGISTER_FIELD(
    CMessagesField, "messages", "the authors of this project", "1.0",
    "The messages that the range-and-bearing sensor has received, a row for each.",
    R"(A table with this field has a row for each message instead of one for each robot; a robot
that has received none in this tick has no row. Columns, as controllers see them: message_range (cm),
message_horizontal_bearing and message_vertical_bearing (rad), and message_data: the bytes, two
hexadecimal digits each. The number of messages, in a table with one row for each robot, is
"readings:range_and_bearing".
)",
    "Usable")

}  // namespace argos
