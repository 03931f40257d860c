#include <argos3/testing/support/device_user.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ceiling_attachment_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_directional_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_led_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_camera_sensor_tag_detector_algorithm.h>
#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_perspective_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_directional_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_gripper_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_magnets_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_pheromone_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_speed_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_range_and_bearing_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_rfid_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_tags_actuator.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kSpeed = 10.0;  // cm/s
constexpr Real kFlightStep = 0.05;  // m
constexpr UInt32 kTurretPhase = 8;  // number of steps in one mode

// stripes in both directions, 2 cm wide
class CStripedFloor : public CLoopFunctions {
 public:
  CColor GetFloorColor(const CVector2& point) override {
    const auto stripe = [](Real at, UInt32 step) {
      return static_cast<UInt8>(step * static_cast<UInt32>(static_cast<SInt32>(50.0 * at) + 10000));
    };
    return CColor(stripe(point.GetX(), 37), stripe(point.GetY(), 91), 99);
  }
};

}  // namespace

template <typename SENSOR, typename READ>
void CDeviceUser::Sense(const std::string& tag, READ read) {
  if (HasSensor(tag)) {
    auto* const sensor = GetSensor<SENSOR>(tag);
    sensor->Enable();
    m_senses.push_back([read, sensor] { read(*sensor); });
  }
}

template <typename SENSOR>
void CDeviceUser::SenseNumbers(const std::string& tag) {
  Sense<SENSOR>(tag, [this](const SENSOR& sensor) {
    for (const Real reading : sensor.GetReadings()) {
      AddReading(reading);
    }
  });
}

template <typename SENSOR>
void CDeviceUser::SenseValues(const std::string& tag) {
  Sense<SENSOR>(tag, [this](const SENSOR& sensor) {
    for (const auto& reading : sensor.GetReadings()) {
      AddReading(reading.Value);
    }
  });
}

template <typename ACTUATOR, typename ORDER>
void CDeviceUser::Order(const std::string& tag, ORDER order) {
  if (HasActuator(tag)) {
    m_orders.push_back([order, actuator = GetActuator<ACTUATOR>(tag)] { order(*actuator); });
  }
}

void CDeviceUser::AddReading(Real reading) {
  m_readingsDigest.Add(reading);
  m_sum += reading;
}

void CDeviceUser::Init(TConfigurationNode& params) {
  GetNodeAttributeOrDefault(params, "reads", m_reads, m_reads);
  UInt32 radioBytes = 8;
  GetNodeAttributeOrDefault(params, "radio_bytes", radioBytes, radioBytes);
  m_radioMessage.Resize(radioBytes);
  m_tagData.Resize(2);
  UseRings();
  UseCameras();
  UseRadios();
  UseTagsAndPheromones();
  UseBodySensors();
  UseMotors();
  UseGrips();
  UseLights();
  CheckAllUsed();
}

void CDeviceUser::CheckAllUsed() const {
  if (m_senses.size() == m_mapSensors.size() && m_orders.size() == m_mapActuators.size()) {
    return;
  }
  std::string devices;
  for (const auto& device : m_mapActuators) {
    devices += " " + device.first;
  }
  for (const auto& device : m_mapSensors) {
    devices += " " + device.first;
  }
  THROW_ARGOSEXCEPTION("device_user knows how to use "
                       << m_orders.size() << " of " << m_mapActuators.size() << " actuators and "
                       << m_senses.size() << " of " << m_mapSensors.size()
                       << " sensors of these; add the rest to device_user.cpp:" << devices);
}

void CDeviceUser::Reset() {
  m_readingsDigest = CDigest();
  m_signal = 0.0;
  m_step = 0;
}

size_t CDeviceUser::CountSeen() {
  const CDigest felt = m_readingsDigest;
  m_seen = 0;
  for (const auto& sense : m_senses) {
    sense();
  }
  m_readingsDigest = felt;
  return m_seen;
}

