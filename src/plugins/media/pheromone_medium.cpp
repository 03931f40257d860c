#include <argos3/plugins/simulator/media/pheromone_medium.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

constexpr Real kMaxLayerCells = 1 << 26;  // limit of a layer: half a gigabyte

}  // namespace

struct CPheromoneMedium::SState {
  std::vector<CPheromoneField> Fields;  // are indexed by layer; empty until the arena is known
  CMediumUsers Users;  // all are CUsers
};

CPheromoneMedium::CUser::CUser(CPheromoneMedium& medium, const CControllableEntity& robot)
    : CMediumUser(medium.m_state->Users, robot), Rates(medium.GetNumLayers(), 0.0) {}

CPheromoneMedium::CPheromoneMedium() : m_state(std::make_unique<SState>()) {}

CPheromoneMedium::~CPheromoneMedium() = default;

void CPheromoneMedium::Init(TConfigurationNode& tree) {
  CMedium::Init(tree);
  m_owner = OwnerOf(tree) + " \"" + GetId() + "\"";
  ReadOptionalPositive(tree, "cell_size", "m", m_cellSize);
  m_hasSize = NodeAttributeExists(tree, "size");
  if (m_hasSize) {
    GetNodeAttribute(tree, "size", m_size);
    RequirePositive(m_size.GetX(), m_owner, "attribute \"size\" (m) along x");
    RequirePositive(m_size.GetY(), m_owner, "attribute \"size\" (m) along y");
  }
  m_hasCenter = NodeAttributeExists(tree, "center");
  GetNodeAttributeOrDefault(tree, "center", m_center, m_center);
  TConfigurationNodeIterator child("layer");
  for (child = child.begin(&tree); child != child.end(); ++child) {
    ReadLayer(*child);
  }
  if (m_layers.empty()) {
    THROW_ARGOSEXCEPTION(m_owner << " needs at least one child <layer id=\"...\" />");
  }
}

void CPheromoneMedium::ReadLayer(TConfigurationNode& node) {
  SLayer layer;
  GetNodeAttribute(node, "id", layer.Id);
  for (const SLayer& other : m_layers) {
    if (other.Id == layer.Id) {
      THROW_ARGOSEXCEPTION(OwnerOf(node) << ": there is already a layer with id \"" << layer.Id
                                         << "\"; ids must be unique");
    }
  }
  GetNodeAttributeOrDefault(node, "evaporation", layer.Evaporation, layer.Evaporation);
  RequireNotNegative(layer.Evaporation, OwnerOf(node), "attribute \"evaporation\" (1/s)");
  GetNodeAttributeOrDefault(node, "diffusion", layer.Diffusion, layer.Diffusion);
  RequireNotNegative(layer.Diffusion, OwnerOf(node), "attribute \"diffusion\" (m^2/s)");
  layer.Maximum = HUGE_VAL;
  ReadOptionalPositive(node, "maximum", "1/m^2", layer.Maximum);
  m_layers.push_back(layer);
}

void CPheromoneMedium::Reset() {
  for (CPheromoneField& field : m_state->Fields) {
    field.Clear();
  }
  for (CMediumUser* user : m_state->Users.Get()) {
    user->HasOrder = false;
  }
}

void CPheromoneMedium::Destroy() {
  m_state->Users.RemoveAll();
}

void CPheromoneMedium::PostSpaceInit() {
  MakeFields();
}

void CPheromoneMedium::MakeFields() {
  if (!m_state->Fields.empty()) {
    return;
  }
  const CVector3& arenaSize = GetSpace().GetArenaSize();
  const CVector3& arenaCenter = GetSpace().GetArenaCenter();
  const CVector2 size = m_hasSize ? m_size : CVector2(arenaSize.GetX(), arenaSize.GetY());
  const CVector2 center = m_hasCenter ? m_center : CVector2(arenaCenter.GetX(), arenaCenter.GetY());
  const auto count = [this](Real length) {
    // minus the rounding error, so that a length of n cells gives n cells
    return std::max(1.0, std::ceil(length / m_cellSize - 1e-9));
  };
  const Real numX = count(size.GetX());
  const Real numY = count(size.GetY());
  if (!(numX * numY <= kMaxLayerCells)) {
    THROW_ARGOSEXCEPTION(m_owner << ": cells of " << m_cellSize << " m are too small for "
                                 << size.GetX() << " m x " << size.GetY() << " m; at most "
                                 << kMaxLayerCells << " cells are possible");
  }
  CPheromoneField::SGrid grid;
  grid.MinX = center.GetX() - 0.5 * size.GetX();
  grid.MinY = center.GetY() - 0.5 * size.GetY();
  grid.CellX = size.GetX() / numX;
  grid.CellY = size.GetY() / numY;
  grid.NumX = static_cast<size_t>(numX);
  grid.NumY = static_cast<size_t>(numY);
  const SPeriodicity& period = GetSpace().GetContext().Arena.Period;
  if (period.IsOn() && (m_hasSize || m_hasCenter)) {
    THROW_ARGOSEXCEPTION(m_owner << ": \"size\" and \"center\" cannot be given in an <arena "
                                    "periodic=...>: the field is as large as the arena");
  }
  grid.JoinsX = period.X.IsOn();
  grid.JoinsY = period.Y.IsOn();
  m_state->Fields.reserve(m_layers.size());
  for (const SLayer& layer : m_layers) {
    m_state->Fields.emplace_back(grid, layer.Evaporation, layer.Diffusion, layer.Maximum);
  }
}

