#include <argos3/core/simulator/placement/vector_generator.h>

#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/text/classic_locale.h>

#include <cmath>
#include <sstream>

namespace argos {

namespace {

std::string Text(const CVector3& vector) {
  CTextOutput text;
  text << "(" << vector << ")";
  return text.str();
}

// places of a grid along an axis
constexpr UInt64 kMaxOnAxis = 1000000;

class CUniformGenerator : public CVectorGenerator {
 public:
  CUniformGenerator(TConfigurationNode& node, CRandom::CRNG& rng) : m_rng(rng) {
    GetNodeAttribute(node, "min", m_min);
    GetNodeAttribute(node, "max", m_max);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      if (m_min[axis] > m_max[axis]) {
        THROW_ARGOSEXCEPTION(node.GetLocation()
                             << ": <" << node.Value()
                             << ">: \"min\" must not exceed \"max\" in any "
                             << "component, found " << Text(m_min) << " and " << Text(m_max));
      }
    }
  }

  CVector3 Next(bool) override {
    CVector3 result;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      result[axis] = m_rng.Uniform(CRange<Real>(m_min[axis], m_max[axis]));
    }
    return result;
  }

  bool GetExtent(CVector3& min, CVector3& max) const override {
    min = m_min;
    max = m_max;
    return true;
  }

  std::string Describe() const override {
    return "drawn uniformly from " + Text(m_min) + " to " + Text(m_max);
  }

 private:
  CRandom::CRNG& m_rng;
  CVector3 m_min;
  CVector3 m_max;
};

class CGaussianGenerator : public CVectorGenerator {
 public:
  CGaussianGenerator(TConfigurationNode& node, CRandom::CRNG& rng) : m_rng(rng) {
    GetNodeAttribute(node, "mean", m_mean);
    GetNodeAttribute(node, "std_dev", m_stdDev);
  }

  CVector3 Next(bool) override {
    CVector3 result;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      result[axis] = m_rng.Gaussian(m_stdDev[axis], m_mean[axis]);
    }
    return result;
  }

  bool GetExtent(CVector3&, CVector3&) const override { return false; }

  std::string Describe() const override {
    return "drawn from a normal distribution with mean " + Text(m_mean) +
           " and standard deviation " + Text(m_stdDev);
  }

 private:
  CRandom::CRNG& m_rng;
  CVector3 m_mean;
  CVector3 m_stdDev;
};

class CConstantGenerator : public CVectorGenerator {
 public:
  explicit CConstantGenerator(TConfigurationNode& node) {
    GetNodeAttribute(node, "values", m_values);
  }

  CVector3 Next(bool) override { return m_values; }
  bool CanRetry() const override { return false; }
  bool GetExtent(CVector3& min, CVector3& max) const override {
    min = max = m_values;
    return true;
  }
  std::string Describe() const override { return "constantly " + Text(m_values); }

 private:
  CVector3 m_values;
};

/** Starts at the corner with the highest coordinates and goes down, x fastest. */
class CGridGenerator : public CVectorGenerator {
 public:
  explicit CGridGenerator(TConfigurationNode& node) {
    GetNodeAttribute(node, "center", m_center);
    GetNodeAttribute(node, "distances", m_distances);
    std::string layout;
    GetNodeAttribute(node, "layout", layout);
    ParseLayout(node, layout);
  }

  CVector3 Next(bool failed) override {
    // a rejected cell would be rejected again: a grid does not retry
    const UInt64 item = failed && m_next > 0 ? m_next - 1 : m_next++;
    RequireCapacity(item + 1);
    const UInt64 cell[3] = {item % m_layout[0], item / m_layout[0] % m_layout[1],
                            item / (m_layout[0] * m_layout[1])};
    CVector3 result;
    for (UInt32 axis = 0; axis < 3; ++axis) {
      const Real half = 0.5 * static_cast<Real>(m_layout[axis] - 1) * m_distances[axis];
      result[axis] = m_center[axis] + half - static_cast<Real>(cell[axis]) * m_distances[axis];
    }
    return result;
  }

  bool CanRetry() const override { return false; }
  bool GetExtent(CVector3& min, CVector3& max) const override {
    for (UInt32 axis = 0; axis < 3; ++axis) {
      const Real half = 0.5 * static_cast<Real>(m_layout[axis] - 1) * std::abs(m_distances[axis]);
      min[axis] = m_center[axis] - half;
      max[axis] = m_center[axis] + half;
    }
    return true;
  }
  void RequireCapacity(UInt64 quantity) const override {
    const UInt64 places = m_layout[0] * m_layout[1] * m_layout[2];
    if (quantity > places) {
      THROW_ARGOSEXCEPTION("the grid has only " << m_layout[0] << " x " << m_layout[1] << " x "
                                                << m_layout[2] << " places; item number "
                                                << places + 1 << " has none");
    }
  }
  std::string Describe() const override { return "on a grid around " + Text(m_center); }

 private:
  void ParseLayout(TConfigurationNode& node, const std::string& layout) {
    std::vector<std::string> fields;
    Tokenize(layout, fields, ", \t");
    bool good = fields.size() == 3;
    for (size_t axis = 0; good && axis < 3; ++axis) {
      // the product of three is a number of 64 bits
      good = ParseNumber(fields[axis], m_layout[axis]) == ENumberParsing::Ok &&
             m_layout[axis] > 0 && m_layout[axis] <= kMaxOnAxis;
    }
    if (!good) {
      THROW_ARGOSEXCEPTION(node.GetLocation()
                           << ": <" << node.Value() << ">: \"layout\" must be three whole numbers "
                           << "above 0, at most " << kMaxOnAxis << ", such as \"5,4,1\"; found \""
                           << layout << "\"");
    }
  }

  CVector3 m_center;
  CVector3 m_distances;
  UInt64 m_layout[3] = {1, 1, 1};
  UInt64 m_next = 0;
};

}  // namespace

std::unique_ptr<CVectorGenerator> CreateVectorGenerator(TConfigurationNode& node,
                                                        CRandom::CRNG& rng) {
  std::string method;
  GetNodeAttribute(node, "method", method);
  if (method == "uniform") {
    return std::make_unique<CUniformGenerator>(node, rng);
  }
  if (method == "gaussian") {
    return std::make_unique<CGaussianGenerator>(node, rng);
  }
  if (method == "constant") {
    return std::make_unique<CConstantGenerator>(node);
  }
  if (method == "grid") {
    return std::make_unique<CGridGenerator>(node);
  }
  THROW_ARGOSEXCEPTION(node.GetLocation()
                       << ": <" << node.Value() << ">: unknown method \"" << method << "\""
                       << DidYouMean(method, {"uniform", "gaussian", "constant", "grid"}));
}

}  // namespace argos
