#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>

#include <argos3/core/simulator/visualization/drawing.h>
#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_conversions.h>

#include <algorithm>
#include <array>
#include <locale>
#include <sstream>

namespace argos {

namespace {

constexpr Real kPixelsPerPoint = 96.0 / 72.0;

UInt8 ToChannel(int value) {
  return static_cast<UInt8>(std::clamp(value, 0, 255));
}

CColor ToColor(const QColor& color) {
  return CColor(ToChannel(color.red()), ToChannel(color.green()), ToChannel(color.blue()),
                ToChannel(color.alpha()));
}

CVector3 PixelAt(int x, int y) {
  return CVector3(x, y, 0.0);
}

void DrawRectangle(CDrawing& drawing, const QRect& area, const CColor& color, bool fill) {
  drawing.DrawPolygon(PixelAt(area.x(), area.y()), CQuaternion(),
                      {CVector2(0.0, 0.0), CVector2(area.width(), 0.0),
                       CVector2(area.width(), area.height()), CVector2(0.0, area.height())},
                      color, fill);
}

}  // namespace

STextStyle ToTextStyle(const QFont& font) {
  STextStyle style;
  style.Family = font.family().toStdString();
  style.Size = kPixelsPerPoint * font.pointSizeF();
  style.IsBold = font.bold();
  style.IsItalic = font.italic();
  return style;
}

}  // namespace argos

QColor::QColor(Qt::GlobalColor color) {
  // from Qt::black on; source: Qt's documentation of Qt::GlobalColor
  static constexpr std::array<std::array<int, 3>, 17> kColors = {{{0, 0, 0},
                                                                  {255, 255, 255},
                                                                  {128, 128, 128},
                                                                  {160, 160, 164},
                                                                  {192, 192, 192},
                                                                  {255, 0, 0},
                                                                  {0, 255, 0},
                                                                  {0, 0, 255},
                                                                  {0, 255, 255},
                                                                  {255, 0, 255},
                                                                  {255, 255, 0},
                                                                  {128, 0, 0},
                                                                  {0, 128, 0},
                                                                  {0, 0, 128},
                                                                  {0, 128, 128},
                                                                  {128, 0, 128},
                                                                  {128, 128, 0}}};
  const std::array<int, 3>& channels = kColors[static_cast<size_t>(color) - Qt::black];
  m_red = channels[0];
  m_green = channels[1];
  m_blue = channels[2];
}

QString QString::number(double value, char format, int precision) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(precision);
  if (format == 'f') {
    text << std::fixed;
  } else if (format == 'e') {
    text << std::scientific;
  }
  text << value;
  return text.str();
}

QString QString::arg(const QString& text) const {
  // number and length of the place at a '%'; the number is 0 if there is none
  const auto placeAt = [this](size_t at) {
    size_t length = 1;
    int number = 0;
    while (length <= 2 && at + length < size() && (*this)[at + length] >= '0' &&
           (*this)[at + length] <= '9') {
      number = 10 * number + ((*this)[at + length] - '0');
      ++length;
    }
    return std::pair<int, size_t>(number, length);
  };
  int lowest = 0;
  for (size_t at = find('%'); at != npos; at = find('%', at + 1)) {
    const int number = placeAt(at).first;
    lowest = number > 0 && (lowest == 0 || number < lowest) ? number : lowest;
  }
  std::string result;
  for (size_t at = 0; at < size();) {
    const auto [number, length] = (*this)[at] == '%' ? placeAt(at) : std::pair<int, size_t>(0, 1);
    result += number > 0 && number == lowest ? std::string(text) : substr(at, length);
    at += length;
  }
  return result;
}

void QFont::setStyleHint(StyleHint hint) {
  if (!m_family.isEmpty()) {
    return;
  }
  switch (hint) {
    case Serif:
      m_family = "serif";
      break;
    case TypeWriter:
    case Monospace:
      m_family = "monospace";
      break;
    case SansSerif:
    case AnyStyle:
      break;
  }
}

QRect QPainter::viewport() const {
  return QRect(0, 0, static_cast<int>(m_drawing.GetWidth()),
               static_cast<int>(m_drawing.GetHeight()));
}

void QPainter::drawText(int x, int y, const QString& text) {
  m_drawing.DrawText(argos::PixelAt(x, y), text, argos::ToColor(m_color),
                     argos::ToTextStyle(m_font));
}

void QPainter::drawLine(int x1, int y1, int x2, int y2) {
  m_drawing.DrawLine(argos::PixelAt(x1, y1), argos::PixelAt(x2, y2), argos::ToColor(m_color));
}

void QPainter::drawRect(int x, int y, int width, int height) {
  argos::DrawRectangle(m_drawing, QRect(x, y, width, height), argos::ToColor(m_color), false);
}

void QPainter::fillRect(int x, int y, int width, int height, const QColor& color) {
  argos::DrawRectangle(m_drawing, QRect(x, y, width, height), argos::ToColor(color), true);
}
