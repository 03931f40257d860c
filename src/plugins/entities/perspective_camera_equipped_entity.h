#ifndef ARGOS3_PLUGINS_ENTITIES_PERSPECTIVE_CAMERA_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_PERSPECTIVE_CAMERA_EQUIPPED_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

struct SAnchor;

/**
 * A camera that looks along the x axis of its frame, with y to the left and z up in its image.
 *
 * The frame is fixed to an anchor of the body, at the anchor's origin unless SetMount() changes it;
 * a pan-and-tilt head may rotate the view about the frame's origin. Starts disabled; a sensor that
 * uses it enables it.
 */
class CPerspectiveCameraEquippedEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  /** A camera without an anchor (see SetAnchor()): 30 degrees, 0.035 m, 2 m, 640 x 480. */
  explicit CPerspectiveCameraEquippedEntity(CComposableEntity* parent);
  /**
   * @param aperture     see SetAperture().
   * @param focalLength  m, > 0.
   * @param range        m, > 0.
   * @param width, height  of the image, pixels, > 0.
   * @param anchor       see SetAnchor().
   * @throws CARGoSException if a value is out of range.
   */
  CPerspectiveCameraEquippedEntity(CComposableEntity* parent, const std::string& id,
                                   const CRadians& aperture, Real focalLength, Real range,
                                   SInt32 width, SInt32 height, SAnchor& anchor);

  /** Resets pan and tilt to 0. */
  void Reset() override;
  std::string GetTypeDescription() const override { return "perspective_camera"; }
  /** Also enables or disables the use of its anchor. */
  void SetEnabled(bool enabled) override;
  virtual void Enable() { CEntity::Enable(); }
  virtual void Disable() { CEntity::Disable(); }

  const CRadians& GetAperture() const { return m_aperture; }
  /**
   * @param aperture  half angle from the middle to a corner of the image, in (0, PI/2).
   */
  void SetAperture(const CRadians& aperture);
  Real GetFocalLength() const { return m_focalLength; }
  void SetFocalLength(Real focalLength);
  /** Depth of view, m, along the view direction. */
  Real GetRange() const { return m_range; }
  void SetRange(Real range);
  SInt32 GetImagePxWidth() const { return m_width; }
  SInt32 GetImagePxHeight() const { return m_height; }
  void SetImagePxSize(SInt32 width, SInt32 height);
  /** Size of the image on the sensor chip, m. */
  Real GetImageMtWidth() const;
  Real GetImageMtHeight() const;

  /** @throws CARGoSException if there is no anchor. */
  const SAnchor& GetAnchor() const;
  /** Sets the anchor to which the camera is fixed. */
  void SetAnchor(SAnchor& anchor);
  const CVector3& GetOffset() const { return m_offset; }
  const CQuaternion& GetOrientation() const { return m_orientation; }
  /** @param offset, orientation  of the camera's frame in the anchor's frame, m. */
  void SetMount(const CVector3& offset, const CQuaternion& orientation);

  const CRadians& GetPan() const { return m_pan; }
  const CRadians& GetTilt() const { return m_tilt; }
  /**
   * Rotates the view: first by @p tilt about the y axis of the frame (positive: down), then by @p
   * pan about its z axis (positive: left).
   */
  void SetPanTilt(const CRadians& pan, const CRadians& tilt);

  /** The camera's current position, m, world frame. */
  CVector3 ComputePosition() const;
  /** The current orientation of the view, world frame; x is the view direction. */
  CQuaternion ComputeView() const;

  void UpdateDigest(CDigest& digest) const override;

 private:
  std::string Describe() const;
  void FixTo(SAnchor* anchor);

  CRadians m_aperture;
  Real m_focalLength = 0.0;  // m
  Real m_range = 0.0;  // m
  SInt32 m_width = 0, m_height = 0;  // pixels
  SAnchor* m_anchor = nullptr;
  CVector3 m_offset;  // anchor's frame, m
  CQuaternion m_orientation;  // anchor's frame
  CRadians m_pan, m_tilt;
  CQuaternion m_mountAndTurn;  // orientation of the view, anchor's frame
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/physics_engine/physics_model.h>
#endif

#endif
