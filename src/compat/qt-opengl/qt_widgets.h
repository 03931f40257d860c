#ifndef ARGOS3_COMPAT_QT_OPENGL_QT_WIDGETS_H
#define ARGOS3_COMPAT_QT_OPENGL_QT_WIDGETS_H

/*
 * Further types of Qt that users' drawing code names: accepted, so that it compiles and loads.
 * There is no window, so what these classes show is not shown; the log names each of them once.
 */

#include <argos3/plugins/simulator/visualizations/qt-opengl/qt_types.h>

#include <chrono>

// NOLINTBEGIN(readability-identifier-naming): the names are Qt's

// no code is generated for signals and slots: they are members like others
#ifndef Q_OBJECT
#define Q_OBJECT
#define Q_UNUSED(NAME) (void)NAME;
#define signals public
#define slots
#define emit
#define SIGNAL(NAME) #NAME
#define SLOT(NAME) #NAME
#endif

namespace argos {
/** Writes a warning about a name that has no effect here, once for each name. */
void WarnOfQtName(const char* name);
}  // namespace argos

class QPoint {
 public:
  QPoint() = default;
  QPoint(int x, int y) : m_x(x), m_y(y) {}
  int x() const { return m_x; }
  int y() const { return m_y; }
  void setX(int x) { m_x = x; }
  void setY(int y) { m_y = y; }
  bool isNull() const { return m_x == 0 && m_y == 0; }

 private:
  int m_x = 0;
  int m_y = 0;
};

class QSize {
 public:
  QSize() = default;
  QSize(int width, int height) : m_width(width), m_height(height) {}
  int width() const { return m_width; }
  int height() const { return m_height; }

 private:
  int m_width = -1;
  int m_height = -1;
};

class QTimerEvent {};
class QResizeEvent {};
class QCloseEvent {};
class QWheelEvent {
 public:
  QPoint angleDelta() const { return {}; }
};

class QObject {
 public:
  explicit QObject(QObject* /*parent*/ = nullptr) {}
  virtual ~QObject() = default;
  QObject(const QObject&) = delete;
  QObject& operator=(const QObject&) = delete;

  /** Nothing is connected. */
  template <typename... ARGUMENTS>
  static bool connect(const ARGUMENTS&...) {
    argos::WarnOfQtName("QObject::connect");
    return false;
  }
  int startTimer(int /*interval*/) { return 0; }
  void killTimer(int /*id*/) {}
};

class QWidget : public QObject {
 public:
  explicit QWidget(QWidget* parent = nullptr) : QObject(parent) {}

  void show() {}
  void hide() {}
  void setWindowTitle(const QString& /*title*/) {}
  void resize(int /*width*/, int /*height*/) {}
  void setEnabled(bool /*enabled*/) {}
  /** Pixels. There is no window. */
  int width() const { return 0; }
  int height() const { return 0; }
  virtual void update() {}
};

class QMainWindow : public QWidget {
 public:
  using QWidget::QWidget;
};

class QOpenGLFunctions {
 public:
  void initializeOpenGLFunctions() {}
};

class QOpenGLWidget : public QWidget {
 public:
  using QWidget::QWidget;

 protected:
  virtual void initializeGL() {}
  virtual void paintGL() {}
  virtual void resizeGL(int /*width*/, int /*height*/) {}
};

class QImage {
 public:
  QImage() = default;
  explicit QImage(const QString& /*file*/) {}
  QImage mirrored(bool /*horizontally*/ = false, bool /*vertically*/ = true) const { return *this; }
  bool isNull() const { return true; }
  int width() const { return 0; }
  int height() const { return 0; }
};

class QOpenGLTexture {
 public:
  enum Target { Target2D = 0x0DE1 };
  enum Filter { Nearest = 0x2600, Linear = 0x2601, LinearMipMapLinear = 0x2703 };
  enum WrapMode { Repeat = 0x2901, ClampToEdge = 0x812F };

  explicit QOpenGLTexture(const QImage& /*image*/) { argos::WarnOfQtName("QOpenGLTexture"); }
  explicit QOpenGLTexture(Target /*target*/) { argos::WarnOfQtName("QOpenGLTexture"); }

