#include <argos3/plugins/simulator/entities/battery_discharge_models.h>

#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

namespace {

void ReadRate(TConfigurationNode& battery, const std::string& attribute, Real& rate) {
  GetNodeAttributeOrDefault(battery, attribute, rate, rate);
  RequireNotNegative(rate, OwnerOf(battery), attribute);
}

void SetRate(Real value, const std::string& name, Real& rate) {
  RequireNotNegative(value, "discharge model of a battery", name);
  rate = value;
}

}  // namespace

void CBatteryDischargeModelTime::Init(TConfigurationNode& battery) {
  ReadRate(battery, "delta", m_delta);
}

void CBatteryDischargeModelTime::operator()() {
  m_pcBattery->Discharge(m_delta);
}

void CBatteryDischargeModelTime::SetDelta(Real delta) {
  SetRate(delta, "delta", m_delta);
}

void CBatteryDischargeModelMotion::Init(TConfigurationNode& battery) {
  ReadRate(battery, "pos_delta", m_positionDelta);
  ReadRate(battery, "orient_delta", m_orientationDelta);
}

void CBatteryDischargeModelMotion::operator()() {
  m_pcBattery->Discharge(m_positionDelta * m_pcBattery->ComputeDistanceMoved() +
                         m_orientationDelta * m_pcBattery->ComputeAngleTurned().GetValue());
}

void CBatteryDischargeModelMotion::SetPosFactor(Real factor) {
  SetRate(factor, "position factor", m_positionDelta);
}

void CBatteryDischargeModelMotion::SetOrientFactor(Real factor) {
  SetRate(factor, "orientation factor", m_orientationDelta);
}

void CBatteryDischargeModelTimeMotion::Init(TConfigurationNode& battery) {
  ReadRate(battery, "time_factor", m_timeFactor);
  ReadRate(battery, "pos_factor", m_positionFactor);
  ReadRate(battery, "orient_factor", m_orientationFactor);
}

void CBatteryDischargeModelTimeMotion::operator()() {
  m_pcBattery->Discharge(m_timeFactor + m_positionFactor * m_pcBattery->ComputeDistanceMoved() +
                         m_orientationFactor * m_pcBattery->ComputeAngleTurned().GetValue());
}

void CBatteryDischargeModelTimeMotion::SetDelta(Real delta) {
  SetRate(delta, "delta", m_timeFactor);
}

void CBatteryDischargeModelTimeMotion::SetPosFactor(Real factor) {
  SetRate(factor, "position factor", m_positionFactor);
}

void CBatteryDischargeModelTimeMotion::SetOrientFactor(Real factor) {
  SetRate(factor, "orientation factor", m_orientationFactor);
}

REGISTER_BATTERY_DISCHARGE_MODEL(CBatteryDischargeModelTime, "time")
REGISTER_BATTERY_DISCHARGE_MODEL(CBatteryDischargeModelMotion, "motion")
REGISTER_BATTERY_DISCHARGE_MODEL(CBatteryDischargeModelTimeMotion, "time_motion")

}  // namespace argos
