// Fields of robots that need no plug-in: readings of their sensors, what their controllers keep,
// whether they touch something, and whether errors have stopped them.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/outputs/controller_field.h>
#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/root_components.h>

#include <map>
#include <utility>

namespace argos {

namespace {

using TSensors = CCI_Sensor::TMap;

// null if the robot has no controller
const TSensors* GetSensors(CControllableEntity& robot) {
  return robot.HasController() ? &robot.GetController().GetAllSensors() : nullptr;
}

CCI_Sensor* FindSensor(CControllableEntity& robot, const std::string& label) {
  const TSensors* const sensors = GetSensors(robot);
  if (sensors == nullptr) {
    return nullptr;
  }
  const auto found = sensors->find(label);
  return found == sensors->end() ? nullptr : found->second;
}

/* Reads the numbers of a sensor. */
class CReadingsReader : public CFieldReader {
 public:
  CReadingsReader(CControllableEntity& robot, std::string label, std::size_t numColumns)
      : m_robot(robot), m_label(std::move(label)), m_numColumns(numColumns) {
    Resolve();
  }

  void Read(std::size_t /*index*/, SFieldRow row) override {
    if (m_numControllers != m_robot.GetNumControllers()) {
      Resolve();
    }
    if (m_sensor != nullptr) {
      m_sensor->CopyReadings(row.Numbers, m_numColumns);
    }
  }

 private:
  void Resolve() {
    m_numControllers = m_robot.GetNumControllers();
    m_sensor = FindSensor(m_robot, m_label);
  }

  CControllableEntity& m_robot;
  std::string m_label;
  std::size_t m_numColumns;
  CCI_Sensor* m_sensor = nullptr;  // of the current controller; null: it has none of that label
  UInt32 m_numControllers = 0;
};

class CReadingsField : public CControllerField {
 private:
  SBoundField BindRobot(CControllableEntity& robot, const std::string& argument) const override {
    SBoundField bound;
    const CCI_Sensor* const sensor = FindSensor(robot, argument);
    if (sensor == nullptr) {
      return bound;
    }
    for (CCI_Sensor::SColumn& column : sensor->GetReadingColumns()) {
      bound.Columns.push_back({ToColumnName(argument + '_' + column.Name), column.Unit});
    }
    if (!bound.Columns.empty()) {
      bound.Reader = std::make_unique<CReadingsReader>(robot, argument, bound.Columns.size());
    }
    return bound;
  }

  void ListNamesOf(CControllableEntity& robot, const std::string& prefix,
                   std::vector<std::string>& names) const override {
    const TSensors* const sensors = GetSensors(robot);
    if (sensors == nullptr) {
      return;
    }
    for (const auto& [sensorLabel, sensor] : *sensors) {
      if (!sensor->GetReadingColumns().empty()) {
        names.push_back(prefix + sensorLabel);
      }
    }
  }
};

/* Reads a number that the controller keeps. */
class CValueReader : public CFieldReader {
 public:
  CValueReader(CControllableEntity& robot, std::string name)
      : m_robot(robot), m_name(std::move(name)) {}

  void Read(std::size_t /*index*/, SFieldRow row) override {
    if (m_robot.HasController()) {
      row.Numbers[0] = m_robot.GetController().GetRecordedValue(m_name);
    }
  }

 private:
  CControllableEntity& m_robot;
  std::string m_name;
};

class CValueField : public CControllerField {
 private:
  SBoundField BindRobot(CControllableEntity& robot, const std::string& argument) const override {
    SBoundField bound;
    bound.Reader = std::make_unique<CValueReader>(robot, argument);
    bound.Columns = {{ToColumnName(argument), ""}};
    return bound;
  }

  void ListNamesOf(CControllableEntity& robot, const std::string& prefix,
                   std::vector<std::string>& names) const override {
    if (!robot.HasController()) {
      return;
    }
    for (const auto& [name, value] : robot.GetController().GetRecordedValues()) {
      names.push_back(prefix + name);
    }
  }
};

class CCollidingReader : public CFieldReader {
 public:
  explicit CCollidingReader(const CEmbodiedEntity& body) : m_body(body) {}

  void Read(std::size_t /*index*/, SFieldRow row) override {
    row.Numbers[0] = m_body.IsCollidingWithSomething() ? 1.0 : 0.0;
  }

 private:
  const CEmbodiedEntity& m_body;
};

class CCollidingField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    SBoundField bound;
    if (const auto* const body = FindExisting<CEmbodiedEntity>(root)) {
      bound.Reader = std::make_unique<CCollidingReader>(*body);
      bound.Columns = {{"colliding", ""}};
    }
    return bound;
  }
};

/* Reads a property of a robot that is true or false. */
class CFlagReader : public CFieldReader {
 public:
  using TFlag = bool (CControllableEntity::*)() const;

  CFlagReader(const CControllableEntity& robot, TFlag flag) : m_robot(robot), m_flag(flag) {}

  void Read(std::size_t /*index*/, SFieldRow row) override {
    row.Numbers[0] = (m_robot.*m_flag)() ? 1.0 : 0.0;
  }

 private:
  const CControllableEntity& m_robot;
  TFlag m_flag;
};

SBoundField BindFlag(CEntity& root, const char* name, CFlagReader::TFlag flag) {
  SBoundField bound;
  if (auto* const robot = FindExisting<CControllableEntity>(root)) {
    bound.Reader = std::make_unique<CFlagReader>(*robot, flag);
    bound.Columns = {{name, ""}};
  }
  return bound;
}

class CStoppedField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    return BindFlag(root, "stopped", &CControllableEntity::IsStopped);
  }
};

class CQuarantinedField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    return BindFlag(root, "quarantined", &CControllableEntity::IsQuarantined);
  }
};

}  // namespace

REGISTER_FIELD(
    CReadingsField, "readings", "the authors of this project", "1.0",
    "The readings of a sensor: readings:LABEL.",
    R"(LABEL is the tag of the sensor in <sensors>, as in readings:footbot_proximity. Columns
LABEL_1, LABEL_2, ..., one for each number, or LABEL_<name> where the readings have names, in the
units that controllers see. Sensors whose readings are a list give its length, LABEL_count. Sensors
of users' code have columns if they override GetReadingColumns() and CopyReadings().
)",
    "Usable")
REGISTER_FIELD(
    CValueField, "value", "the authors of this project", "1.0",
    "A number that the robot's controller keeps with RecordValue(): value:NAME.",
    R"(Column NAME, empty until the controller calls RecordValue("NAME", number) for the first time
after the start or a reset. Of scripts in Lua, use the field lua.
)",
    "Usable")
REGISTER_FIELD(
    CCollidingField, "colliding", "the authors of this project", "1.0",
    "1 if the body touches another one, else 0.",
    R"(Column colliding: what CEmbodiedEntity::IsCollidingWithSomething() says after the tick.
)",
    "Usable")
REGISTER_FIELD(
    CStoppedField, "stopped", "the authors of this project", "1.0",
    "1 if an error has stopped the robot (on_error), else 0.",
    "Column stopped: 1 from the tick on in which the robot's code has failed, 0 before.\n",
    "Usable")
REGISTER_FIELD(CQuarantinedField, "quarantined", "the authors of this project", "1.0",
               "1 if an error has removed the robot from physics (on_error), else 0.",
               "Column quarantined: 1 if the robot was stopped with on_error=\"quarantine\".\n",
               "Usable")

}  // namespace argos
