// Fields of the components that robots share: wheels, LEDs, batteries, range-and-bearing devices.

#include <argos3/core/simulator/outputs/field.h>
#include <argos3/core/simulator/outputs/root_components.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/color.h>
#include <argos3/plugins/simulator/entities/battery_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/rab_equipped_entity.h>
#include <argos3/plugins/simulator/entities/wheeled_entity.h>

#include <algorithm>
#include <string>
#include <utility>

namespace argos {

namespace {

/* Calls a function that copies a component's numbers. */
template <typename COMPONENT>
class CComponentReader : public CFieldReader {
 public:
  using TCopy = void (*)(COMPONENT& component, SFieldRow row);

  CComponentReader(COMPONENT& component, TCopy copy) : m_component(component), m_copy(copy) {}

  void Read(std::size_t /*index*/, SFieldRow row) override { m_copy(m_component, row); }

 private:
  COMPONENT& m_component;
  TCopy m_copy;
};

template <typename COMPONENT>
SBoundField BindComponent(COMPONENT* component, std::vector<SColumn> columns,
                          typename CComponentReader<COMPONENT>::TCopy copy) {
  SBoundField bound;
  if (component != nullptr && !columns.empty()) {
    bound.Reader = std::make_unique<CComponentReader<COMPONENT>>(*component, copy);
    bound.Columns = std::move(columns);
  }
  return bound;
}

std::vector<SColumn> MakeColumns(const std::string& prefix, std::size_t count,
                                 const std::string& unit) {
  std::vector<SColumn> columns;
  for (std::size_t i = 1; i <= count; ++i) {
    columns.push_back({prefix + std::to_string(i), unit});
  }
  return columns;
}

class CWheelsField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    auto* const wheels = FindExisting<CWheeledEntity>(root);
    return BindComponent(
        wheels, MakeColumns("wheel_", wheels != nullptr ? wheels->GetNumWheels() : 0, "m/s"),
        +[](CWheeledEntity& entity, SFieldRow row) {
          std::copy_n(entity.GetWheelVelocities(), entity.GetNumWheels(), row.Numbers);
        });
  }
};

class CLEDsField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    auto* const leds = FindExisting<CLEDEquippedEntity>(root);
    return BindComponent(
        leds, MakeColumns("led_", leds != nullptr ? leds->GetNumLEDs() : 0, "rgb"),
        +[](CLEDEquippedEntity& entity, SFieldRow row) {
          const std::size_t count = entity.GetNumLEDs();
          for (std::size_t i = 0; i < count; ++i) {
            const CColor& color = entity.GetLEDColor(i);
            row.Numbers[i] = color.GetRed() * 65536.0 + color.GetGreen() * 256.0 + color.GetBlue();
          }
        });
  }
};

class CBatteryField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    return BindComponent(
        FindExisting<CBatteryEquippedEntity>(root),
        {{"battery_charge", ""}, {"battery_full_charge", ""}},
        +[](CBatteryEquippedEntity& entity, SFieldRow row) {
          row.Numbers[0] = entity.GetAvailableCharge();
          row.Numbers[1] = entity.GetFullCharge();
        });
  }
};

class CRABField : public CField {
 public:
  SBoundField Bind(CEntity& root, const std::string& /*argument*/) const override {
    return BindComponent(
        FindExisting<CRABEquippedEntity>(root),
        {{"rab_range", "m"}, {"rab_data", "", EColumnKind::Text}},
        +[](CRABEquippedEntity& entity, SFieldRow row) {
          row.Numbers[0] = entity.GetRange();
          row.Numbers[1] =
              row.Texts.AddHexadecimal(entity.GetData().ToCArray(), entity.GetData().Size());
        });
  }
};

}  // namespace

REGISTER_FIELD(
    CWheelsField, "wheels", "the authors of this project", "1.0",
    "Speeds of the wheels over the ground, m/s.",
    R"(Columns wheel_1, wheel_2, ...: the speed of each wheel's rim over the ground, as ordered by
the controller, with the noise of the actuator, m/s, positive forward; the left wheel first. The
order of tick k moves the robot in tick k + 1.
)",
    "Usable")
REGISTER_FIELD(
    CLEDsField, "leds", "the authors of this project", "1.0",
    "The color of each LED, as 65536 red + 256 green + blue.",
    R"(Columns led_1, led_2, ...: red, green and blue, each from 0 to 255, in one whole number, as
in 0xRRGGBB: 16711680 is red, 65280 green, 255 blue, 0 black.
)",
    "Usable")
REGISTER_FIELD(
    CBatteryField, "battery", "the authors of this project", "1.0", "The charge of the battery.",
    R"(Columns battery_charge and battery_full_charge, both in the unit of the experiment file,
where a full battery has 1 by default. A robot has a battery if its element or a battery sensor
asks for it.
)",
    "Usable")
REGISTER_FIELD(
    CRABField, "rab", "the authors of this project", "1.0",
    "What the range-and-bearing device sends.",
    R"(Columns rab_range (m) and rab_data: the bytes of the message, two hexadecimal digits each. A
robot has the device if its controller has a range-and-bearing sensor or actuator. The field
"messages" has what is received.
)",
    "Usable")

}  // namespace argos
