#ifndef ARGOS3_COMPAT_QT_OPENGL_QT_TYPES_H
#define ARGOS3_COMPAT_QT_OPENGL_QT_TYPES_H

/*
 * The few types of Qt that users' drawing functions name, with the members that they call, so that
 * such code compiles and draws without Qt. Names and values are Qt's.
 */

#ifdef QT_VERSION
#error \
    "ARGoS draws without Qt and declares the types of Qt that drawing functions use: include \
argos3/plugins/simulator/visualizations/qt-opengl/qtopengl_user_functions.h instead of Qt's headers"
#endif

#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_constants.h>

#include <cmath>
#include <string>
#include <utility>

namespace argos {
class CDrawing;
}

// NOLINTBEGIN(readability-identifier-naming): the names are Qt's

/** Text in UTF-8. */
class QString : public std::string {
 public:
  QString() = default;
  QString(const char* text) : std::string(text) {}
  QString(std::string text) : std::string(std::move(text)) {}

  static QString fromStdString(const std::string& text) { return text; }
  static QString number(double value) {
    // as "%g"
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
  }
  /** @param format  'f', 'e' or 'g'. */
  static QString number(double value, char format, int precision = 6);
  static QString number(int value) { return std::to_string(value); }
  const std::string& toStdString() const { return *this; }
  bool isEmpty() const { return empty(); }
  /** Puts a text in the place of the lowest of %1 to %99. */
  QString arg(const QString& text) const;
  QString arg(int value) const { return arg(number(value)); }
  QString arg(double value) const { return arg(number(value)); }
};

typedef long long qint64;

/** Channels from 0 to 255. */
class QColor {
 public:
  QColor() = default;
  QColor(int red, int green, int blue, int alpha = 255)
      : m_red(red), m_green(green), m_blue(blue), m_alpha(alpha) {}
  QColor(Qt::GlobalColor color);

  int red() const { return m_red; }
  int green() const { return m_green; }
  int blue() const { return m_blue; }
  int alpha() const { return m_alpha; }
  void setAlpha(int alpha) { m_alpha = alpha; }

 private:
  int m_red = 0;
  int m_green = 0;
  int m_blue = 0;
  int m_alpha = 255;
};

/** Family, size and style of a text. A point of its size is 4/3 of a pixel. */
class QFont {
 public:
  enum Weight {
    Thin = 100,
    ExtraLight = 200,
    Light = 300,
    Normal = 400,
    Medium = 500,
    DemiBold = 600,
    Bold = 700,
    ExtraBold = 800,
    Black = 900
  };
  enum StyleHint {
    AnyStyle = 5,
    SansSerif = 0,
    Helvetica = SansSerif,
    Serif = 1,
    Times = Serif,
    TypeWriter = 2,
    Courier = TypeWriter,
    Monospace = 7
  };

  enum Capitalization { MixedCase, AllUppercase, AllLowercase, SmallCaps, Capitalize };

  QFont() = default;
  /** @param pointSize, weight  -1 = the default. */
  QFont(const QString& family, int pointSize = -1, int weight = -1, bool italic = false)
      : m_family(family), m_weight(weight < 0 ? int{Normal} : weight), m_italic(italic) {
    if (pointSize > 0) {
      setPointSize(pointSize);
    }
  }

  QString family() const { return m_family; }
  void setFamily(const QString& family) { m_family = family; }
  int pointSize() const { return static_cast<int>(std::lround(m_pointSize)); }
  double pointSizeF() const { return m_pointSize; }
  void setPointSize(int points) { m_pointSize = points; }
  void setPointSizeF(double points) { m_pointSize = points; }
  int pixelSize() const { return static_cast<int>(std::lround(m_pointSize / 0.75)); }
  void setPixelSize(int pixels) { m_pointSize = 0.75 * pixels; }
  int weight() const { return m_weight; }
  void setWeight(int weight) { m_weight = weight; }
  bool bold() const { return m_weight > Medium; }
  void setBold(bool bold) { m_weight = bold ? Bold : Normal; }
  bool italic() const { return m_italic; }
  void setItalic(bool italic) { m_italic = italic; }
  Capitalization capitalization() const { return m_capitalization; }
  /** Is kept, without effect on what is drawn. */
  void setCapitalization(Capitalization capitalization) { m_capitalization = capitalization; }
  /** Names the family if there is none. */
  void setStyleHint(StyleHint hint);

 private:
  QString m_family;
  double m_pointSize = 12.0;
  int m_weight = Normal;
  bool m_italic = false;
  Capitalization m_capitalization = MixedCase;
};

/** Size of the picture, pixels. */
class QRect {
 public:
  QRect(int x, int y, int width, int height) : m_x(x), m_y(y), m_width(width), m_height(height) {}

  int x() const { return m_x; }
  int y() const { return m_y; }
  int width() const { return m_width; }
  int height() const { return m_height; }

 private:
  int m_x;
  int m_y;
  int m_width;
  int m_height;
};

/** A key was pressed or released. */
class QKeyEvent {
 public:
  explicit QKeyEvent(int key, QString text = QString(),
                     Qt::KeyboardModifiers modifiers = Qt::NoModifier)
      : m_key(key), m_text(std::move(text)), m_modifiers(modifiers) {}

  int key() const { return m_key; }
  QString text() const { return m_text; }
  /** Without Qt::KeypadModifier. */
  Qt::KeyboardModifiers modifiers() const { return m_modifiers; }
  bool isAutoRepeat() const { return false; }
  /** An event is accepted until it is ignored: then the view may do something with the key. */
  bool isAccepted() const { return m_isAccepted; }
  void setAccepted(bool accepted) { m_isAccepted = accepted; }
  void accept() { setAccepted(true); }
  void ignore() { setAccepted(false); }

 private:
  int m_key;
  QString m_text;
  Qt::KeyboardModifiers m_modifiers;
  bool m_isAccepted = true;
};

/** A button of the mouse was pressed or released, or the mouse moved. Pixels, y downwards. */
class QMouseEvent {
 public:
  QMouseEvent(int x, int y, Qt::MouseButton button = Qt::NoButton,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier)
      : m_x(x), m_y(y), m_button(button), m_modifiers(modifiers) {}

  int x() const { return m_x; }
  int y() const { return m_y; }
  Qt::MouseButton button() const { return m_button; }
  Qt::KeyboardModifiers modifiers() const { return m_modifiers; }
  void accept() {}
  void ignore() {}

 private:
  int m_x;
  int m_y;
  Qt::MouseButton m_button;
  Qt::KeyboardModifiers m_modifiers;
};

/** Draws text, lines and rectangles over the picture: pixels, y downwards. */
class QPainter {
 public:
  /** @param drawing  must draw over the picture, see CDrawing::SetOverlay(). */
  explicit QPainter(argos::CDrawing& drawing) : m_drawing(drawing) {}

  void setPen(const QColor& color) { m_color = color; }
  void setFont(const QFont& font) { m_font = font; }
  const QFont& font() const { return m_font; }
  QRect viewport() const;
  QRect window() const { return viewport(); }

  /** @param x, y  the beginning of the base line. */
  void drawText(int x, int y, const QString& text);
  void drawLine(int x1, int y1, int x2, int y2);
  void drawRect(int x, int y, int width, int height);
  void fillRect(int x, int y, int width, int height, const QColor& color);

 private:
  argos::CDrawing& m_drawing;
  QColor m_color;
  QFont m_font;
};

// NOLINTEND(readability-identifier-naming)

#endif
