#ifndef ARGOS3_CORE_UTILITY_DATATYPES_COLOR_H
#define ARGOS3_CORE_UTILITY_DATATYPES_COLOR_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <iostream>
#include <string>

namespace argos {

/**
 * A colour of four channels, each in [0,255]: red, green, blue, and alpha, where 255 is opaque.
 * For LEDs, sensors read alpha as the intensity.
 */
class CColor {
 public:
  // fixed by the file format: experiment files use the names in lower case
  static CColor BLACK;
  static CColor WHITE;
  static CColor RED;
  static CColor GREEN;
  static CColor BLUE;
  static CColor MAGENTA;
  static CColor CYAN;
  static CColor YELLOW;
  static CColor ORANGE;
  static CColor BROWN;
  static CColor PURPLE;
  static CColor GRAY10;
  static CColor GRAY20;
  static CColor GRAY30;
  static CColor GRAY40;
  static CColor GRAY50;
  static CColor GRAY60;
  static CColor GRAY70;
  static CColor GRAY80;
  static CColor GRAY90;

  /** Opaque black. */
  constexpr CColor() = default;

  explicit constexpr CColor(UInt8 red, UInt8 green, UInt8 blue, UInt8 alpha = 255)
      : m_red(red), m_green(green), m_blue(blue), m_alpha(alpha) {}

  /**
   * The brightness 0.299 R + 0.587 G + 0.114 B, in [0,255]; alpha is ignored.
   * Source: ITU-R BT.601, luma coefficients.
   */
  Real ToGrayScale() const { return 0.299 * m_red + 0.587 * m_green + 0.114 * m_blue; }

  UInt8 GetRed() const { return m_red; }
  void SetRed(UInt8 red) { m_red = red; }
  UInt8 GetGreen() const { return m_green; }
  void SetGreen(UInt8 green) { m_green = green; }
  UInt8 GetBlue() const { return m_blue; }
  void SetBlue(UInt8 blue) { m_blue = blue; }
  UInt8 GetAlpha() const { return m_alpha; }
  void SetAlpha(UInt8 alpha) { m_alpha = alpha; }

  void Set(UInt8 red, UInt8 green, UInt8 blue, UInt8 alpha = 255) {
    *this = CColor(red, green, blue, alpha);
  }

  /**
   * @param color  one of the names above in lower case; four integers in [0,255], "R,G,B,A", with
   * blanks allowed around each; or hexadecimal digits, "#rgb", "#rrggbb" or "#rrggbbaa".
   * @throws CARGoSException if it is none of these; the text gives the nearest names. The colour is
   * then unchanged.
   */
  void Set(const std::string& color);

  /**
   * Blends this colour over an opaque background: each channel is the mean of the two, weighted by
   * this colour's alpha and rounded to the nearest integer. The result is opaque.
   */
  CColor Blend(const CColor& background) const;

  /** The bytes R,G,B,A in memory order. */
  operator UInt32();

  bool operator==(const CColor& other) const {
    return m_red == other.m_red && m_green == other.m_green && m_blue == other.m_blue &&
           m_alpha == other.m_alpha;
  }
  bool operator!=(const CColor& other) const { return !(*this == other); }

 private:
  UInt8 m_red = 0;
  UInt8 m_green = 0;
  UInt8 m_blue = 0;
  UInt8 m_alpha = 255;
};

/** Prints the colour's name if it has one, otherwise "R,G,B,A". */
std::ostream& operator<<(std::ostream& stream, const CColor& color);

/**
 * Reads the text that CColor::Set(const std::string&) accepts.
 * @throws CARGoSException as that function does.
 */
std::istream& operator>>(std::istream& stream, CColor& color);

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/string_utilities.h>
#endif

#endif
