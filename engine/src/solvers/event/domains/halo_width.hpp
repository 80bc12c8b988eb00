#pragma once

#include <algorithm>
#include <cstddef>

namespace carom::event {

/// How wide the halo of a domain is: so that about one domain in twenty has to be solved again.
///
/// Balls that may come near to those of the domain are followed to the end of the window, and some
/// farther out; beyond, balls are followed for less and less of it, to where none is loaded.
/// Holds: it decides what a run costs, not what comes out.
class HaloWidth {
 public:
  /// Wider than single precision and what two sums of a place may differ by, in spacings.
  static constexpr double kSlack = 1e-3;
  /// A domain solved again gets a halo so much wider.
  static constexpr double kWiderAgain = 1.4;

  struct Gas {
    double spacing = 1;
    double normal_radius = 0;
  };
  void reset(const Gas& gas) {
    gas_ = gas;
    pyramid_ = kFirstPyramid;
  }
  /// Balls are followed to the end of a window so much farther out than those that may come near,
  /// in diameters: an impact that is missed beyond shows at once in the next ball.
  void follow_beyond(double diameters) { followed_ = diameters; }

  struct Width {
    double full;   ///< balls no farther away are followed to the end
    double reach;  ///< those farther away are not loaded
  };
  /// `displaced`: how far a ball went in a window as long; `wider`: than other halos.
  [[nodiscard]] Width of(double displaced, double wider) const {
    const double beyond = followed_ * std::min(gas_.spacing, 2 * gas_.normal_radius);
    const double full =
        (2 * kFarther * displaced + 2 * gas_.normal_radius + beyond + slack()) * wider;
    return {full, full + pyramid_ * gas_.spacing * wider};
  }
  [[nodiscard]] double slack() const { return kSlack * gas_.spacing; }

  /// So many of the domains had to be solved again in the last window.
  void learn(std::size_t again, std::size_t domains) {
    const double part = static_cast<double>(again) / static_cast<double>(domains);
    const double wider = part > 0.2 ? 1.2 : part > 0.06 ? 1.05 : part > 0 ? 0.99 : 0.98;
    pyramid_ = std::clamp(pyramid_ * wider, 1.0, 40.0);
  }

 private:
  // How wide it is initially beyond the balls followed to the end, in spacings.
  static constexpr double kFirstPyramid = 4;
  // Halos are as much wider as farther displacements than those of the last window ask for.
  static constexpr double kFarther = 1.15;

  Gas gas_;
  double followed_ = 1.5;
  double pyramid_ = kFirstPyramid;  ///< in spacings
};

}  // namespace carom::event
