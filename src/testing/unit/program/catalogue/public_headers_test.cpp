// What comments of headers say of control interfaces.

#include <argos3/program/catalogue/public_headers.h>

#include <argos3/testing/support/temporary_folder.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace argos;

namespace {

constexpr const char* kHeader = R"(#ifndef X_H
#define X_H
#include <vector>

namespace argos {

class CForward;

/**
 * Base of heaters. Temperatures are
 * in K.
 */
template <class READING>
class CHeaterBase : public CCI_Actuator {
 public:
  CHeaterBase();
  ~CHeaterBase() override;
  /** @param power  in W, from 0. @throws CARGoSException if it is negative. */
  virtual void SetPower(Real power) = 0;
  const std::vector<READING>& GetReadings() const { return m_readings; }
  void CreateLuaState(lua_State* state) override;

 protected:
  void Hidden();

 private:
  /** robot.heater.set_power(w) */
  void WriteConstants(CLuaTable& table) override;
  std::vector<READING> m_readings;
};

/** Heats the robot. */
class CCI_HeaterActuator : public CHeaterBase<Real> {
 public:
  /** One measurement. */
  struct SReading {
    Real Temperature = 0.0; /**< K */
    UInt32 Count = 0;  // no comment of the interface
    typedef std::vector<SReading> TList;
    SReading() : Temperature(1.0) {}
  };
  enum EMode {
    MODE_OFF = 0, /**< cold */
    MODE_ON
  };

  /** Switches it off; "{" is no bracket here. */
  void SwitchOff();
};

}  // namespace argos

#endif
)";

}  // namespace

TEST_CASE("public headers: methods of a class and of its bases, with their comments",
          "[core][catalogue]") {
  const CPublicHeaders headers(CPublicHeaders::THeaders{{"argos3/ci_heater_actuator.h", kHeader}});
  const SClassText heater = headers.Describe("CCI_HeaterActuator");
  CHECK(heater.Header == "argos3/ci_heater_actuator.h");
  CHECK(heater.Text == "Heats the robot.");
  REQUIRE(heater.Methods.size() == 3);
  CHECK(heater.Methods[0].Code == "void SwitchOff()");
  CHECK(heater.Methods[0].Text == "Switches it off; \"{\" is no bracket here.");
  CHECK(heater.Methods[1].Code == "void SetPower(Real power)");
  CHECK(heater.Methods[1].Text == "power in W, from 0. throws CARGoSException if it is negative.");
  CHECK(heater.Methods[2].Code == "const std::vector<READING>& GetReadings() const");
  CHECK(heater.Methods[2].Text.empty());
  CHECK(heater.Lua == "robot.heater.set_power(w)\n");
}

TEST_CASE("public headers: types in a class, with the units of their fields", "[core][catalogue]") {
  const CPublicHeaders headers(CPublicHeaders::THeaders{{"argos3/ci_heater_actuator.h", kHeader}});
  const SClassText heater = headers.Describe("CCI_HeaterActuator");
  REQUIRE(heater.Types.size() == 2);
  CHECK(heater.Types[0].Name == "SReading");
  CHECK(heater.Types[0].Text == "One measurement.");
  REQUIRE(heater.Types[0].Fields.size() == 2);
  CHECK(heater.Types[0].Fields[0].Code == "Real Temperature");
  CHECK(heater.Types[0].Fields[0].Text == "K");
  CHECK(heater.Types[0].Fields[1].Text.empty());
  CHECK(heater.Types[1].Name == "EMode");
  REQUIRE(heater.Types[1].Fields.size() == 2);
  CHECK(heater.Types[1].Fields[0].Code == "MODE_OFF");
  CHECK(heater.Types[1].Fields[0].Text == "cold");
  CHECK(heater.Types[1].Fields[1].Code == "MODE_ON");
}

TEST_CASE("public headers: ARGOS_INCLUDE_PATH names further folders", "[core][catalogue]") {
  const CTemporaryFolder folder;
  std::filesystem::create_directory(folder.Path("own"));
  std::ofstream(folder.Path("own/ci_heater_actuator.h")) << kHeader;
  setenv("ARGOS_INCLUDE_PATH", (folder.Path("none") + ":" + folder.GetPath()).c_str(), 1);
  const CPublicHeaders headers;
  unsetenv("ARGOS_INCLUDE_PATH");
  CHECK(headers.Describe("CCI_HeaterActuator").Header == "own/ci_heater_actuator.h");
  // the installation's own
  CHECK(headers.Describe("CCI_LEDsActuator").Header ==
        "argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h");
}

TEST_CASE("public headers: of an unknown class nothing is known", "[core][catalogue]") {
  const CPublicHeaders headers(CPublicHeaders::THeaders{});
  CHECK(headers.Describe("CCI_HeaterActuator").Header.empty());
}

TEST_CASE("public headers: broken text ends the reading", "[core][catalogue]") {
  for (const char* const text : {"class CCI_X {", "/** ", "class CCI_X { /* ", "\"", "#", "("}) {
    CAPTURE(text);
    CHECK_NOTHROW(CPublicHeaders(CPublicHeaders::THeaders{{"x.h", text}}).Describe("CCI_X"));
  }
}
