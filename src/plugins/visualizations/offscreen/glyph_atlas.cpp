#include <argos3/plugins/simulator/visualizations/offscreen/glyph_atlas.h>

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_SYNTHESIS_H

#include <algorithm>
#include <cmath>
#include <string_view>

namespace argos {

namespace {

constexpr double kContourReach = 1.6;  // width of the contour, pixels, at scale 1
constexpr int kMinText = 4;  // pixels
constexpr int kMaxText = 512;  // pixels
constexpr double kLineDistance = 1.2;  // em
constexpr int kGap = 1;  // pixels between bitmaps
constexpr char32_t kInvalid = 0xFFFD;  // the replacement character
constexpr double kBrightText = 150.0;  // 0 to 255; brighter text has a dark contour
constexpr SRgba kLightContour = {255, 255, 255, 215};
constexpr SRgba kDarkContour = {16, 18, 22, 215};

// two of each family: regular and bold
constexpr std::array<const char*, 6> kFontFiles = {"DejaVuSans.ttf",     "DejaVuSans-Bold.ttf",
                                                   "DejaVuSansMono.ttf", "DejaVuSansMono-Bold.ttf",
                                                   "DejaVuSerif.ttf",    "DejaVuSerif-Bold.ttf"};

std::size_t ChooseFont(const STextStyle& style) {
  const std::string family = StringToLowerCase(style.Family);
  const auto has = [&family](const char* part) { return family.find(part) != std::string::npos; };
  std::size_t font = 0;
  if (has("mono") || has("courier") || has("consol") || has("typewriter")) {
    font = 2;
  } else if (has("times") || has("roman") || (has("serif") && !has("sans"))) {
    font = 4;
  }
  return font + (style.IsBold ? 1 : 0);
}

// takes the first character of UTF-8; malformed bytes give the replacement character
char32_t TakeCharacter(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (first < 0x80) {
    return first;
  }
  const int following = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : -1;
  if (following < 0 || first > 0xF4) {
    return kInvalid;
  }
  char32_t character = first & (0x3FU >> following);
  for (int i = 0; i < following; ++i) {
    if (text.empty() || (static_cast<unsigned char>(text.front()) & 0xC0U) != 0x80U) {
      return kInvalid;
    }
    character = (character << 6U) | (static_cast<unsigned char>(text.front()) & 0x3FU);
    text.remove_prefix(1);
  }
  return character;
}

std::vector<std::u32string> SplitLines(std::string_view text) {
  std::vector<std::u32string> lines(1);
  while (!text.empty()) {
    const char32_t character = TakeCharacter(text);
    if (character == U'\n') {
      lines.emplace_back();
    } else if (character != U'\r') {
      lines.back().push_back(character);
    }
  }
  return lines;
}

// the letter grown by a disc, with a soft border
std::vector<std::uint8_t> MakeContour(const std::vector<std::uint8_t>& letter, int width,
                                      int height, double reach) {
  const int margin = static_cast<int>(std::ceil(reach));
  const int outerWidth = width + 2 * margin;
  const int outerHeight = height + 2 * margin;
  const auto indexOf = [](int row, int column, int rowLength) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(rowLength) +
           static_cast<std::size_t>(column);
  };
  std::vector<std::uint8_t> contour(indexOf(outerHeight, 0, outerWidth), 0);
  for (int dy = -margin; dy <= margin; ++dy) {
    for (int dx = -margin; dx <= margin; ++dx) {
      const double share = std::clamp(reach + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
      for (int y = 0; share > 0.0 && y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          std::uint8_t& pixel = contour[indexOf(y + margin + dy, x + margin + dx, outerWidth)];
          const double grown = share * letter[indexOf(y, x, width)];
          pixel = std::max(pixel, static_cast<std::uint8_t>(grown));
        }
      }
    }
  }
  return contour;
}

SRgba ChooseContour(const SRgba& color) {
  const Real brightness = CColor(color.R, color.G, color.B).ToGrayScale();
  SRgba contour = brightness > kBrightText ? kDarkContour : kLightContour;
  contour.A = static_cast<std::uint8_t>(contour.A * color.A / 255);
  return contour;
}

}  // namespace

struct CGlyphAtlas::SFonts {
  SFonts() {
    if (FT_Init_FreeType(&Library) != 0) {
      THROW_ARGOSEXCEPTION("Text cannot be drawn: FreeType does not start");
    }
  }
  ~SFonts() { FT_Done_FreeType(Library); }
  SFonts(const SFonts&) = delete;
  SFonts& operator=(const SFonts&) = delete;

  FT_Face Get(std::size_t font) {
    FT_Face& face = Faces[font];
    if (face == nullptr) {
      const std::string file = std::string(ARGOS_FONT_DIRECTORY "/") + kFontFiles[font];
      if (FT_New_Face(Library, file.c_str(), 0, &face) != 0) {
        face = nullptr;
        THROW_ARGOSEXCEPTION("Text cannot be drawn: the font \""
                             << file << "\" cannot be read; install it (Debian: apt-get install "
                             << "fonts-dejavu-core)");
      }
    }
    return face;
  }

  FT_Library Library = nullptr;
  std::array<FT_Face, kFontFiles.size()> Faces{};  // freed with the library
};

CGlyphAtlas::CGlyphAtlas() = default;
CGlyphAtlas::~CGlyphAtlas() = default;

void CGlyphAtlas::BeginPicture() {
  constexpr int kMuch = 2048;  // pixels
  if (m_nextY > kMuch) {
    m_glyphs.clear();
    m_pixels.clear();
    m_nextX = 0;
    m_nextY = 0;
    m_rowHeight = 0;
    ++m_version;
  }
}