void CDeviceUser::ControlStep() {
  ++m_step;
  if (m_reads) {
    m_sum = 0.0;
    m_seen = 0;
    for (const auto& sense : m_senses) {
      sense();
    }
    m_signal = std::sin(m_sum);
  } else {
    m_signal = std::sin(0.1 * m_step);
  }
  for (const auto& order : m_orders) {
    order();
  }
}

void CDeviceUser::UseRings() {
  SenseNumbers<CCI_ProximitySensor>("proximity");
  SenseValues<CCI_FootBotProximitySensor>("footbot_proximity");
  SenseValues<CCI_EyeBotProximitySensor>("eyebot_proximity");
  SenseValues<CCI_EPuckProximitySensor>("epuck_proximity");
  SenseNumbers<CCI_LightSensor>("light");
  SenseValues<CCI_FootBotLightSensor>("footbot_light");
  SenseValues<CCI_EyeBotLightSensor>("eyebot_light");
  SenseNumbers<CCI_GroundSensor>("ground");
  SenseValues<CCI_FootBotMotorGroundSensor>("footbot_motor_ground");
  SenseValues<CCI_FootBotBaseGroundSensor>("footbot_base_ground");
  Sense<CCI_FootBotDistanceScannerSensor>(
      "footbot_distance_scanner", [this](CCI_FootBotDistanceScannerSensor& sensor) {
        for (const auto& [angle, distance] : sensor.GetReadingsMap()) {
          AddReading(angle.GetValue() * distance);
          m_seen += distance >= 0.0 ? 1 : 0;
        }
      });
}

void CDeviceUser::UseCameras() {
  const auto feelColor = [this](const CColor& color) {
    AddReading(color.GetRed() + 3.0 * color.GetGreen() + 5.0 * color.GetBlue());
    ++m_seen;
  };
  const auto feelPixel = [this](const CVector2& pixel) {
    AddReading(1e-3 * pixel.GetX());
    AddReading(1e-3 * pixel.GetY());
  };
  Sense<CCI_ColoredBlobOmnidirectionalCameraSensor>(
      "colored_blob_omnidirectional_camera", [this, feelColor](const auto& sensor) {
        for (const auto* blob : sensor.GetReadings().BlobList) {
          feelColor(blob->Color);
          AddReading(blob->Angle.GetValue() + 1e-2 * blob->Distance);
        }
      });
  Sense<CCI_ColoredBlobPerspectiveCameraSensor>(
      "colored_blob_perspective_camera", [this, feelColor](const auto& sensor) {
        for (const auto* blob : sensor.GetReadings().BlobList) {
          feelColor(blob->Color);
          AddReading(1e-3 * (blob->X + 2 * blob->Y));
        }
      });
  const auto feelDetected = [this, feelColor, feelPixel](const auto* algorithm) {
    using TLEDs = CCI_CameraSensorLEDDetectorAlgorithm;
    using TSignals = CCI_CameraSensorDirectionalLEDDetectorAlgorithm;
    using TTags = CCI_CameraSensorTagDetectorAlgorithm;
    if (const auto* leds = dynamic_cast<const TLEDs*>(algorithm)) {
      for (const auto& reading : leds->GetReadings()) {
        feelColor(reading.Color);
        feelPixel(reading.Center);
      }
    } else if (const auto* signals = dynamic_cast<const TSignals*>(algorithm)) {
      for (const auto& reading : signals->GetReadings()) {
        feelColor(reading.Color);
        feelPixel(reading.Center);
      }
    } else if (const auto* tags = dynamic_cast<const TTags*>(algorithm)) {
      for (const auto& reading : tags->GetReadings()) {
        AddReading(static_cast<Real>(reading.Payload.size()));
        feelPixel(reading.Corners[1]);
        ++m_seen;
      }
    }
  };
  Sense<CCI_CameraSensor>("cameras", [feelDetected](const CCI_CameraSensor& sensor) {
    for (const auto& camera : sensor.GetInterfaces()) {
      for (const auto* algorithm : camera.Algorithms) {
        feelDetected(algorithm);
      }
    }
  });
}

