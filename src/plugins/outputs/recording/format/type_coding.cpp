#include <argos3/plugins/simulator/outputs/recording/format/type_coding.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <utility>

namespace argos {

namespace {

constexpr UInt32 kMaxLEDs = 1 << 16;  // number of an entity's LEDs

enum ETypeFlags : UInt8 { IS_ROBOT = 1, IS_MOVABLE = 2, FLIES = 4, HAS_APPEARANCE = 8 };

UInt8 ReadKind(CByteReader& in, UInt8 last, const char* what) {
  return static_cast<UInt8>(in.ReadNumberUpTo(last, what));
}

void WritePart(const SVisualPart& part, CByteWriter& out) {
  out.WriteByte(static_cast<UInt8>(part.Kind));
  WriteVector(part.Position, out);
  WriteQuaternion(part.Orientation, out);
  WriteVector(part.Size, out);
  out.WriteFixed32(PackColor(part.Color));
  out.WriteText(part.Anchor);
  // a number that older readers read and ignore: only LEDs have numbers
  out.WriteNumber(part.Kind == SVisualPart::EKind::LED ? part.LED
                                                       : static_cast<UInt32>(part.Material));
}

SVisualPart ReadPart(CByteReader& in) {
  SVisualPart part;
  part.Kind = static_cast<SVisualPart::EKind>(
      ReadKind(in, static_cast<UInt8>(SVisualPart::EKind::LED), "kind of a part"));
  part.Position = ReadVector(in);
  part.Orientation = ReadQuaternion(in);
  part.Size = ReadVector(in);
  part.Color = UnpackColor(in.ReadFixed32());
  part.Anchor = in.ReadText();
  const auto number = static_cast<UInt32>(in.ReadNumberUpTo(kMaxLEDs, "number of an LED"));
  if (part.Kind == SVisualPart::EKind::LED) {
    part.LED = number;
  } else if (number < static_cast<UInt32>(EMaterial::Count)) {
    part.Material = static_cast<EMaterial>(number);
  }
  return part;
}

void WriteSolid(const SShapeDescription& solid, CByteWriter& out) {
  out.WriteByte(static_cast<UInt8>(solid.Kind));
  WriteVector(solid.Offset, out);
  WriteQuaternion(solid.Orientation, out);
  WriteVector(solid.Size, out);
  out.WriteReal(solid.Radius);
  out.WriteNumber(solid.Vertices != nullptr ? solid.Vertices->size() : 0);
  if (solid.Vertices != nullptr) {
    for (const CVector2& vertex : *solid.Vertices) {
      out.WriteReal(vertex.GetX());
      out.WriteReal(vertex.GetY());
    }
  }
}

SShapeDescription ReadSolid(CByteReader& in) {
  using EKind = SShapeDescription::EKind;
  SShapeDescription solid;
  solid.Kind = static_cast<EKind>(
      ReadKind(in, static_cast<UInt8>(SShapeDescription::EKind::Prism), "kind of a solid"));
  solid.Offset = ReadVector(in);
  solid.Orientation = ReadQuaternion(in);
  solid.Size = ReadVector(in);
  solid.Radius = in.ReadReal();
  std::vector<CVector2> vertices;
  for (size_t count = in.ReadCount("number of corners"); count > 0; --count) {
    const Real x = in.ReadReal();
    vertices.emplace_back(x, in.ReadReal());
  }
  if ((solid.Kind == EKind::Prism) != (vertices.size() >= 3)) {
    THROW_ARGOSEXCEPTION("a solid has " << vertices.size() << " corners");
  }
  if (!vertices.empty()) {
    solid.Vertices = std::make_shared<const std::vector<CVector2>>(std::move(vertices));
  }
  return solid;
}

}  // namespace

void WriteSolids(const SRecordedType& type, CByteWriter& out) {
  out.WriteNumber(type.Solids.size());
  for (const SShapeDescription& solid : type.Solids) {
    WriteSolid(solid, out);
  }
}

void ReadSolids(SRecordedType& type, CByteReader& in) {
  for (size_t count = in.ReadCount("number of solids"); count > 0; --count) {
    type.Solids.push_back(ReadSolid(in));
  }
}

void WriteVector(const CVector3& vector, CByteWriter& out) {
  out.WriteReal(vector.GetX());
  out.WriteReal(vector.GetY());
  out.WriteReal(vector.GetZ());
}

CVector3 ReadVector(CByteReader& in) {
  const Real x = in.ReadReal();
  const Real y = in.ReadReal();
  return CVector3(x, y, in.ReadReal());
}

void WriteQuaternion(const CQuaternion& quaternion, CByteWriter& out) {
  out.WriteReal(quaternion.GetW());
  WriteVector(CVector3(quaternion.GetX(), quaternion.GetY(), quaternion.GetZ()), out);
}

CQuaternion ReadQuaternion(CByteReader& in) {
  const Real w = in.ReadReal();
  const CVector3 axis = ReadVector(in);
  return CQuaternion(w, axis.GetX(), axis.GetY(), axis.GetZ());
}

void WriteType(const SRecordedType& type, CByteWriter& out) {
  out.WriteByte(static_cast<UInt8>(type.Kind));
  out.WriteText(type.Tag);
  out.WriteByte(static_cast<UInt8>((type.IsRobot ? IS_ROBOT : 0) |
                                   (type.IsMovable ? IS_MOVABLE : 0) | (type.Flies ? FLIES : 0) |
                                   (type.HasAppearance ? HAS_APPEARANCE : 0)));
  out.WriteNumber(type.Parameter);
  out.WriteNumber(type.NumLEDs);
  WriteVector(type.Box.MinCorner, out);
  WriteVector(type.Box.MaxCorner, out);
  out.WriteNumber(type.Appearance.Parts.size());
  for (const SVisualPart& part : type.Appearance.Parts) {
    WritePart(part, out);
  }
  out.WriteNumber(type.Anchors.size());
  for (const std::string& anchor : type.Anchors) {
    out.WriteText(anchor);
  }
}

SRecordedType ReadType(CByteReader& in) {
  SRecordedType type;
  type.Kind = static_cast<SRecordedType::EKind>(
      ReadKind(in, static_cast<UInt8>(SRecordedType::EKind::Other), "kind of a type"));
  type.Tag = in.ReadText();
  const UInt8 flags = in.ReadByte();
  type.IsRobot = (flags & IS_ROBOT) != 0;
  type.IsMovable = (flags & IS_MOVABLE) != 0;
  type.Flies = (flags & FLIES) != 0;
  type.HasAppearance = (flags & HAS_APPEARANCE) != 0;
  type.Parameter = in.ReadNumber();
  type.NumLEDs = static_cast<UInt32>(in.ReadNumberUpTo(kMaxLEDs, "number of LEDs"));
  type.Box.MinCorner = ReadVector(in);
  type.Box.MaxCorner = ReadVector(in);
  for (size_t parts = in.ReadCount("number of parts"); parts > 0; --parts) {
    type.Appearance.Parts.push_back(ReadPart(in));
  }
  for (size_t anchors = in.ReadCount("number of anchors"); anchors > 0; --anchors) {
    type.Anchors.emplace_back(in.ReadText());
  }
  return type;
}

}  // namespace argos
