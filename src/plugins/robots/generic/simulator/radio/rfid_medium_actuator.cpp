#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_actuator.h>
#include <argos3/plugins/robots/generic/simulator/rfid_antenna.h>

namespace argos {

namespace {

/** Hands orders to write over to a medium, which knows the tags. */
class CRFIDMediumActuator : public CSimulatedActuator, public CCI_RFIDActuator {
 public:
  void SetRobot(CComposableEntity& robot) override { m_antenna.SetRobot(robot); }
  /** Reads what CRFIDAntenna::Init() does. @throws CARGoSException if a value is wrong. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** No order. */
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
    R"(The controller orders to write bytes to a tag's memory, from a given place on. The order is carried out once, in
the next tick, before robots move: the bytes go to the tag nearest to the writer, if one is within the range and its
memory is large enough; of tags equally near, to the one that was put into the arena first. Tags that the robot carries
itself are not written. The controller learns in the same tick which tag was written. Robots that write in one tick do so
in the order in which they were put into the arena: the bytes of the last one stay. Works on any robot with a body.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <rfid implementation="medium" medium="rfid" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

with the medium that it names:

  <media>
    <rfid id="rfid" />
  </media>

  medium  text, required: the id of an RFID medium.

OPTIONAL XML

  <rfid implementation="medium" medium="rfid" range="0.1" position="0.02,0,0" />

  range     m, >= 0, default 0.1: how far the writer reaches.
  position  "x,y,z", m, default "0,0,0": where the writer is, in the robot's frame.
)",
    "Usable")

}  // namespace argos
