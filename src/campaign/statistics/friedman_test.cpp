#include <argos3/campaign/statistics/friedman_test.h>

#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/ranks.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

SChiSquareResult TestFriedman(std::span<const std::vector<Real>> blocks) {
  RequireGroups(blocks, 2, 2);
  const size_t numTreatments = blocks[0].size();
  std::vector<Real> rankSums(numTreatments, 0.0);
  Real tieTerm = 0.0;
  for (size_t i = 0; i < blocks.size(); ++i) {
    if (blocks[i].size() != numTreatments) {
      THROW_ARGOSEXCEPTION("Friedman's test: block " << i + 1 << " has " << blocks[i].size()
                                                     << " values, block 1 has " << numTreatments
                                                     << "; one for each treatment is needed");
    }
    const SRanking ranking = ComputeRanks(blocks[i]);
    tieTerm += ranking.TieTerm;
    for (size_t j = 0; j < numTreatments; ++j) {
      rankSums[j] += ranking.Ranks[j];
    }
  }
  const auto n = static_cast<Real>(blocks.size());
  const auto k = static_cast<Real>(numTreatments);
  Real squares = 0.0;
  for (const Real sum : rankSums) {
    const Real excess = sum - n * (k + 1.0) / 2.0;
    squares += excess * excess;
  }
  const Real scale = n * k * (k + 1.0) - tieTerm / (k - 1.0);
  const Real statistic = scale > 0.0 ? 12.0 * squares / scale : 0.0;
  return {statistic, numTreatments - 1, ComputeChiSquareUpperTail(statistic, k - 1.0)};
}

}  // namespace argos
