#include "horn_actuator.h"

#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/wrappers/lua/lua_table.h>

#include "sound_medium.h"

using namespace argos;

void CCI_HornActuator::CreateLuaState(lua_State* state) {
  CLuaTable horn(state, *this, "horn");
  horn.AddMethod<&CCI_HornActuator::SetVolume>("set_volume", *this);
}

/** The simulated horn. */
class CHornMediumActuator : public CSimulatedActuator, public CCI_HornActuator {
 public:
  // media are destroyed after robots
  ~CHornMediumActuator() override {
    if (m_medium != nullptr) {
      m_medium->Remove(m_horn);
    }
  }

  void SetRobot(CComposableEntity& robot) override {
    m_horn.Body = &robot.GetComponent<CEmbodiedEntity>("body");
  }

  void Init(TConfigurationNode& node) override {
    CCI_HornActuator::Init(node);
    std::string medium;
    GetNodeAttribute(node, "medium", medium);
    m_medium = &CSimulator::GetInstance().GetMedium<CSoundMedium>(medium);
    m_medium->Add(m_horn);
  }

  // called in every tick, before physics; robots act in parallel: only this object is written
  void Update() override { m_horn.Volume = m_volume; }

  void Reset() override { m_horn.Volume = m_volume = 0.0; }

 private:
  CSoundMedium* m_medium = nullptr;
  SHorn m_horn;
};

REGISTER_ACTUATOR(CHornMediumActuator, "horn", "medium", "A. Student", "1.0",
                  "A horn that microphones hear.",
                  "  medium  text, required: the id of a medium <sound>.", "Usable")