CGlyphAtlas::SBitmap CGlyphAtlas::Store(const std::vector<std::uint8_t>& pixels, int width,
                                        int height) {
  if (m_nextX + width > kWidth) {
    m_nextX = 0;
    m_nextY += m_rowHeight + kGap;
    m_rowHeight = 0;
  }
  const int bottom = m_nextY + height;
  if (bottom > kMaxHeight || width > kWidth) {
    THROW_ARGOSEXCEPTION("A picture has too many letters of different sizes: they need more than "
                         << kWidth << "x" << kMaxHeight << " pixels");
  }
  if (bottom > GetHeight()) {
    const int enough = std::min(kMaxHeight, std::max({64, bottom, 2 * GetHeight()}));
    m_pixels.resize(static_cast<std::size_t>(enough) * kWidth, 0);
  }
  for (int row = 0; row < height; ++row) {
    std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(row) * width, width,
                m_pixels.begin() + static_cast<std::ptrdiff_t>(m_nextY + row) * kWidth + m_nextX);
  }
  SBitmap bitmap;
  bitmap.X = m_nextX;
  bitmap.Y = m_nextY;
  bitmap.Width = width;
  bitmap.Height = height;
  m_nextX += width + kGap;
  m_rowHeight = std::max(m_rowHeight, height);
  ++m_version;
  return bitmap;
}

const CGlyphAtlas::SGlyph& CGlyphAtlas::Get(const TKey& key) {
  const auto found = m_glyphs.find(key);
  if (found != m_glyphs.end()) {
    return found->second;
  }
  if (m_fonts == nullptr) {
    m_fonts = std::make_unique<SFonts>();
  }
  const auto& [font, size, isItalic, character] = key;
  FT_Face face = m_fonts->Get(font);
  FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size));
  if (FT_Load_Char(face, character, FT_LOAD_TARGET_LIGHT) != 0) {
    THROW_ARGOSEXCEPTION("Text cannot be drawn: the font has no character "
                         << static_cast<std::uint32_t>(character) << " that can be loaded");
  }
  if (isItalic) {
    FT_GlyphSlot_Oblique(face->glyph);
  }
  FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL);
  const FT_GlyphSlot slot = face->glyph;
  const int width = static_cast<int>(slot->bitmap.width);
  const int height = static_cast<int>(slot->bitmap.rows);
  std::vector<std::uint8_t> letter;
  for (int row = 0; row < height; ++row) {
    const unsigned char* begin = slot->bitmap.buffer + std::ptrdiff_t{row} * slot->bitmap.pitch;
    letter.insert(letter.end(), begin, begin + width);
  }
  SGlyph glyph;
  glyph.Advance = static_cast<double>(slot->advance.x) / 64.0;
  if (width > 0 && height > 0) {
    // a contour of small text would close its counters
    const double reach = kContourReach * std::clamp(size / 16.0, 0.75, 2.0);
    const int margin = static_cast<int>(std::ceil(reach));
    glyph.Letter = Store(letter, width, height);
    glyph.Letter.Left = slot->bitmap_left;
    glyph.Letter.Top = -slot->bitmap_top;
    glyph.Contour =
        Store(MakeContour(letter, width, height, reach), width + 2 * margin, height + 2 * margin);
    glyph.Contour.Left = glyph.Letter.Left - margin;
    glyph.Contour.Top = glyph.Letter.Top - margin;
  }
  return m_glyphs.emplace(key, glyph).first->second;
}

double CGlyphAtlas::MeasureLine(std::u32string_view line, const STextStyle& style, std::size_t font,
                                int size) {
  double width = 0.0;
  for (const char32_t character : line) {
    width += Get({font, size, style.IsItalic, character}).Advance;
  }
  return width;
}

void CGlyphAtlas::Append(const SLabel& label, double x, double y, double scale,
                         std::vector<SGlyphInstance>& instances) {
  const STextStyle& style = label.Style;
  const std::size_t font = ChooseFont(style);
  const int size =
      static_cast<int>(std::clamp<double>(std::lround(style.Size * scale), kMinText, kMaxText));
  const SRgba contourColor = ChooseContour(label.Color);
  std::vector<SGlyphInstance> letters;
  double baseLine = std::round(y);
  for (const std::u32string& line : SplitLines(label.Text)) {
    double pen = x;
    if (style.Alignment != STextStyle::EAlignment::Left) {
      const double share = style.Alignment == STextStyle::EAlignment::Center ? 0.5 : 1.0;
      pen -= share * MeasureLine(line, style, font, size);
    }
    for (const char32_t character : line) {
      const SGlyph& glyph = Get({font, size, style.IsItalic, character});
      const auto place = [&](const SBitmap& bitmap, const SRgba& color) {
        return SGlyphInstance{{static_cast<float>(std::round(pen) + bitmap.Left),
                               static_cast<float>(baseLine + bitmap.Top),
                               static_cast<float>(bitmap.Width), static_cast<float>(bitmap.Height)},
                              {static_cast<float>(bitmap.X), static_cast<float>(bitmap.Y)},
                              color};
      };
      if (glyph.Letter.Width > 0) {
        instances.push_back(place(glyph.Contour, contourColor));
        letters.push_back(place(glyph.Letter, label.Color));
      }
      pen += glyph.Advance;
    }
    baseLine += std::round(kLineDistance * size);
  }
  instances.insert(instances.end(), letters.begin(), letters.end());
}

}  // namespace argos
