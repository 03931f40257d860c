#ifndef ARGOS3_COMPAT_QT_OPENGL_QT_CONSTANTS_H
#define ARGOS3_COMPAT_QT_OPENGL_QT_CONSTANTS_H

/* Keys, buttons and colours, see qt_types.h. */

// NOLINTBEGIN(readability-identifier-naming): the names are Qt's

namespace Qt {

enum Key {
  Key_Space = 0x20,
  Key_Plus = 0x2b,
  Key_Comma,
  Key_Minus,
  Key_Period,
  Key_Slash,
  Key_0,
  Key_1,
  Key_2,
  Key_3,
  Key_4,
  Key_5,
  Key_6,
  Key_7,
  Key_8,
  Key_9,
  Key_Equal = 0x3d,
  Key_A = 0x41,
  Key_B,
  Key_C,
  Key_D,
  Key_E,
  Key_F,
  Key_G,
  Key_H,
  Key_I,
  Key_J,
  Key_K,
  Key_L,
  Key_M,
  Key_N,
  Key_O,
  Key_P,
  Key_Q,
  Key_R,
  Key_S,
  Key_T,
  Key_U,
  Key_V,
  Key_W,
  Key_X,
  Key_Y,
  Key_Z,
  Key_BracketLeft,
  Key_BracketRight = 0x5d,
  Key_Escape = 0x01000000,
  Key_Tab,
  Key_Backspace = 0x01000003,
  Key_Return,
  Key_Enter,
  Key_Insert,
  Key_Delete,
  Key_Home = 0x01000010,
  Key_End,
  Key_Left,
  Key_Up,
  Key_Right,
  Key_Down,
  Key_PageUp,
  Key_PageDown,
  Key_Shift = 0x01000020,
  Key_Control,
  Key_Meta,
  Key_Alt,
  Key_F1 = 0x01000030,
  Key_F2,
  Key_F3,
  Key_F4,
  Key_F5,
  Key_F6,
  Key_F7,
  Key_F8,
  Key_F9,
  Key_F10,
  Key_F11,
  Key_F12
};

enum MouseButton { NoButton = 0, LeftButton = 1, RightButton = 2, MiddleButton = 4 };

enum KeyboardModifier {
  NoModifier = 0,
  ShiftModifier = 0x02000000,
  ControlModifier = 0x04000000,
  AltModifier = 0x08000000,
  MetaModifier = 0x10000000,
  KeypadModifier = 0x20000000
};

/** The keys of this kind that are down. */
class KeyboardModifiers {
 public:
  constexpr KeyboardModifiers(int modifiers = NoModifier) : m_modifiers(modifiers) {}
  constexpr operator int() const { return m_modifiers; }
  constexpr bool testFlag(KeyboardModifier modifier) const {
    return (m_modifiers & modifier) == modifier;
  }
  KeyboardModifiers& setFlag(KeyboardModifier modifier, bool isDown = true) {
    m_modifiers = isDown ? m_modifiers | modifier : m_modifiers & ~modifier;
    return *this;
  }

 private:
  int m_modifiers;
};

enum Orientation { Horizontal = 1, Vertical = 2 };

// of models of items
enum ItemDataRole {
  DisplayRole,
  DecorationRole,
  EditRole,
  ToolTipRole,
  StatusTipRole,
  FontRole = 6,
  TextAlignmentRole,
  UserRole = 256
};

enum ItemFlag {
  NoItemFlags = 0,
  ItemIsSelectable = 1,
  ItemIsEditable = 2,
  ItemIsUserCheckable = 16,
  ItemIsEnabled = 32
};
using ItemFlags = int;

enum GlobalColor {
  black = 2,
  white,
  darkGray,
  gray,
  lightGray,
  red,
  green,
  blue,
  cyan,
  magenta,
  yellow,
  darkRed,
  darkGreen,
  darkBlue,
  darkCyan,
  darkMagenta,
  darkYellow
};

}  // namespace Qt

// NOLINTEND(readability-identifier-naming)

#endif
