#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_NOISE_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_DEVICE_NOISE_H

#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/math/range.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

class CControllableEntity;

/**
 * The noise on the readings or commands of a device: the `<noise>` children of its XML element.
 *
 * A device names its quantities ("range", "horizontal_bearing", ...). The attribute `on` of a
 * `<noise>` names one quantity; without it, the noise is on all quantities. Several on one quantity
 * add up:
 *
 *     value' = value + sum of (bias + draw), or value + value * (bias + draw) if relative
 *
 * where the draws are from U[-level, level] (model "uniform"), N(0, std_dev) ("gaussian") or
 * Rayleigh(sigma) ("rayleigh"). Each draw takes one number from the device's own random stream.
 * Without a `<noise>` the object is one null pointer, and nothing is drawn.
 */
class CDeviceNoise {
 public:
  CDeviceNoise();
  ~CDeviceNoise();
  CDeviceNoise(CDeviceNoise&&) noexcept;
  CDeviceNoise& operator=(CDeviceNoise&&) noexcept;

  /**
   * Reads the children of a device's element.
   * @param robot       must outlive the noise.
   * @param quantities  names of the quantities, in the order of their numbers.
   * @param ranges      uniform noise from attributes of the device, by quantity: a number drawn
   *                    evenly from the range is added; "0:0" means no noise. May be shorter.
   * @param part        distinguishes parts of one device, which then have separate streams.
   * @throws CARGoSException with the valid names or range if a value is invalid.
   */
  void Init(TConfigurationNode& device, const CControllableEntity& robot,
            const std::vector<std::string>& quantities,
            const std::vector<CRange<Real>>& ranges = {}, const std::string& part = "");
  /** Restarts the stream with the current seed of the experiment. */
  void Reset();

  bool IsOn() const { return m_state != nullptr; }
  /** @return true if there is noise on quantity @p number. */
  bool IsOn(size_t number) const;
  /** @return @p value plus the noise on quantity @p number. */
  Real Apply(size_t number, Real value) {
    return m_state == nullptr ? value : ApplyState(number, value);
  }

 private:
  struct SState;

  Real ApplyState(size_t number, Real value);

  std::unique_ptr<SState> m_state;  // null without noise
};

/**
 * Reads the attribute `noise_level`.
 * @return [-level, level]; [0, 0] without it.
 * @throws CARGoSException if it is < 0.
 */
CRange<Real> ReadNoiseLevel(TConfigurationNode& device);
/** Reads a range "min:max"; "0:0" if the attribute does not exist. */
CRange<Real> ReadNoiseRange(TConfigurationNode& device, const std::string& attribute);

}  // namespace argos

#endif
