#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_DRAWING_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_DRAWING_DRAWING_H

#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace argos {

/** Font and placement of a text. A view takes the nearest font that it has. */
struct STextStyle {
  enum class EAlignment : UInt8 { Left, Center, Right };

  std::string Family; /**< "" = the view's own; otherwise such as "sans", "serif", "monospace" */
  Real Size = 16.0; /**< side of the letters' em square, pixels, > 0 */
  bool IsBold = false;
  bool IsItalic = false;
  EAlignment Alignment = EAlignment::Left; /**< says which point of each line is at the position */

  friend bool operator==(const STextStyle& a, const STextStyle& b) {
    return a.Family == b.Family && a.Size == b.Size && a.IsBold == b.IsBold &&
           a.IsItalic == b.IsItalic && a.Alignment == b.Alignment;
  }
};

/** One shape of a drawing: plain data, the same for all kinds. Fields that are not listed are 0. */
struct SDrawnShape {
  enum class EKind : UInt8 {
    Point, /**< a disc that faces the viewer: Position; Pixels = diameter */
    Line, /**< Position = start; Size = vector from the start to the end; Pixels = width */
    Polygon, /**< corners in the x-y plane of the shape's frame; Pixels = width of the outline */
    Circle, /**< lies in the x-y plane of the shape's frame; Size.x = radius; Count = number of
               corners if it is a regular polygon, 0 = round; Pixels = width of the outline */
    Cylinder, /**< axis z, Position = centre; Size = (diameter, diameter, height) */
    Box, /**< Position = centre; Size = extents along the axes of its frame */
    Text /**< faces the viewer, before everything else: Position = on the base line */
  };
  enum class ESpace : UInt8 {
    World, /**< positions and sizes in m, world frame */
    Overlay /**< pixels over the picture: x to the right and y down from its upper left corner */
  };

  EKind Kind = EKind::Point;
  ESpace Space = ESpace::World;
  bool IsFilled = true; /**< Polygon and Circle; otherwise only their outline */
  /** Polygon: part of a solid's surface, which hides what is behind it, whatever their order. */
  bool IsFace = false;
  CColor Color;
  CVector3 Position; /**< origin of the shape's frame, see ESpace */
  CQuaternion Orientation; /**< orientation of the shape's frame */
  CVector3 Size;
  Real Pixels = 0.0;
  UInt32 First = 0; /**< Polygon: first of Count corners; Text: first of Count bytes */
  UInt32 Count = 0;
  UInt32 Style = 0; /**< Text: index of its style */
};

/**
 * The list of shapes that users' code adds to one picture, in no view's terms.
 *
 * Functions that draw take positions in the current frame: the world's, or that of the entity which
 * is being drawn; the list holds them in the world frame. It keeps the order of the calls. Shapes
 * with a position or size that is infinite or not a number are left out; a warning names the first.
 *
 * Plain arrays: a view, a recording or another process can take them as they are.
 */
class CDrawing {
 public:
  /** Starts a new picture: removes all shapes, but keeps the memory. @param width, height pixels.
   */
  void Begin(UInt32 width, UInt32 height);

  /** Size of the picture, pixels; 0 if the view has none. */
  UInt32 GetWidth() const { return m_width; }
  UInt32 GetHeight() const { return m_height; }

  /** The frame of what is drawn next, in the world. */
  void SetFrame(const CVector3& position, const CQuaternion& orientation);
  const CVector3& GetFramePosition() const { return m_framePosition; }
  const CQuaternion& GetFrameOrientation() const { return m_frameOrientation; }
  /** Moves the frame: to a pose that is given in it. */
  void MoveFrame(const CVector3& position, const CQuaternion& orientation);
  /** The next shapes are given in the world frame, m. */
  void SetWorldFrame();
  /** The next shapes lie over the picture, see SDrawnShape::ESpace. */
  void SetOverlay();
  bool IsOverlay() const { return m_space == SDrawnShape::ESpace::Overlay; }

  /** @param diameter pixels. */
  void DrawPoint(const CVector3& position, const CColor& color = CColor::RED, Real diameter = 5.0);
  /** @param width pixels. */
  void DrawLine(const CVector3& start, const CVector3& end, const CColor& color = CColor::RED,
                Real width = 1.0);
  /**
   * An isosceles triangle in the x-y plane of its frame, tip towards +x.
   * @param position  the middle of its height.
   */
  void DrawTriangle(const CVector3& position, const CQuaternion& orientation, Real base,
                    Real height, const CColor& color = CColor::RED, bool fill = true);
  /** @param corners in order, in the x-y plane of the frame; fewer than three draw nothing. */
  void DrawPolygon(const CVector3& position, const CQuaternion& orientation,
                   const std::vector<CVector2>& corners, const CColor& color = CColor::RED,
                   bool fill = true);
  /** Part of a solid's surface, see SDrawnShape::IsFace; over the picture nothing. */
  void DrawFace(const CVector3& position, const CQuaternion& orientation,
                const std::vector<CVector2>& corners, const CColor& color = CColor::RED);
  /** The same for a triangle; nothing if it has no area. */
  void DrawFace(const std::array<CVector3, 3>& corners, const CColor& color = CColor::RED);
  /** @param corners 0 = round; otherwise a regular polygon, one corner at +x. */
  void DrawCircle(const CVector3& position, const CQuaternion& orientation, Real radius,
                  const CColor& color = CColor::RED, bool fill = true, UInt32 corners = 0);
  /** @param position the centre; the axis is z of the frame. */
  void DrawCylinder(const CVector3& position, const CQuaternion& orientation, Real radius,
                    Real height, const CColor& color = CColor::RED);
  /** @param position the centre. */
  void DrawBox(const CVector3& position, const CQuaternion& orientation, const CVector3& size,
               const CColor& color = CColor::RED);
  /** @param text UTF-8; a line feed begins a new line below. */
  void DrawText(const CVector3& position, std::string_view text,
                const CColor& color = CColor::BLACK, const STextStyle& style = STextStyle());

  /** In the order of the calls. */
  const std::vector<SDrawnShape>& GetShapes() const { return m_shapes; }
  /** The corners of all polygons, see SDrawnShape::First. */
  const std::vector<CVector2>& GetCorners() const { return m_corners; }
  /** The bytes of all texts, see SDrawnShape::First. */
  const std::string& GetTexts() const { return m_texts; }
  const std::vector<STextStyle>& GetStyles() const { return m_styles; }

  std::string_view GetText(const SDrawnShape& shape) const {
    return std::string_view(m_texts).substr(shape.First, shape.Count);
  }

 private:
  SDrawnShape MakeShape(SDrawnShape::EKind kind, const CVector3& position, const CColor& color);
  void Rotate(SDrawnShape& shape, const CQuaternion& orientation) const;
  // false: left out. sizes: a sum of further numbers that must be finite
  bool Add(const SDrawnShape& shape, Real sizes = 0.0);

  std::vector<SDrawnShape> m_shapes;
  std::vector<CVector2> m_corners;
  std::string m_texts;
  std::vector<STextStyle> m_styles;

  CVector3 m_framePosition;
  CQuaternion m_frameOrientation;
  SDrawnShape::ESpace m_space = SDrawnShape::ESpace::World;
  UInt32 m_width = 0;
  UInt32 m_height = 0;
  bool m_hasWarned = false;
};

}  // namespace argos

#endif