void CPheromoneMedium::TakeActs() {
  const Real seconds = m_cSimulator.GetTickLength();
  for (const CMediumUser* user : m_state->Users.TakeOrders()) {
    const auto& laying = static_cast<const CUser&>(*user);
    for (size_t layer = 0; layer < laying.Rates.size(); ++layer) {
      if (laying.Rates[layer] > 0.0) {
        Deposit(layer, laying.Place, laying.Rates[layer] * seconds);
      }
    }
  }
}

void CPheromoneMedium::Update() {
  for (CPheromoneField& field : m_state->Fields) {
    field.Advance(m_cSimulator.GetThreadPool(), m_cSimulator.GetTickLength());
  }
}

size_t CPheromoneMedium::GetLayerNumber(const std::string& id) const {
  std::vector<std::string> known;
  for (size_t layer = 0; layer < m_layers.size(); ++layer) {
    if (m_layers[layer].Id == id) {
      return layer;
    }
    known.push_back(m_layers[layer].Id);
  }
  THROW_ARGOSEXCEPTION("pheromone \"" << GetId() << "\" has no layer \"" << id << "\""
                                      << DidYouMean(id, known));
}

std::vector<size_t> CPheromoneMedium::ReadLayers(TConfigurationNode& device) const {
  std::vector<size_t> layers;
  if (!NodeAttributeExists(device, "layers")) {
    for (size_t layer = 0; layer < m_layers.size(); ++layer) {
      layers.push_back(layer);
    }
    return layers;
  }
  std::string text;
  GetNodeAttribute(device, "layers", text);
  std::vector<std::string> ids;
  Tokenize(text, ids, ", ");
  try {
    for (const std::string& id : ids) {
      const size_t layer = GetLayerNumber(id);
      if (std::find(layers.begin(), layers.end(), layer) != layers.end()) {
        THROW_ARGOSEXCEPTION("\"" << id << "\" is listed twice");
      }
      layers.push_back(layer);
    }
    if (layers.empty()) {
      THROW_ARGOSEXCEPTION("no layer is listed");
    }
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(OwnerOf(device) << ": attribute \"layers\" must list layers of the "
                                                   "medium, separated by commas, got \""
                                                << text << "\"",
                                error);
  }
  return layers;
}

Real CPheromoneMedium::GetConcentration(size_t layer, const CVector3& point) const {
  CheckLayer(layer);
  return m_state->Fields.empty()
             ? 0.0
             : m_state->Fields[layer].GetConcentration(point.GetX(), point.GetY());
}

void CPheromoneMedium::Deposit(size_t layer, const CVector3& point, Real amount) {
  CheckLayer(layer);
  if (!(amount >= 0.0 && amount < HUGE_VAL)) {
    RequireNotNegative(amount, "pheromone \"" + GetId() + "\"", "an amount");
  }
  MakeFields();
  m_state->Fields[layer].Deposit(point.GetX(), point.GetY(), amount);
}

CPheromoneField& CPheromoneMedium::GetField(size_t layer) {
  CheckLayer(layer);
  MakeFields();
  return m_state->Fields[layer];
}

void CPheromoneMedium::UpdateDigest(CDigest& digest) const {
  for (const CPheromoneField& field : m_state->Fields) {
    for (size_t j = 0; j < field.GetGrid().NumY; ++j) {
      for (size_t i = 0; i < field.GetGrid().NumX; ++i) {
        digest.Add(field.GetCell(i, j));
      }
    }
  }
}

REGISTER_MEDIUM(
    CPheromoneMedium, "pheromone", "the authors of this project", "1.0",
    "Substances on the ground that robots deposit and measure.",
    R"(Each layer is a substance on the floor of the arena. Robots with the actuator "pheromone" deposit it, those with the
sensor "pheromone" measure its concentration c, an amount per m^2. It evaporates and diffuses,

  dc/dt = diffusion (d2c/dx2 + d2c/dy2) - evaporation c,

inside a region with closed borders, by default the arena. Evaporation is exact: after the time t the share
exp(-evaporation t) is left. The floor is divided into cells; the variance of a spot grows by 2 diffusion t along each
axis, and diffusion conserves the amount.

REQUIRED XML

  <media>
    <pheromone id="pheromone">
      <layer id="trail" />
    </pheromone>
  </media>

ATTRIBUTES

  id        text, required: unique among the media.
  layer     at least one child.
  layer@id  text, required: unique among the layers; also the name for controllers.

OPTIONAL XML

  <media>
    <pheromone id="pheromone" cell_size="0.02" size="4,3" center="0.5,0">
      <layer id="trail" evaporation="0.01" diffusion="0.0001" maximum="1000" />
      <layer id="alarm" evaporation="0.5" diffusion="0.02" />
    </pheromone>
  </media>

  size, center       "x,y", m: the region, a rectangle; each by default the arena's. Outside the concentration is 0.
  cell_size          m, > 0, default 0.05: upper limit of the side of a cell; the region has whole cells. Smaller cells
                     resolve finer trails, and cost time and memory: 8 to 16 bytes and some nanoseconds a tick per cell.
  layer@evaporation  1/s, >= 0, default 0: 1 / tau; after the time tau the share 1/e is left.
  layer@diffusion    m^2/s, >= 0, default 0: diffusion coefficient. Without diffusion a layer costs nothing but
                     memory.
  layer@maximum      1/m^2, > 0, default none: upper limit of the concentration in a cell; further deposits are lost.
)",
    "Usable")

}  // namespace argos
