#include <argos3/core/simulator/entity/floor_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/floor_painter.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/images/image_file.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/files/file_replacement.h>
#include <argos3/core/utility/files/nearby_file.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace argos {

namespace {

struct SPixel {
  UInt8 Red, Green, Blue;
};

static_assert(sizeof(SPixel) == 3, "rows of pixels are encoded as they are");

}  // namespace

/* The pixels, packed, so that reading one is safe on any thread and costs one access. */
class CFloorEntity::CImage {
 public:
  CImage(size_t width, size_t height) : m_width(width), m_pixels(width * height) {}

  explicit CImage(const SImage& image) : CImage(image.Width, image.Height) {
    const UInt8* next = image.Pixels.data();
    for (SPixel& pixel : m_pixels) {
      pixel = {next[0], next[1], next[2]};
      next += 3;
    }
  }

  size_t GetWidth() const { return m_width; }
  size_t GetHeight() const { return m_pixels.size() / m_width; }
  SPixel& At(size_t column, size_t row) { return m_pixels[row * m_width + column]; }

  void Write(const std::string& path) const {
    const std::optional<SImageFormat> format = FindImageFormat(path);
    if (!format) {
      THROW_ARGOSEXCEPTION("cannot save the floor as "
                           << DescribePath(path)
                           << ": the extension must be one of an image format with 24-bit colours, "
                              "such as .png, .jpg, .bmp or .tif");
    }
    const SPixelView pixels{m_width, GetHeight(), &m_pixels.front().Red,
                            static_cast<std::ptrdiff_t>(sizeof(SPixel) * m_width), sizeof(SPixel)};
    std::string problem;
    if (!ReplaceFile(path, EncodeImage(pixels, *format), problem)) {
      THROW_ARGOSEXCEPTION("cannot write the floor to " << DescribePath(path) << ": " << problem);
    }
  }

 private:
  size_t m_width;
  std::vector<SPixel> m_pixels;  // (height, width), lowest row first
};

CFloorEntity::CFloorEntity() : CEntity(nullptr), m_context(CurrentContext()) {}

CFloorEntity::CFloorEntity(const std::string& id, UInt32 pixelsPerMeter)
    : CEntity(nullptr, id),
      m_source(FROM_LOOP_FUNCTIONS),
      m_pixelsPerMeter(pixelsPerMeter),
      m_context(CurrentContext()) {
  if (pixelsPerMeter == 0) {
    THROW_ARGOSEXCEPTION("the floor \"" << id << "\" needs at least one pixel per metre, not 0");
  }
}

CFloorEntity::CFloorEntity(const std::string& id, const std::string& fileName)
    : CEntity(nullptr, id), m_source(FROM_IMAGE), m_context(CurrentContext()) {
  LoadImage(fileName);
}

CFloorEntity::~CFloorEntity() = default;

void CFloorEntity::Init(TConfigurationNode& tree) {
  CEntity::Init(tree);
  std::string source;
  GetNodeAttribute(tree, "source", source);
  try {
    if (source == "image") {
      m_source = FROM_IMAGE;
      std::string path;
      GetNodeAttribute(tree, "path", path);
      LoadImage(FindNearbyFile(path, tree.GetFileName(), "floor image"));
    } else if (source == "loop_functions") {
      m_source = FROM_LOOP_FUNCTIONS;
      GetNodeAttribute(tree, "pixels_per_meter", m_pixelsPerMeter);
      if (m_pixelsPerMeter == 0) {
        THROW_ARGOSEXCEPTION(tree.GetLocation()
                             << ": <floor>: pixels_per_meter is 0; it must be at least 1");
      }
    } else {
      THROW_ARGOSEXCEPTION(tree.GetLocation() << ": <floor>: source=\"" << source
                                              << "\" is neither \"image\" nor \"loop_functions\""
                                              << DidYouMean(source, {"image", "loop_functions"}));
    }
  } catch (CARGoSException& ex) {
    THROW_ARGOSEXCEPTION_NESTED(
        tree.GetLocation() << ": cannot make the floor \"" << GetId() << '"', ex);
  }
}

void CFloorEntity::Reset() {
  SetChanged();
}

void CFloorEntity::LoadImage(const std::string& fileName) {
  m_image = std::make_unique<CImage>(ReadImage(fileName, "floor image"));
  SetImageSize(static_cast<UInt32>(m_image->GetWidth()), static_cast<UInt32>(m_image->GetHeight()));
  const CVector3& size = m_context.Arena.Size;
  if (size.GetX() > 0.0 && size.GetY() > 0.0) {
    // the resolution of the image along its finer axis
    const Real density =
        std::max(m_image->GetWidth() / size.GetX(), m_image->GetHeight() / size.GetY());
    m_pixelsPerMeter = static_cast<UInt32>(std::clamp(std::ceil(density), 1.0, 1e6));
  }
}