  bool isCreated() const { return false; }
  void bind() {}
  void release() {}
  void destroy() {}
  void setWrapMode(WrapMode /*mode*/) {}
  void setMinificationFilter(Filter /*filter*/) {}
  void setMagnificationFilter(Filter /*filter*/) {}
  void setMinMagFilters(Filter /*smaller*/, Filter /*larger*/) {}
  void setData(const QImage& /*image*/) {}
  unsigned int textureId() const { return 0; }
};

/** Measures time, as that of Qt. */
class QElapsedTimer {
 public:
  void start() { m_start = std::chrono::steady_clock::now(); }
  /** Milliseconds since the last start. */
  long long restart() {
    const long long passed = elapsed();
    start();
    return passed;
  }
  long long elapsed() const { return nsecsElapsed() / 1000000; }
  long long nsecsElapsed() const {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() -
                                                                m_start)
        .count();
  }
  bool isValid() const { return m_start != std::chrono::steady_clock::time_point(); }
  void invalidate() { m_start = {}; }
  bool hasExpired(long long milliseconds) const { return elapsed() > milliseconds; }

 private:
  std::chrono::steady_clock::time_point m_start;
};

/** A value of a model; only texts and numbers. */
class QVariant {
 public:
  QVariant() = default;
  QVariant(const QString& text) : m_text(text), m_isValid(true) {}
  QVariant(const char* text) : QVariant(QString(text)) {}
  QVariant(int value) : QVariant(QString::number(value)) {}
  QVariant(double value) : QVariant(QString::number(value)) {}
  QString toString() const { return m_text; }
  bool isValid() const { return m_isValid; }

 private:
  QString m_text;
  bool m_isValid = false;
};

class QAbstractItemModel;

class QModelIndex {
 public:
  bool isValid() const { return m_row >= 0; }
  int row() const { return m_row; }
  int column() const { return m_column; }
  void* internalPointer() const { return m_pointer; }

 private:
  friend class QAbstractItemModel;
  int m_row = -1;
  int m_column = -1;
  void* m_pointer = nullptr;
};

class QAbstractItemModel : public QObject {
 public:
  explicit QAbstractItemModel(QObject* parent = nullptr) : QObject(parent) {
    argos::WarnOfQtName("QAbstractItemModel");
  }
  virtual QVariant data(const QModelIndex& index, int role = 0) const = 0;
  virtual int rowCount(const QModelIndex& parent = QModelIndex()) const = 0;
  virtual int columnCount(const QModelIndex& parent = QModelIndex()) const = 0;
  virtual QModelIndex index(int row, int column,
                            const QModelIndex& parent = QModelIndex()) const = 0;
  virtual QModelIndex parent(const QModelIndex& index) const = 0;
  virtual Qt::ItemFlags flags(const QModelIndex& index) const {
    return index.isValid() ? Qt::ItemIsSelectable | Qt::ItemIsEnabled : Qt::NoItemFlags;
  }
  virtual QVariant headerData(int /*section*/, Qt::Orientation /*orientation*/,
                              int /*role*/ = Qt::DisplayRole) const {
    return {};
  }
  virtual bool setData(const QModelIndex& /*index*/, const QVariant& /*value*/,
                       int /*role*/ = Qt::EditRole) {
    return false;
  }
  bool hasIndex(int row, int column, const QModelIndex& parent = QModelIndex()) const {
    return row >= 0 && column >= 0 && row < rowCount(parent) && column < columnCount(parent);
  }
  /** Signals, to which nothing is connected. */
  void dataChanged(const QModelIndex& /*first*/, const QModelIndex& /*last*/) {}
  void layoutChanged() {}

 protected:
  QModelIndex createIndex(int row, int column, void* pointer = nullptr) const {
    QModelIndex index;
    index.m_row = row;
    index.m_column = column;
    index.m_pointer = pointer;
    return index;
  }
  void beginResetModel() {}
  void endResetModel() {}
};

// NOLINTEND(readability-identifier-naming)

#endif
