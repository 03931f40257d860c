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
 * A device names its quantities ("range", "horizontal_bearing", ...). Each `<noise>` says what it
 * is `on`, or, without that, is on all of them; several on one quantity add up:
 *
 *     value' = value + sum of (bias + draw), or value + value * (bias + draw) if relative
 *
 * where the draws are from U[-level, level] (model "uniform"), N(0, std_dev) ("gaussian") or
 * Rayleigh(sigma) ("rayleigh"). Every draw takes one number of the device's own random stream.
 * Without a `<noise>` this is one null pointer, and nothing is drawn.
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
   * @param quantities  their names, in the order of their numbers.
   * @param evenly      what attributes of the device ask for, by quantity: a number drawn evenly
   *                    from the range is added; from "0:0", none. May be shorter.
   * @param part        tells parts of one device apart, which then have streams of their own.
   * @throws CARGoSException with the names there are, or the range that is right, if a value is
   * not.
   */
  void Init(TConfigurationNode& device, const CControllableEntity& robot,
            const std::vector<std::string>& quantities,
            const std::vector<CRange<Real>>& evenly = {}, const std::string& part = "");
  /** The stream starts over, with the seed that the experiment has now. */
  void Reset();

  bool IsOn() const { return m_state != nullptr; }
  /** On quantity @p number. */
  bool IsOn(size_t number) const;
  /** @return @p value with the noise on quantity @p number. */
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
/** Reads a range "min:max"; "0:0" if there is no such attribute. */
CRange<Real> ReadNoiseRange(TConfigurationNode& device, const std::string& attribute);

}  // namespace argos

#endif
