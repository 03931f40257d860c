#ifndef ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_TYPE_CODING_H
#define ARGOS3_PLUGINS_OUTPUTS_RECORDING_FORMAT_TYPE_CODING_H

#include <argos3/plugins/simulator/outputs/recording/format/recorded_frame.h>
#include <argos3/support/byte_stream.h>

namespace argos {

/** Writes all of a type but its solids. Equal types give equal bytes. */
void WriteType(const SRecordedType& type, CByteWriter& out);
/** @throws CARGoSException if the bytes describe no type. */
SRecordedType ReadType(CByteReader& in);

/** The same for the solids of a type, which older versions do not have. */
void WriteSolids(const SRecordedType& type, CByteWriter& out);
void ReadSolids(SRecordedType& type, CByteReader& in);

void WriteVector(const CVector3& vector, CByteWriter& out);
CVector3 ReadVector(CByteReader& in);
void WriteQuaternion(const CQuaternion& quaternion, CByteWriter& out);
CQuaternion ReadQuaternion(CByteReader& in);

}  // namespace argos

#endif
