#ifndef ARGOS3_PLUGINS_MEDIA_PHEROMONE_MEDIUM_H
#define ARGOS3_PLUGINS_MEDIA_PHEROMONE_MEDIUM_H

#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/media/medium_users.h>
#include <argos3/plugins/simulator/media/pheromone_field.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

/**
 * Substances on the ground that robots deposit and measure; they evaporate and diffuse.
 *
 * Each layer is one substance, a concentration (amount per m^2) on a rectangle of the ground, by
 * default the arena's, with closed borders. Robots deposit at their positions when they act, in the
 * order of the robots' insertion into the space; after physics, substances evaporate and diffuse
 * for one tick, then sensors read. Heights are ignored.
 */
class CPheromoneMedium : public CMedium {
 public:
  /** An actuator; while it has an order, it deposits substances at a place. */
  class CUser : public CMediumUser {
   public:
    CUser(CPheromoneMedium& medium, const CControllableEntity& robot);

    CVector3 Place; /**< m, world frame */
    std::vector<Real> Rates; /**< (layers), amount per second, >= 0 */
  };

  CPheromoneMedium();
  ~CPheromoneMedium() override;

  /**
   * Reads `id`, `cell_size`, `size` and `center`, and for each child `<layer>` its `id`,
   * `evaporation`, `diffusion` and `maximum`.
   * @throws CARGoSException if a value is out of range, two layers have the same id, or there is
   *   none.
   */
  void Init(TConfigurationNode& tree) override;
  /** Sets all concentrations to 0. */
  void Reset() override;
  void Destroy() override;
  /** @throws CARGoSException if the region has too many cells. */
  void PostSpaceInit() override;
  void TakeActs() override;
  bool CanBePeriodic() const override { return true; }
  void Update() override;
  bool UsesThreadPool() const override { return true; }
  void UpdateDigest(CDigest& digest) const override;

  size_t GetNumLayers() const { return m_layers.size(); }
  /** @param layer < GetNumLayers(), also below. */
  const std::string& GetLayerId(size_t layer) const {
    CheckLayer(layer);
    return m_layers[layer].Id;
  }
  /** @throws CARGoSException with the existing layers if the id is unknown. */
  size_t GetLayerNumber(const std::string& id) const;
  /**
   * For devices: the layers listed in the attribute `layers`, separated by commas; all layers if it
   * is missing. @throws CARGoSException if a layer is unknown or listed twice.
   */
  std::vector<size_t> ReadLayers(TConfigurationNode& device) const;

  /**
   * Amount per m^2 at a point of the floor, m, world frame: bilinear interpolation between the
   * centres of cells; 0 outside the region. Safe on several threads at once.
   */
  Real GetConcentration(size_t layer, const CVector3& point) const;
  /**
   * Deposits an amount at a point of the floor, distributed over the nearest cells; deposits
   * outside the region are lost. Must not be called while sensors read.
   * @param amount >= 0. @throws CARGoSException if it is out of range.
   */
  void Deposit(size_t layer, const CVector3& point, Real amount);
  /**
   * A layer, cell by cell, for reading and writing by loop functions; all layers have the same
   * cells. Available from the loop functions' Init() on. Must not be changed while sensors read.
   * @throws CARGoSException if the region would have too many cells.
   */
  CPheromoneField& GetField(size_t layer);

 private:
  struct SLayer {
    std::string Id;
    Real Evaporation = 0.0;  // 1/s
    Real Diffusion = 0.0;  // m^2/s
    Real Maximum = 0.0;  // 1/m^2
  };
  struct SState;  // fields, users

  void CheckLayer([[maybe_unused]] size_t layer) const {
    ARGOS_ASSERT(layer < m_layers.size(), "there is no layer " << layer << " of pheromone");
  }
  void ReadLayer(TConfigurationNode& node);
  void MakeFields();

  std::string m_owner;  // element in the file, for messages
  Real m_cellSize = 0.05;  // m
  bool m_hasSize = false, m_hasCenter = false;  // false: the arena's
  CVector2 m_size, m_center;  // describe the region, m
  std::vector<SLayer> m_layers;
  std::unique_ptr<SState> m_state;
};

}  // namespace argos

#endif
