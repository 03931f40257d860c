#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OVERLAYS_OVERLAY_ATTRIBUTES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OVERLAYS_OVERLAY_ATTRIBUTES_H

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/core/utility/configuration/argos_configuration.h>

#include <string>
#include <string_view>

namespace argos {

/** The attributes `color` and `size` (pixels) of an overlay's texts. */
struct SOverlayText {
  CColor Color = CColor::BLACK; /**< GetInk() replaces it if there is no attribute */
  Real Size = 0.0; /**< pixels; 0: by the height of the picture */
  bool IsBold = false;

  /** @throws CARGoSException if a value is wrong. */
  void Read(TConfigurationNode& node);
  /** The style in a picture. */
  STextStyle MakeStyle(const CDrawing& drawing, STextStyle::EAlignment alignment) const;
};

/** A corner of the picture in which an overlay writes lines of text: attribute `corner`. */
struct SPictureCorner {
  bool IsRight = false;
  bool IsBottom = false;

  /** @throws CARGoSException if the name is unknown. */
  void Read(TConfigurationNode& node);
  /** Base line of a line of text. @param line from 0. @param lines number of all. */
  CVector3 PlaceLine(const CDrawing& drawing, Real size, UInt32 line, UInt32 lines) const;
  STextStyle::EAlignment GetAlignment() const {
    return IsRight ? STextStyle::EAlignment::Right : STextStyle::EAlignment::Left;
  }
};

/** White in a view with `look="dark"`, else black: of texts and lines without a colour. */
CColor GetInk(TConfigurationNode& overlay);

/** Reads the optional attribute `width` (pixels). @throws CARGoSException if it is not > 0. */
void ReadLineWidth(TConfigurationNode& node, Real& width);

/**
 * The beginning of an overlay's manual, up to its optional attributes.
 * @param element  the smallest one. @param more  follows the sentence that says where it is.
 */
std::string OverlayXML(const std::string& element, const std::string& more = "");

/** The greatest of 1, 2 and 5 times a power of ten that is not above a length (m, > 0). */
Real RoundLengthDown(Real length);

/** "0.5 m", "20 cm": a length (m) in its usual unit. */
std::string FormatLength(Real length);

}  // namespace argos

#endif