void CFloorEntity::SetImageSize(UInt32 width, UInt32 height) {
  CRobotsCode::CheckShared(*this, "SetImageSize()");
  KeepForReset(m_imageWidth);
  KeepForReset(m_imageHeight);
  m_imageWidth = width;
  m_imageHeight = height;
}

namespace {

CColor CallPainter(CFloorPainter& painter, const UInt32* clock, const CVector2& point) {
  // robots call it on several threads
  const bool isBesideOthers = SRunningCode::OfThread().IsBesideOthers;
  const CRunningCodeScope running(
      {"GetFloorColor()", nullptr, "loop functions", clock, isBesideOthers});
  try {
    return painter.GetFloorColor(point);
  } catch (...) {
    try {
      ThrowWithCause(SRunningCode::OfThread().ToText() + " threw");
    } catch (const CARGoSException& error) {
      throw CFloorPainterError(error);
    }
  }
}

}  // namespace

CColor CFloorEntity::GetColorAtPoint(Real x, Real y) {
  x = m_context.Arena.Period.X.Wrap(x);
  y = m_context.Arena.Period.Y.Wrap(y);
  if (m_source != FROM_IMAGE) {
    if (m_context.FloorPainter == nullptr) {
      THROW_ARGOSEXCEPTION("the floor \""
                           << GetId() << "\" is coloured by loop functions, and there are none");
    }
    return CallPainter(*m_context.FloorPainter, m_context.Clock, CVector2(x, y));
  }
  const CVector3& size = m_context.Arena.Size;
  const CVector3& center = m_context.Arena.Center;
  const auto toPixel = [](Real offset, Real length, size_t pixels) {
    const Real pixel = (offset + 0.5 * length) * static_cast<Real>(pixels) / length;
    // compared in floating point, so that large values do not overflow; NaN gives the first pixel
    if (!(pixel > 0.0)) {
      return size_t(0);
    }
    return pixel < static_cast<Real>(pixels) ? static_cast<size_t>(pixel) : pixels - 1;
  };
  const SPixel pixel = m_image->At(toPixel(x - center.GetX(), size.GetX(), m_image->GetWidth()),
                                   toPixel(y - center.GetY(), size.GetY(), m_image->GetHeight()));
  return CColor(pixel.Red, pixel.Green, pixel.Blue);
}

void CFloorEntity::SaveAsImage(const std::string& path) {
  if (m_source == FROM_IMAGE) {
    m_image->Write(path);
    return;
  }
  const CVector3& size = m_context.Arena.Size;
  const CVector3 corner = m_context.Arena.Center - 0.5 * size;
  const Real density = static_cast<Real>(m_pixelsPerMeter);
  const auto toPixels = [density](Real length) {
    return static_cast<size_t>(std::max<Real>(1.0, std::ceil(length * density)));
  };
  CImage image(toPixels(size.GetX()), toPixels(size.GetY()));
  for (size_t row = 0; row < image.GetHeight(); ++row) {
    for (size_t column = 0; column < image.GetWidth(); ++column) {
      // colour at the middle of the pixel
      const CColor color = GetColorAtPoint(corner.GetX() + (column + 0.5) / density,
                                           corner.GetY() + (row + 0.5) / density);
      image.At(column, row) = {color.GetRed(), color.GetGreen(), color.GetBlue()};
    }
  }
  image.Write(path);
}

REGISTER_ENTITY(
    CFloorEntity, "floor", "the authors of this project", "1.0", "The colours of the floor.",
    "The floor has colours, which ground sensors see and pictures show. It has no body.\n"
    "At most one floor counts: the one declared last.\n\n"
    "REQUIRED XML CONFIGURATION\n\n"
    "  <arena ...>\n"
    "    <floor id=\"floor\" source=\"image\" path=\"floor.png\" />\n"
    "  </arena>\n\n"
    "or, coloured by the loop functions' GetFloorColor(),\n\n"
    "    <floor id=\"floor\" source=\"loop_functions\" pixels_per_meter=\"100\" />\n\n"
    "Attributes:\n"
    "  id                string; unique among the entities\n"
    "  source            image or loop_functions\n"
    "  path              with source=\"image\": the image file, in any format that\n"
    "                    FreeImage reads. Relative to the working directory; $NAME is\n"
    "                    replaced by the value of that environment variable. The image\n"
    "                    is stretched over the arena, its lowest row at the smallest y;\n"
    "                    beyond the arena the colour of the nearest edge holds\n"
    "  pixels_per_meter  with source=\"loop_functions\": integer, at least 1; the\n"
    "                    resolution in pictures only, sensors see the exact colour\n\n"
    "OPTIONAL XML CONFIGURATION\n\n"
    "None.\n",
    "Usable")

}  // namespace argos
