#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_FLOOR_ENTITY_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_FLOOR_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/datatypes/color.h>

#include <atomic>
#include <memory>

namespace argos {

struct SSimulationContext;

/**
 * The painted ground. Its colour comes from an image stretched over the arena, or from the loop
 * functions (CLoopFunctions::GetFloorColor()).
 */
class CFloorEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  enum EColorSource { UNSET = 0, FROM_IMAGE, FROM_LOOP_FUNCTIONS };

  CFloorEntity();
  /** A floor coloured by the loop functions. @param pixelsPerMeter resolution when drawn, > 0. */
  CFloorEntity(const std::string& id, UInt32 pixelsPerMeter);
  /** A floor from an image file. @throws CARGoSException if it cannot be read. */
  CFloorEntity(const std::string& id, const std::string& fileName);
  ~CFloorEntity() override;

  /**
   * Reads `source` (image or loop_functions), `path` (image; $NAME is expanded; relative to the
   * working directory), `pixels_per_meter` (loop_functions; for drawing only).
   */
  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  std::string GetTypeDescription() const override { return "floor"; }

  /**
   * Colour at a point of the world frame, m. Row 0 of an image is at the lowest y; points outside
   * the arena take the colour of the nearest edge.
   *
   * Safe on any thread for images; with loop functions as safe as the user's GetFloorColor().
   */
  CColor GetColorAtPoint(Real x, Real y);

  EColorSource GetColorSource() const { return m_source; }
  /** True if views keep its pixels; otherwise they blend them. */
  bool IsPixelated() const { return m_imageWidth > 0; }
  /** Columns of its image, which cover the arena's x; 0 if it has none. */
  UInt32 GetImageWidth() const { return m_imageWidth; }
  /** Rows of its image, which cover the arena's y; 0 if it has none. */
  UInt32 GetImageHeight() const { return m_imageHeight; }
  /** Of a floor that loop functions paint: they paint an image of so many pixels. */
  void SetImageSize(UInt32 width, UInt32 height);
  /** Resolution for drawing, pixels per metre. */
  UInt32 GetPixelsPerMeter() const { return m_pixelsPerMeter; }
  /** True after SetChanged() until ClearChanged(): viewers redraw their texture. */
  bool HasChanged() const { return m_changed.load(std::memory_order_relaxed); }
  /** Any thread: robots may call it in ControlStep(). */
  void SetChanged() {
    m_changed.store(true, std::memory_order_relaxed);
    m_version.fetch_add(1, std::memory_order_relaxed);
  }
  void ClearChanged() { m_changed.store(false, std::memory_order_relaxed); }
  /** Changes whenever SetChanged() is called: for outputs that do not show the floor alone. */
  UInt64 GetVersion() const { return m_version.load(std::memory_order_relaxed); }

  /** Writes the floor as an image; the format follows the extension. @throws CARGoSException */
  void SaveAsImage(const std::string& path);

 private:
  class CImage;  // pixels read through the imaging library

  void LoadImage(const std::string& fileName);

  EColorSource m_source = UNSET;
  UInt32 m_pixelsPerMeter = 0;
  UInt32 m_imageWidth = 0;  // pixels
  UInt32 m_imageHeight = 0;  // pixels
  std::atomic<bool> m_changed{true};
  std::atomic<UInt64> m_version{0};
  std::unique_ptr<CImage> m_image;
  const SSimulationContext& m_context;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/vector3.h>
#endif

#endif
