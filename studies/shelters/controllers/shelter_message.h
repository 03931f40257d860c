#ifndef SHELTER_MESSAGE_H
#define SHELTER_MESSAGE_H

#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/datatypes/datatypes.h>

/**
 * What a shelter broadcasts: 8 bytes.
 *
 * | Byte | |
 * |---|---|
 * | 0 | 1 if the shelter is active, else 0 |
 * | 1, 2 | probability to join, in 1/65535 |
 * | 3, 4 | probability to leave, in 1/1000000 |
 * | 5 | reset signal: 0 for none, else how many more shelters it reaches, one after the other |
 */
struct SShelterMessage {
  static constexpr argos::UInt32 kSize = 8;  // bytes

  bool IsActive = false;
  argos::Real Join = 0.0;  // probability, once for each robot that comes into range
  argos::Real Leave = 0.0;  // probability, per tick
  argos::UInt8 ResetHops = 0;

  static SShelterMessage Read(const argos::CByteArray& bytes) {
    SShelterMessage message;
    message.IsActive = bytes[0] == 1;
    message.Join = (256 * bytes[1] + bytes[2]) / kJoinUnits;
    message.Leave = (256 * bytes[3] + bytes[4]) / kLeaveUnits;
    message.ResetHops = bytes[5];
    return message;
  }

  argos::CByteArray Write() const {
    argos::CByteArray bytes(kSize, 0);
    const auto join = static_cast<argos::UInt16>(Join * kJoinUnits + 0.5);
    const auto leave = static_cast<argos::UInt16>(Leave * kLeaveUnits + 0.5);
    bytes[0] = IsActive ? 1 : 0;
    bytes[1] = static_cast<argos::UInt8>(join / 256);
    bytes[2] = static_cast<argos::UInt8>(join % 256);
    bytes[3] = static_cast<argos::UInt8>(leave / 256);
    bytes[4] = static_cast<argos::UInt8>(leave % 256);
    bytes[5] = ResetHops;
    return bytes;
  }

 private:
  static constexpr argos::Real kJoinUnits = 65535.0;
  static constexpr argos::Real kLeaveUnits = 1e6;
};

#endif
