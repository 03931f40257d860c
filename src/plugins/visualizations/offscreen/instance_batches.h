#ifndef ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_INSTANCE_BATCHES_H
#define ARGOS3_PLUGINS_VISUALIZATIONS_OFFSCREEN_INSTANCE_BATCHES_H

#include <argos3/plugins/simulator/visualizations/scene/camera.h>
#include <argos3/plugins/simulator/visualizations/scene/scene.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace argos {

/** Corners of round meshes around the axis, by level of detail. */
constexpr std::array<int, 4> kSegmentsPerLevel = {6, 12, 24, 64};
constexpr std::size_t kNumLevels = kSegmentsPerLevel.size();

/** The sphere around a solid, world frame, m. */
struct SBoundingSphere {
  Eigen::Vector3d Center;
  double Radius = 0.0;
};

SBoundingSphere ComputeBoundingSphere(EMeshKind kind, const SMeshInstance& instance);

/** Translucent solids of one kind, to be drawn in order. */
struct STranslucentRange {
  EMeshKind Kind;
  std::size_t First; /**< index in CInstanceBatches::GetTranslucent() */
  std::size_t Count;
};

/**
 * The visible solids of a scene, sorted by mesh and level of detail, so that each pair takes one
 * draw call.
 *
 * Solids outside the view, solids that would cover less than a pixel, and details of less than a
 * few pixels are left out. The level of detail follows from the size on the picture, and
 * translucent solids of a few pixels count as opaque. The memory is reused for the next picture.
 */
class CInstanceBatches {
 public:
  typedef std::array<std::array<std::vector<SMeshInstance>, kNumLevels>, kNumMeshKinds> TBatches;

  /**
   * @param camera         of the picture.
   * @param pictureHeight  pixels.
   * @param toSun          unit vector, world frame: shadows lie along it.
   */
  void Fill(const SScene& scene, const CCamera& camera, int pictureHeight,
            const Eigen::Vector3d& toSun);

  /** Opaque solids in view. */
  const TBatches& GetOpaque() const { return m_opaque; }
  /** Translucent solids in view, far to near. */
  const std::vector<SMeshInstance>& GetTranslucent() const { return m_translucent; }
  /** The same, cut where the kind changes. */
  const std::vector<STranslucentRange>& GetTranslucentRanges() const { return m_ranges; }
  /** Solids whose shadow may be in view, opaque or not. */
  const TBatches& GetCasters() const { return m_casters; }
  /** Box around the shadow casters, in a frame whose axes are @p toSun's, see MakeSunFrame(). */
  const Eigen::AlignedBox3d& GetCasterBounds() const { return m_casterBounds; }
  /** Depths of the nearest and the farthest point of solids in view, m; empty if there are none. */
  const Eigen::AlignedBox<double, 1>& GetDepths() const { return m_depths; }

 private:
  struct SSortKey {
    double Depth;
    EMeshKind Kind;
    const SMeshInstance* Instance;  // points into the scene
  };

  void Add(EMeshKind kind, const SMeshInstance& instance);
  void SortTranslucent();

  // data of the picture being prepared
  const CCamera* m_camera = nullptr;
  Eigen::Matrix3d m_sunFrame;
  double m_pixelsPerUnit = 1.0;  // pixels per m, at depth 1 in perspective
  Eigen::Vector2d
      m_sideNorms;  // lengths of the normals of the side and the upper planes of the view

  TBatches m_opaque;
  TBatches m_casters;
  std::vector<SSortKey> m_sortKeys;
  std::vector<SMeshInstance> m_translucent;
  std::vector<STranslucentRange> m_ranges;
  Eigen::AlignedBox3d m_casterBounds;
  Eigen::AlignedBox<double, 1> m_depths;
};

/** A rotation from the world frame to one whose z axis points to the sun. */
Eigen::Matrix3d MakeSunFrame(const Eigen::Vector3d& toSun);

}  // namespace argos

#endif
