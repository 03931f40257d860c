#include "microphone_sensor.h"

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include "sound_medium.h"

using namespace argos;

void CCI_MicrophoneSensor::CreateLuaState(lua_State* state) {
  CLuaTable microphone(state, *this, "microphone");
  microphone.Set("loudness", m_loudness);
}

void CCI_MicrophoneSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable microphone(state, *this);
  microphone.Set("loudness", m_loudness);
}

/** The simulated microphone. */
class CMicrophoneMediumSensor : public CSimulatedSensor, public CCI_MicrophoneSensor {
 public:
  void SetRobot(CComposableEntity& robot) override {
    m_body = &robot.GetComponent<CEmbodiedEntity>("body");
  }

  void Init(TConfigurationNode& node) override {
    CCI_MicrophoneSensor::Init(node);
    std::string medium;
    GetNodeAttribute(node, "medium", medium);
    m_medium = &CSimulator::GetInstance().GetMedium<CSoundMedium>(medium);
  }

  void Update() override { m_loudness = m_medium->ComputeLoudness(*m_body); }

  void Reset() override { m_loudness = 0.0; }

 private:
  const CSoundMedium* m_medium = nullptr;
  const CEmbodiedEntity* m_body = nullptr;
};

REGISTER_SENSOR(CMicrophoneMediumSensor, "microphone", "medium", "A. Student", "1.0",
                "Hears the horns of other robots.",
                "  medium  text, required: the id of a medium <sound>.", "Usable")
