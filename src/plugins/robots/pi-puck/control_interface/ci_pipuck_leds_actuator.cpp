#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_leds_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PiPuckLEDsActuator::CreateLuaState(lua_State* state) {
  CLuaTable leds(state, *this, "leds");
  leds.AddFunction("set_ring_led_index", *this,
                   [](CCI_PiPuckLEDsActuator& self, CLuaArguments& arguments) {
                     const auto led = static_cast<UInt32>(arguments.NextIndex(NUM_RING_LEDS));
                     self.SetRingLEDIndex(led, arguments.Next<bool>());
                     arguments.Finish();
                   });
  leds.AddMethod<&CCI_PiPuckLEDsActuator::SetRingLEDs>("set_ring_leds", *this);
  leds.AddMethod<&CCI_PiPuckLEDsActuator::SetFrontLED>("set_front_led", *this);
  leds.AddMethod<&CCI_PiPuckLEDsActuator::SetBodyLED>("set_body_led", *this);
}

}  // namespace argos
