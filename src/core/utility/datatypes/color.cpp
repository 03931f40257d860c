#include <argos3/core/utility/datatypes/color.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cstring>
#include <optional>
#include <system_error>
#include <vector>

namespace argos {

// constant-initialised, because static initialisers in user code read them
constinit CColor CColor::BLACK(0, 0, 0);
constinit CColor CColor::WHITE(255, 255, 255);
constinit CColor CColor::RED(255, 0, 0);
constinit CColor CColor::GREEN(0, 255, 0);
constinit CColor CColor::BLUE(0, 0, 255);
constinit CColor CColor::MAGENTA(255, 0, 255);
constinit CColor CColor::CYAN(0, 255, 255);
constinit CColor CColor::YELLOW(255, 255, 0);
constinit CColor CColor::ORANGE(255, 140, 0);
constinit CColor CColor::BROWN(165, 42, 42);
constinit CColor CColor::PURPLE(160, 32, 240);
constinit CColor CColor::GRAY10(26, 26, 26);
constinit CColor CColor::GRAY20(51, 51, 51);
constinit CColor CColor::GRAY30(77, 77, 77);
constinit CColor CColor::GRAY40(102, 102, 102);
constinit CColor CColor::GRAY50(127, 127, 127);
constinit CColor CColor::GRAY60(153, 153, 153);
constinit CColor CColor::GRAY70(179, 179, 179);
constinit CColor CColor::GRAY80(204, 204, 204);
constinit CColor CColor::GRAY90(229, 229, 229);

namespace {

struct SNamedColor {
  const char* Name;
  const CColor& Color;
};

constexpr std::array<SNamedColor, 20> kNamedColors = {{
    {"black", CColor::BLACK},   {"white", CColor::WHITE},   {"red", CColor::RED},
    {"green", CColor::GREEN},   {"blue", CColor::BLUE},     {"magenta", CColor::MAGENTA},
    {"cyan", CColor::CYAN},     {"yellow", CColor::YELLOW}, {"orange", CColor::ORANGE},
    {"brown", CColor::BROWN},   {"purple", CColor::PURPLE}, {"gray10", CColor::GRAY10},
    {"gray20", CColor::GRAY20}, {"gray30", CColor::GRAY30}, {"gray40", CColor::GRAY40},
    {"gray50", CColor::GRAY50}, {"gray60", CColor::GRAY60}, {"gray70", CColor::GRAY70},
    {"gray80", CColor::GRAY80}, {"gray90", CColor::GRAY90},
}};

std::vector<std::string> ColorNames() {
  std::vector<std::string> names;
  for (const SNamedColor& named : kNamedColors) {
    names.emplace_back(named.Name);
  }
  return names;
}

/* "#rgb", "#rrggbb" or "#rrggbbaa"; nothing if the text is none of them. */
std::optional<std::array<UInt8, 4>> ReadHexColor(const std::string& word) {
  constexpr size_t kShort = 4;
  constexpr size_t kOpaque = 7;
  constexpr size_t kLong = 9;
  const std::string digits =
      word.size() == kShort ? std::string{'#', word[1], word[1], word[2], word[2], word[3], word[3]}
                            : word;
  if (digits[0] != '#' || (digits.size() != kOpaque && digits.size() != kLong)) {
    return std::nullopt;
  }
  std::array<UInt8, 4> channels = {0, 0, 0, 255};
  for (size_t i = 0; 2 * i + 2 < digits.size(); ++i) {
    const char* const first = digits.data() + 2 * i + 1;
    const auto [end, error] = std::from_chars(first, first + 2, channels[i], 16);
    if (error != std::errc() || end != first + 2) {
      return std::nullopt;
    }
  }
  return channels;
}

UInt8 BlendChannel(UInt8 over, UInt8 under, UInt8 alpha) {
  // 127 rounds the division by 255 to the nearest integer
  return static_cast<UInt8>((over * alpha + under * (255 - alpha) + 127) / 255);
}

}  // namespace

void CColor::Set(const std::string& color) {
  std::vector<std::string> words;
  Tokenize(color, words, " \t\n\r");
  if (words.size() == 1) {
    for (const SNamedColor& named : kNamedColors) {
      if (words[0] == named.Name) {
        *this = named.Color;
        return;
      }
    }
    if (const auto channels = ReadHexColor(words[0])) {
      Set((*channels)[0], (*channels)[1], (*channels)[2], (*channels)[3]);
      return;
    }
  }
  const bool isList = color.find(',') != std::string::npos;
  std::array<UInt8, 4> channels{};
  try {
    CTextInput stream(color);
    SetStrictParsing(stream, true);
    ParseValues<UInt8>(stream, 4, channels.data(), ',');
  } catch (CARGoSException&) {
    THROW_ARGOSEXCEPTION(
        "\"" << color
             << "\" is not a colour: expected a name, four integers from 0 to 255, "
                "\"R,G,B,A\", or \"#rrggbb\""
             << (isList ? std::string() : DidYouMean(color, ColorNames())));
  }
  Set(channels[0], channels[1], channels[2], channels[3]);
}

CColor CColor::Blend(const CColor& background) const {
  return CColor(BlendChannel(m_red, background.m_red, m_alpha),
                BlendChannel(m_green, background.m_green, m_alpha),
                BlendChannel(m_blue, background.m_blue, m_alpha));
}

CColor::operator UInt32() {
  const std::array<UInt8, 4> bytes = {m_red, m_green, m_blue, m_alpha};
  UInt32 value;
  std::memcpy(&value, bytes.data(), sizeof(value));
  return value;
}

std::ostream& operator<<(std::ostream& stream, const CColor& color) {
  for (const SNamedColor& named : kNamedColors) {
    if (color == named.Color) {
      return stream << named.Name;
    }
  }
  return stream << static_cast<int>(color.GetRed()) << ',' << static_cast<int>(color.GetGreen())
                << ',' << static_cast<int>(color.GetBlue()) << ','
                << static_cast<int>(color.GetAlpha());
}

std::istream& operator>>(std::istream& stream, CColor& color) {
  // one word, or several if commas join them: "255, 0, 0, 255"
  std::string text;
  std::string word;
  do {
    if (!(stream >> word)) {
      break;
    }
    text += word;
    while (std::isspace(stream.peek())) {
      stream.get();
    }
  } while (!stream.eof() && (text.back() == ',' || stream.peek() == ','));
  // the end of the input is no failure if a text was read
  if (!text.empty()) {
    stream.clear(stream.rdstate() & std::ios_base::eofbit);
    color.Set(text);
  }
  return stream;
}

}  // namespace argos
