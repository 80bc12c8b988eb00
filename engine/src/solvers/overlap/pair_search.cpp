#include "solvers/overlap/pair_search.hpp"

#include <algorithm>
#include <cmath>

#include "contact/skin.hpp"
#include "contact/touching.hpp"
#include "effects/flight.hpp"
#include "solvers/overlap/plan.hpp"

namespace carom::overlap {

void PairSearch::set_workers(std::size_t workers) {
  workers_.resize(workers);
  forget();
}

void PairSearch::forget() {
  listed_ = false;
  all_pairs_.clear();
}

void PairSearch::cache_all_pairs() {
  if (!uses_list() && all_pairs_.count == 0) all_pairs_ = all_pairs(balls_);
}

bool PairSearch::uses_list() const {
  return choice_ == Pairs::neighbours ||
         (choice_ == Pairs::automatic && balls_.size() >= Plan::kManyBalls);
}

bool PairSearch::is_stale() const {
  if (!listed_) return true;
  // Two balls that were farther apart than reach and skin, and have each moved less than half the
  // skin, do not touch.  The rest of the half is for rounding.
  const double allowed = 0.49 * skin_;
  return std::any_of(workers_.begin(), workers_.end(), [allowed](const Worker& worker) {
    return !(worker.moved_square < allowed * allowed);
  });
}

void PairSearch::note_moves(std::size_t worker, std::size_t begin, std::size_t end) {
  // In lanes and without branches: which way a ball has gone cannot be foreseen.
  constexpr std::size_t kLanes = 8;
  alignas(64) std::array<double, Flight::kBlock> square{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double* now = balls_.position[axis].data() + begin;
    const double* from = anchor_[axis].data() + begin;
    const double period = domain_.period[axis];
    for (std::size_t k = 0; k < end - begin; ++k) {
      const double d = std::abs(now[k] - from[k]);
      // A ball that has gone round comes back by one period; there is none where it is 0.
      const double other = std::abs(d - period);
      const double moved = other < d ? other : d;
      square[k] += moved * moved;
    }
  }
  std::array<double, kLanes> farthest{};
  for (std::size_t k = 0; k < square.size(); k += kLanes) {
    for (std::size_t l = 0; l < kLanes; ++l) {
      farthest[l] = square[k + l] > farthest[l] ? square[k + l] : farthest[l];
    }
  }
  double& moved_square = workers_[worker].moved_square;
  for (const double lane : farthest) moved_square = std::max(moved_square, lane);
}

void PairSearch::sort(double step) {
  const Skin skin = choose_skin(balls_, domain_, step);
  skin_ = skin.thickness;
  near_ = (stretch_ - 1) * (skin.reach - skin.thickness);
  grid_.sort(balls_, domain_, skin.reach + near_);
  anchor_ = balls_.position;
  listed_ = true;
}

void PairSearch::search(Share share) {
  PairList& pairs = workers_[share.index].neighbours;
  pairs.clear();
  grid_.neighbours(domain_, share.begin(grid_.cells()), share.end(grid_.cells()), skin_ + near_,
                   pairs);
}

void PairSearch::build(double step) {
  sort(step);
  for (std::size_t w = 0; w < workers_.size(); ++w) search({w, workers_.size()});
}

double PairSearch::find_touching(Share share, std::vector<Pair>& touching) const {
  const bool listed = uses_list();
  const PairList& pairs = listed ? workers_[share.index].neighbours : all_pairs_;
  const std::size_t begin = listed ? 0 : share.begin(pairs.count);
  const std::size_t end = listed ? pairs.count : share.end(pairs.count);
  return carom::find_touching(pairs, begin, end, balls_, domain_.period, stretch_, touching);
}

std::vector<Pair> PairSearch::overlapping_after_pushes(double step) {
  if (uses_list()) {
    // The list has been looked at since the flight, not since the pushes.
    for (std::size_t i = 0; i < balls_.size(); i += Flight::kBlock) {
      note_moves(0, i, std::min(i + Flight::kBlock, balls_.size()));
    }
    if (is_stale()) build(step);
  }
  return all_overlapping();
}

std::vector<Pair> PairSearch::all_within(double stretch) const {
  std::vector<Pair> found;
  const auto look = [&](const PairList& pairs) {
    carom::find_touching(pairs, 0, pairs.count, balls_, domain_.period, stretch, found);
  };
  if (uses_list()) {
    for (const Worker& worker : workers_) look(worker.neighbours);
  } else {
    look(all_pairs_);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace carom::overlap
