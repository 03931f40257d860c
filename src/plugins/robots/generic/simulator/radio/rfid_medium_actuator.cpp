#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_actuator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/rfid_antenna.h>

namespace argos {

namespace {

/** Passes write commands to the RFID medium, which finds the tags. */
class CRFIDMediumActuator : public CSimulatedActuator, public CCI_RFIDActuator {
 public:
  void SetRobot(CComposableEntity& robot) override { m_antenna.SetRobot(robot); }
  /** See CRFIDAntenna::Init(). */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Discards a pending command. */
  void Reset() override { m_isOrdered = false; }
  const std::string& GetWrittenTag() const override { return m_antenna.GetUser().WrittenTag; }

 private:
  CRFIDAntenna m_antenna;
};

}  // namespace

void CRFIDMediumActuator::Init(TConfigurationNode& tree) {
  CCI_RFIDActuator::Init(tree);
  m_antenna.Init(tree);
}

void CRFIDMediumActuator::Update() {
  if (!m_isOrdered) {
    return;
  }
  CRFIDMedium::CUser& user = m_antenna.GetUser();
  user.Place = m_antenna.ComputePlace();
  user.Offset = m_offset;
  user.Bytes = m_data;
  user.HasOrder = true;
  m_isOrdered = false;
}

REGISTER_ACTUATOR(
    CRFIDMediumActuator, "rfid", "medium", "the authors of this project", "1.0",
    "Writes to the RFID tag nearest to the robot.",
    R"(The controller commands to write bytes to a tag's memory at a given offset. The command is executed once, in the
next tick, before the robots move: the bytes are written to the tag nearest to the writer, if a tag is within the range
and its memory is large enough; if several tags have the same distance, to the one that was added to the arena first.
Tags on the robot itself are not written. The controller gets the id of the written tag in the same tick. Robots that
write in the same tick do so in the order in which they were added to the arena: the bytes of the last one remain. Works
on any robot with a body.
)" + RequiredActuatorXML(R"(<rfid implementation="medium" medium="rfid" />)") +
        MediumXML(R"(<rfid id="rfid" />)", "an RFID medium") +
        OptionalXML(
            R"(<rfid implementation="medium" medium="rfid" range="0.1" position="0.02,0,0" />)") +
        R"(
  range     m, >= 0, default 0.1: range of the writer.
  position  "x,y,z", m, default "0,0,0": position of the writer in the robot's frame.
)",
    "Usable")

}  // namespace argos
