#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "numbers/wide_number.hpp"
#include "solvers/event/core.hpp"

namespace carom::event {

/// As many as double has.
inline constexpr int kDigitsOfDouble = 16;

/// A core and the precision that it computes in: what is called by `->` and what its phases do is
/// done in that precision, on whatever thread.
class CoreInPrecision {
 public:
  /// REQUIRES: the core computes in double, or in wide numbers of so many digits.
  CoreInPrecision(std::unique_ptr<Core> core, int digits)
      : core_(std::move(core)), digits_(digits) {}

  /// For as long as one call lasts.
  class Call {
   public:
    Call(Core& core, int digits) : core_(core) {
      if (digits > kDigitsOfDouble) precision_.emplace(digits);
    }
    [[nodiscard]] Core* operator->() const { return &core_; }

   private:
    Core& core_;
    std::optional<WidePrecision> precision_;
  };
  [[nodiscard]] Call operator->() const { return {*core_, digits_}; }

  [[nodiscard]] std::vector<Phase> phases() const {
    std::vector<Phase> phases = (*this)->phases();
    if (digits_ <= kDigitsOfDouble) return phases;
    for (Phase& phase : phases) {
      phase.work = [digits = digits_, work = std::move(phase.work)](Share share) {
        const WidePrecision precision(digits);
        work(share);
      };
      phase.finish = [digits = digits_, finish = std::move(phase.finish)] {
        const WidePrecision precision(digits);
        return finish();
      };
    }
    return phases;
  }

 private:
  std::unique_ptr<Core> core_;
  int digits_;
};

}  // namespace carom::event
