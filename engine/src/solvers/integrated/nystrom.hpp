#pragma once

#include <array>
#include <cstddef>

namespace carom {

/// A symmetric splitting of fourth order: the pull acts for a fraction `pull[0]` of the step, the
/// balls fly for `flight[0]`, and so on, ending with the pull.  The flight may be any whose
/// velocity is linear in the velocity, such as that under gravity and drag.
///
/// Each step is three of them in a row, for a hundredth of the error.
/// Source: Blanes and Moan, Practical symplectic partitioned Runge-Kutta and Runge-Kutta-Nystrom
/// methods, J. Comput. Appl. Math. 142 (2002) 313: SRKN_6^b.
struct Nystrom {
  static constexpr std::size_t kStages = 6;
  static constexpr std::size_t kInAStep = 3;

  static constexpr double kPull0 = 0.0829844064174052;
  static constexpr double kPull1 = 0.396309801498368;
  static constexpr double kPull2 = -0.0390563049223486;
  static constexpr double kPull3 = 1 - 2 * (kPull0 + kPull1 + kPull2);
  static constexpr double kFlight0 = 0.245298957184271;
  static constexpr double kFlight1 = 0.604872665711080;
  static constexpr double kFlight2 = 0.5 - (kFlight0 + kFlight1);

  static constexpr std::array<double, kStages + 1> pull{kPull0, kPull1, kPull2, kPull3,
                                                        kPull2, kPull1, kPull0};
  static constexpr std::array<double, kStages> flight{kFlight0, kFlight1, kFlight2,
                                                      kFlight2, kFlight1, kFlight0};
};

}  // namespace carom
