#ifndef OWN_MEDIUM_MICROPHONE_SENSOR_H
#define OWN_MEDIUM_MICROPHONE_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>

/** A microphone as controllers see it. */
class CCI_MicrophoneSensor : public argos::CCI_Sensor {
 public:
  argos::Real GetLoudness() const { return m_loudness; }

  // for Lua: robot.microphone.loudness
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
  // for tables: <table fields="readings:microphone" />
  std::vector<SColumn> GetReadingColumns() const override { return {{"loudness", ""}}; }
  void CopyReadings(argos::Real* numbers, std::size_t count) const override {
    CopyNumbers({m_loudness}, numbers, count);
  }

 protected:
  argos::Real m_loudness = 0.0;
};

#endif
