#include <argos3/plugins/simulator/visualizations/scene/floor_image.h>

#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/visualization/floor_samples.h>

#include <memory>
#include <utility>

namespace argos {

void CFloorImage::Update(CSpace& space) {
  if (!space.HasFloorEntity()) {
    m_image = SFloorImage();
    m_floor = nullptr;
    return;
  }
  CFloorEntity& floor = space.GetFloorEntity();
  if (m_floor == &floor && m_version == floor.GetVersion()) {
    return;
  }
  m_floor = &floor;
  m_version = floor.GetVersion();
  SFloorSamples samples = SampleFloor(floor, space.GetArenaCenter(), space.GetArenaSize());
  m_image.Width = samples.Width;
  m_image.Height = samples.Height;
  m_image.IsSmooth = !floor.IsPixelated();
  m_image.Pixels = std::make_shared<const std::vector<std::uint8_t>>(std::move(samples.Pixels));
  ++m_image.Version;
}

}  // namespace argos
