#include "contact/cone_island.hpp"

#include <algorithm>
#include <cmath>

#include "contact/cone_interior.hpp"

namespace carom::event {

namespace {

/// How often the slip is looked at again, with what its contacts carry then.
constexpr int kSlides = 3;

}  // namespace

ConeIsland::ConeIsland(const Bodies& bodies, const Contacts& contacts, std::size_t few)
    : contacts_(contacts), few_(few), response_(bodies, contacts) {
  for (Column* column : {&start_, &parting_, &impulses_, &change_}) {
    column->assign(response_.edges(), 0);
  }
}

void ConeIsland::solve(double goal, bool again) {
  if (contacts_.size() > few_ &&
      solve_by_interior_point(response_, parting_, goal / 2, again, impulses_)) {
    return;
  }
  descent_.solve(parting_, impulses_, goal);
}

// A contact that slides would open by the coefficient times its slip.  One with something that
// never moves, which slid before, too, is given that much to close: what is thrown along a floor
// stays on it.
void ConeIsland::close_slides(double goal, double opens) {
  const std::size_t size = response_.size();
  Column given(size, 0);
  const auto slip = [this, size](std::size_t k) {
    return std::abs((start_[k] + change_[k]) - (start_[size + k] + change_[size + k])) / 2;
  };
  for (int round = 0; round < kSlides; ++round) {
    response_.pass_on(impulses_.data());
    response_.part(change_.data());
    double most = 0;
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      if (contacts_[k].b != kWall) continue;
      const double before = std::abs(start_[k] - start_[size + k]) / 2;
      double now = std::min(before, slip(k));
      if (round > 0) now = std::min(now, given[k]);
      // What stops sliding would sink in by as much: in the end it is given nothing.
      if (round + 1 == kSlides && given[k] - now > opens) now = 0;
      const double more = now - given[k];
      most = std::max(most, std::abs(more));
      given[k] = now;
      parting_[k] += more;
      parting_[size + k] += more;
    }
    if (!(most > opens)) return;
    solve(goal, true);
  }
}

std::vector<double> ConeIsland::resolve(Bodies& motion, double rate, double goal, double opens) {
  const std::size_t size = response_.size();
  std::vector<ConeResponse::Total>& totals = response_.totals();
  for (std::size_t k = 0; k < motion.size(); ++k) {
    totals[k] = {motion[k].velocity.x, motion[k].velocity.y, motion[k].turning};
  }
  totals.back() = {};
  response_.part(start_.data());
  parting_ = start_;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const ConeContact& c = contacts_[k];
    const double room = c.parting > 0 ? -c.parting : std::max(c.gap * rate, 0.0);
    for (std::size_t at = k; at < response_.edges(); at += size)
      parting_[at] += response_.scale(k) * room;
  }
  std::fill(impulses_.begin(), impulses_.end(), 0);
  solve(goal, false);
  if (opens > 0 && response_.has_friction()) close_slides(goal, opens);
  response_.pass_on(impulses_.data());
  for (std::size_t k = 0; k < motion.size(); ++k) {
    motion[k].velocity = motion[k].velocity + Vec<double>{totals[k].x, totals[k].y};
    motion[k].turning += totals[k].turning;
  }
  std::vector<double> loads;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    double load = impulses_[k];
    if (response_.has_friction()) load += impulses_[size + k];
    loads.push_back(response_.scale(k) * load);
  }
  return loads;
}

}  // namespace carom::event
