#ifndef ARGOS3_TESTING_UNIT_CAMPAIGN_STATISTICS_SAMPLES_H
#define ARGOS3_TESTING_UNIT_CAMPAIGN_STATISTICS_SAMPLES_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

// depression scale of nine patients before and after a therapy: M. Hollander and D. A. Wolfe,
// Nonparametric Statistical Methods (1973), 29f; R: ?wilcox.test
inline const std::vector<Real> kDepressionBefore = {1.83, 0.50, 1.62, 2.48, 1.68,
                                                    1.88, 1.55, 3.06, 1.30};
inline const std::vector<Real> kDepressionAfter = {0.878, 0.647, 0.598, 2.05, 1.06,
                                                   1.29,  1.06,  3.14,  1.29};

// permeability of a membrane at term and at 12 to 26 weeks: the same book, 69f; R: ?wilcox.test
inline const std::vector<Real> kPermeabilityAtTerm = {0.80, 0.83, 1.89, 1.04, 1.45,
                                                      1.38, 1.91, 1.64, 0.73, 1.46};
inline const std::vector<Real> kPermeabilityBefore = {1.15, 0.88, 0.90, 0.74, 1.21};

// R's airquality, Ozone without missing values, May to September
inline const std::vector<std::vector<Real>> kOzone = {
    {41, 36, 12, 18, 28, 23, 19, 8, 7,  16, 11, 14,  18,
     14, 34, 6,  30, 11, 1,  11, 4, 32, 23, 45, 115, 37},
    {29, 71, 39, 23, 21, 37, 20, 12, 13},
    {135, 49, 32, 64, 40, 77, 97,  97, 85, 10, 27, 7,  48,
     35,  61, 79, 63, 16, 80, 108, 20, 52, 82, 50, 64, 59},
    {39, 9,  16, 78, 35, 66, 122, 89,  110, 44, 28,  65, 22,
     59, 23, 31, 44, 21, 9,  45,  168, 73,  76, 118, 84, 85},
    {96, 78, 73, 91, 47, 32, 20, 23, 21, 24, 44, 21, 28, 9, 13,
     46, 18, 13, 24, 16, 13, 23, 36, 7,  14, 30, 14, 18, 20}};

// R's sleep, extra of both drugs
inline const std::vector<Real> kSleepDrug1 = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
inline const std::vector<Real> kSleepDrug2 = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

// R's cars
inline const std::vector<Real> kCarSpeeds = {4,  4,  7,  7,  8,  9,  10, 10, 10, 11, 11, 12, 12,
                                             12, 12, 13, 13, 13, 13, 14, 14, 14, 14, 15, 15, 15,
                                             16, 16, 17, 17, 17, 18, 18, 18, 18, 19, 19, 19, 20,
                                             20, 20, 20, 20, 22, 23, 24, 24, 24, 24, 25};
inline const std::vector<Real> kCarDistances = {2,  10, 4,  22, 16, 10, 18, 26, 34, 17,  28, 14, 20,
                                                24, 28, 26, 34, 34, 46, 26, 36, 60, 80,  20, 26, 54,
                                                32, 40, 32, 40, 50, 42, 56, 76, 84, 36,  46, 68, 32,
                                                48, 52, 56, 64, 66, 54, 70, 92, 93, 120, 85};

}  // namespace argos

#endif