void CDeviceUser::UseRadios() {
  Sense<CCI_RangeAndBearingSensor>("range_and_bearing", [this](const auto& sensor) {
    for (const auto& packet : sensor.GetReadings()) {
      AddReading(1e-2 * packet.Range + packet.HorizontalBearing.GetValue());
      AddReading(packet.VerticalBearing.GetValue() + packet.Data[0] + 0.5 * packet.Data[3]);
      ++m_seen;
    }
  });
  Sense<CCI_SimpleRadiosSensor>("simple_radios", [this](const CCI_SimpleRadiosSensor& sensor) {
    for (const auto& radio : sensor.GetInterfaces()) {
      for (const CByteArray& message : radio.Messages) {
        AddReading(message.Empty() ? 1.0 : message[0]);
        ++m_seen;
      }
    }
  });
  Order<CCI_RangeAndBearingActuator>("range_and_bearing", [this](auto& actuator) {
    actuator.SetData(0, static_cast<UInt8>(100.0 + 100.0 * m_signal));
    actuator.SetData(3, static_cast<UInt8>(m_step));
  });
  Order<CCI_SimpleRadiosActuator>("simple_radios", [this](CCI_SimpleRadiosActuator& actuator) {
    if (!m_radioMessage.Empty()) {
      m_radioMessage[0] = static_cast<UInt8>(100.0 + 100.0 * m_signal);
    }
    for (auto& radio : actuator.GetInterfaces()) {
      radio.Messages.push_back(m_radioMessage);
    }
  });
}

// uses RFID tags and pheromones
void CDeviceUser::UseTagsAndPheromones() {
  Sense<CCI_RFIDSensor>("rfid", [this](const CCI_RFIDSensor& sensor) {
    for (const auto& reading : sensor.GetReadings()) {
      AddReading(1e-2 * reading.Distance + reading.Angle.GetValue());
      AddReading(reading.Data[0] + 0.5 * reading.Data[1]);
      ++m_seen;
    }
  });
  Sense<CCI_PheromoneSensor>("pheromone", [this](const CCI_PheromoneSensor& sensor) {
    for (const auto& layer : sensor.GetInterfaces()) {
      for (const auto& reading : layer.Readings) {
        AddReading(reading.Value);
      }
    }
  });
  Order<CCI_RFIDActuator>("rfid", [this](CCI_RFIDActuator& actuator) {
    m_tagData[0] = static_cast<UInt8>(100.0 + 100.0 * m_signal);
    m_tagData[1] = static_cast<UInt8>(m_step);
    actuator.Write(m_tagData);
  });
  Order<CCI_PheromoneActuator>(
      "pheromone", [this](CCI_PheromoneActuator& actuator) { actuator.SetRate(1.0 + m_signal); });
}

void CDeviceUser::UseBodySensors() {
  Sense<CCI_AltitudeSensor>("altitude",
                            [this](const auto& sensor) { AddReading(sensor.GetReading()); });
  Sense<CCI_BatterySensor>("battery", [this](const CCI_BatterySensor& sensor) {
    AddReading(sensor.GetReading().AvailableCharge);
    // TimeLeft may be infinite
    m_readingsDigest.Add(sensor.GetReading().TimeLeft);
  });
  Sense<CCI_ClockSensor>("clock",
                         [this](const auto& sensor) { AddReading(sensor.GetReading().Time); });
  Sense<CCI_DifferentialSteeringSensor>("differential_steering", [this](const auto& sensor) {
    AddReading(sensor.GetReading().VelocityLeftWheel);
    AddReading(sensor.GetReading().CoveredDistanceRightWheel);
  });
  Sense<CCI_FootBotEncoderSensor>("footbot_encoder", [this](const auto& sensor) {
    AddReading(sensor.GetReading().CoveredDistanceLeftWheel);
    AddReading(sensor.GetReading().CoveredDistanceRightWheel);
  });
  Sense<CCI_FootBotTurretEncoderSensor>("footbot_turret_encoder", [this](const auto& sensor) {
    AddReading(sensor.GetRotation().GetValue());
  });
  Sense<CCI_PositioningSensor>("positioning", [this](const CCI_PositioningSensor& sensor) {
    const CVector3& position = sensor.GetReading().Position;
    AddReading(position.GetX() + 2.0 * position.GetY() + 3.0 * position.GetZ());
    AddReading(sensor.GetReading().Orientation.GetZ());
  });
}

