#include <argos3/plugins/simulator/outputs/recording/format/drawing_coding.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/plugins/simulator/outputs/recording/format/type_coding.h>

namespace argos {

namespace {

using EKind = SDrawnShape::EKind;
using ESpace = SDrawnShape::ESpace;

// marks of a shape; a reader that knows the first one only takes a face for a filled polygon
constexpr UInt8 kFilled = 1;
constexpr UInt8 kFace = 2;

/* A shape with what it refers to. */
struct SWholeShape {
  SDrawnShape Shape;
  std::vector<CVector2> Corners;
  std::string_view Text;
  STextStyle Style;
};

void WriteColor(const CColor& color, CByteWriter& out) {
  for (const UInt8 part : {color.GetRed(), color.GetGreen(), color.GetBlue(), color.GetAlpha()}) {
    out.WriteByte(part);
  }
}

CColor ReadColor(CByteReader& in) {
  const UInt8 red = in.ReadByte();
  const UInt8 green = in.ReadByte();
  const UInt8 blue = in.ReadByte();
  return CColor(red, green, blue, in.ReadByte());
}

void WriteStyle(const STextStyle& style, CByteWriter& out) {
  out.WriteText(style.Family);
  out.WriteReal(style.Size);
  out.WriteByte(style.IsBold ? 1 : 0);
  out.WriteByte(style.IsItalic ? 1 : 0);
  out.WriteByte(static_cast<UInt8>(style.Alignment));
}

STextStyle ReadStyle(CByteReader& in) {
  STextStyle style;
  style.Family = in.ReadText();
  style.Size = in.ReadReal();
  style.IsBold = in.ReadByte() != 0;
  style.IsItalic = in.ReadByte() != 0;
  style.Alignment = static_cast<STextStyle::EAlignment>(
      in.ReadNumberUpTo(static_cast<UInt64>(STextStyle::EAlignment::Right), "alignment"));
  return style;
}

void WriteShape(const CDrawing& drawing, const SDrawnShape& shape, CByteWriter& out) {
  out.WriteByte(static_cast<UInt8>(shape.Kind));
  out.WriteByte(static_cast<UInt8>(shape.Space));
  out.WriteByte((shape.IsFilled ? kFilled : 0) | (shape.IsFace ? kFace : 0));
  WriteColor(shape.Color, out);
  WriteVector(shape.Position, out);
  WriteVector(shape.Size, out);
  out.WriteReal(shape.Pixels);
  out.WriteNumber(shape.Count);
  for (const Real part : {shape.Orientation.GetW(), shape.Orientation.GetX(),
                          shape.Orientation.GetY(), shape.Orientation.GetZ()}) {
    out.WriteReal(part);
  }
  if (shape.Kind == EKind::Polygon) {
    for (UInt32 i = 0; i < shape.Count; ++i) {
      const CVector2& corner = drawing.GetCorners()[shape.First + i];
      out.WriteReal(corner.GetX());
      out.WriteReal(corner.GetY());
    }
  } else if (shape.Kind == EKind::Text) {
    out.WriteText(drawing.GetText(shape));
    WriteStyle(drawing.GetStyles()[shape.Style], out);
  }
}

SWholeShape ReadShape(CByteReader& in) {
  SWholeShape whole;
  SDrawnShape& shape = whole.Shape;
  shape.Kind =
      static_cast<EKind>(in.ReadNumberUpTo(static_cast<UInt64>(EKind::Text), "kind of shape"));
  shape.Space = static_cast<ESpace>(
      in.ReadNumberUpTo(static_cast<UInt64>(ESpace::Overlay), "space of a shape"));
  const UInt8 marks = in.ReadByte();
  shape.IsFilled = (marks & kFilled) != 0;
  shape.IsFace = (marks & kFace) != 0;
  shape.Color = ReadColor(in);
  shape.Position = ReadVector(in);
  shape.Size = ReadVector(in);
  shape.Pixels = in.ReadReal();
  shape.Count = static_cast<UInt32>(in.ReadNumberUpTo(~UInt32(0), "number of corners"));
  Real w = in.ReadReal();
  Real x = in.ReadReal();
  Real y = in.ReadReal();
  shape.Orientation = CQuaternion(w, x, y, in.ReadReal());
  if (shape.Kind == EKind::Polygon) {
    if (shape.Count > in.GetNumBytesLeft()) {
      THROW_ARGOSEXCEPTION("a drawn polygon has " << shape.Count
                                                  << " corners, which are not there");
    }
    for (UInt32 i = 0; i < shape.Count; ++i) {
      x = in.ReadReal();
      whole.Corners.emplace_back(x, in.ReadReal());
    }
  } else if (shape.Kind == EKind::Text) {
    whole.Text = in.ReadText();
    whole.Style = ReadStyle(in);
  }
  return whole;
}

void Draw(const SWholeShape& whole, CDrawing& drawing) {
  const SDrawnShape& shape = whole.Shape;
  switch (shape.Kind) {
    case EKind::Point:
      drawing.DrawPoint(shape.Position, shape.Color, shape.Pixels);
      break;
    case EKind::Line:
      drawing.DrawLine(shape.Position, shape.Position + shape.Size, shape.Color, shape.Pixels);
      break;
    case EKind::Polygon:
      if (shape.IsFace) {
        drawing.DrawFace(shape.Position, shape.Orientation, whole.Corners, shape.Color);
      } else {
        drawing.DrawPolygon(shape.Position, shape.Orientation, whole.Corners, shape.Color,
                            shape.IsFilled);
      }
      break;
    case EKind::Circle:
      drawing.DrawCircle(shape.Position, shape.Orientation, shape.Size.GetX(), shape.Color,
                         shape.IsFilled, shape.Count);
      break;
    case EKind::Cylinder:
      drawing.DrawCylinder(shape.Position, shape.Orientation, 0.5 * shape.Size.GetX(),
                           shape.Size.GetZ(), shape.Color);
      break;
    case EKind::Box:
      drawing.DrawBox(shape.Position, shape.Orientation, shape.Size, shape.Color);
      break;
    case EKind::Text:
      drawing.DrawText(shape.Position, whole.Text, shape.Color, whole.Style);
      break;
  }
}

}  // namespace

void WriteDrawing(const CDrawing& drawing, CByteWriter& out) {
  for (const SDrawnShape& shape : drawing.GetShapes()) {
    WriteShape(drawing, shape, out);
  }
}

void DrawAgain(CByteReader& in, SDrawnShape::ESpace space, CDrawing& drawing) {
  while (!in.IsAtEnd()) {
    const SWholeShape whole = ReadShape(in);
    if (whole.Shape.Space == space) {
      Draw(whole, drawing);
    }
  }
}

}  // namespace argos