void CDeviceUser::UseMotors() {
  Order<CCI_DifferentialSteeringActuator>("differential_steering", [this](auto& actuator) {
    actuator.SetLinearVelocity(0.5 * kSpeed * (1.0 - m_signal), 0.5 * kSpeed * (1.0 + m_signal));
  });
  Order<CCI_FootBotDistanceScannerActuator>("footbot_distance_scanner", [this](auto& actuator) {
    actuator.SetRPM(30.0 + 10.0 * m_signal);
  });
  Order<CCI_PanTiltCameraActuator>("pan_tilt_camera", [this](auto& actuator) {
    actuator.SetPan(CRadians(0.5 * m_signal));
    actuator.SetTilt(CRadians(0.1 * m_signal));
  });
  Order<CCI_QuadRotorPositionActuator>("quadrotor_position", [this](auto& actuator) {
    actuator.SetRelativePosition(CVector3(kFlightStep, kFlightStep * m_signal, 0.0));
    actuator.SetRelativeYaw(CRadians(0.1 * m_signal));
  });
  Order<CCI_QuadRotorSpeedActuator>("quadrotor_speed", [this](auto& actuator) {
    actuator.SetLinearVelocity(CVector3(kFlightStep, kFlightStep * m_signal, 0.0));
    actuator.SetRotationalSpeed(CRadians(m_signal));
  });
}

void CDeviceUser::UseGrips() {
  Order<CCI_CeilingAttachmentActuator>("ceiling_attachment", [this](auto& actuator) {
    m_signal > -0.5 ? actuator.Attach() : actuator.Detach();
  });
  Order<CCI_FootBotGripperActuator>("footbot_gripper", [this](auto& actuator) {
    m_signal > -0.5 ? actuator.LockPositive() : actuator.Unlock();
  });
  Order<CCI_GripperActuator>(
      "gripper", [this](auto& actuator) { m_signal > -0.5 ? actuator.Lock() : actuator.Unlock(); });
  Order<CCI_FootBotTurretActuator>("footbot_turret", [this](auto& actuator) {
    const UInt32 phase = (m_step / kTurretPhase) % 3;
    if (phase == 0) {
      actuator.SetSpeedControlMode();
      actuator.SetRotationSpeed(m_signal > 0.0 ? 3 : -2);
    } else if (phase == 1) {
      actuator.SetActiveWithRotation(CRadians(m_signal));
    } else {
      actuator.SetPassiveMode();
    }
  });
  Order<CCI_MagnetsActuator>("magnets", [this](CCI_MagnetsActuator& actuator) {
    for (auto& magnet : actuator.GetInterfaces()) {
      magnet.Current = m_signal;
    }
  });
}

void CDeviceUser::UseLights() {
  // one LED is always lit, in one of two colours, and another one at times
  const auto light = [this](auto& actuator, UInt32 numLEDs) {
    actuator.SetSingleColor(numLEDs - 1, m_signal > 0.0 ? CColor::RED : CColor::GREEN);
    actuator.SetSingleColor(0, m_step % 4 == 0 ? CColor::BLUE : CColor::BLACK);
  };
  Order<CCI_LEDsActuator>("leds", [light](auto& actuator) {
    light(actuator, static_cast<UInt32>(actuator.GetNumLEDs()));
  });
  Order<CCI_DirectionalLEDsActuator>("directional_leds", [light](auto& actuator) {
    light(actuator, static_cast<UInt32>(actuator.GetNumLEDs()));
  });
  Order<CCI_TagsActuator>("tags", [this](auto& actuator) {
    static const std::string kPositive = "positive";
    static const std::string kNegative = "negative, with a long text";
    actuator.SetAllPayloads(m_signal > 0.0 ? kPositive : kNegative);
  });
}

REGISTER_LOOP_FUNCTIONS(CStripedFloor, "striped_floor")

}  // namespace argos

using argos::CDeviceUser;
REGISTER_CONTROLLER(CDeviceUser, "device_user")
