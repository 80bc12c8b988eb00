#include "solvers/event/part.hpp"

#pragma once

#include <algorithm>
#include <limits>

namespace carom::event {
// Balls are looked for near the border among those that were so many halos inside it.
inline constexpr double kDeep = 3;

template <class P>
Part<P>::Part(const Rules& rules, std::size_t number, std::size_t parts)
    : number_(static_cast<std::uint32_t>(number)), tile_(rules), offers_(parts) {}

template <class P>
void Part<P>::reset(const Regions& regions, double halo, const std::vector<Disk>& flights,
                    const std::vector<Vec<double>>& places, Ticks now) {
  slot_of_.assign(flights.size(), kNobody);
  ball_.clear();
  owner_.clear();
  copies_.clear();
  free_.clear();
  corrections_.clear();
  double square = 0;
  std::vector<Disk> disks;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    if (regions.outside(number_, places[i]) > halo) continue;
    const std::size_t owner = regions.of(places[i]);
    const auto slot = static_cast<Index>(disks.size());
    slot_of_[i] = slot;
    ball_.push_back(static_cast<Index>(i));
    owner_.push_back(static_cast<std::uint32_t>(owner));
    disks.push_back(flights[i]);
    if (owner == number_) {
      const Vec<double> v = tile_.motion().velocity(flights[i], now);
      square = std::max(square, v.x * v.x + v.y * v.y);
    } else {
      copies_.push_back(slot);
    }
  }
  plot_ = regions.plot(number_, halo);
  start(disks, 0, now);
  journal_.set_fastest_square(square);
}

template <class P>
void Part<P>::start(const std::vector<Disk>& disks, std::size_t more, Ticks now) {
  plot_.slots = disks.size() + disks.size() / 8 + more + 64;
  tile_.keep(nullptr);
  tile_.reset(disks, now, plot_);
  journal_.reset(plot_.slots);
  tile_.keep(&journal_);
  turn_ = 0;
  stamp_.assign(disks.size(), 0);
  cursor_.assign(disks.size(), 0);
  rim_.assign(disks.size(), 0);
  owned_.clear();
  rims_.clear();
  for (const std::uint32_t owner : owner_) owned_.push_back(owner == number_ ? 1 : 0);
  for (Index slot = 0; slot < disks.size(); ++slot) {
    journal_.set_role(slot, owned_[slot] != 0 ? Journal<P>::kShared : Journal<P>::kCopy);
    if (owned_[slot] != 0) own(slot);
  }
  depth_ = -std::numeric_limits<double>::infinity();  // unknown
}

template <class P>
void Part<P>::own(Index slot) {
  if (rim_[slot] != 0) return;
  rim_[slot] = 1;
  rims_.push_back(slot);
}

template <class P>
void Part<P>::offer(const Regions& regions, double halo, double travelled, Ticks now) {
  for (auto& offers : offers_) offers.clear();
  journal_.clear();
  const Motion<P>& motion = tile_.motion();
  depth_ -= travelled;
  const bool all = !(depth_ > halo);
  if (all) {
    depth_ = kDeep * halo;
    rims_.clear();
    double square = 0;
    for (Index slot = 0; slot < ball_.size(); ++slot) {
      rim_[slot] = 0;
      if (owned_[slot] == 0) continue;
      journal_.set_role(slot, Journal<P>::kOwned);
      const Disk& disk = tile_.disks()[slot];
      const Vec<double> v = motion.velocity(disk, now);
      square = std::max(square, v.x * v.x + v.y * v.y);
      if (regions.outside(number_, motion.place(disk, now)) > -depth_) own(slot);
    }
    journal_.set_fastest_square(square);
  }
  std::size_t kept = 0;
  for (const Index slot : rims_) {
    rim_[slot] = owned_[slot];
    if (owned_[slot] == 0) continue;
    rims_[kept++] = slot;
    const Disk& disk = tile_.disks()[slot];
    const Vec<double> at = motion.wrapped(motion.place(disk, now));
    journal_.set_role(slot, Journal<P>::kOwned);
    if (regions.outside(number_, at) <= -halo) continue;
    const auto owner = static_cast<std::uint32_t>(regions.of(at));
    for (std::size_t part = 0; part < offers_.size(); ++part) {
      if (part == number_ && owner == number_) continue;
      if (part != owner && regions.outside(part, at) > halo) continue;
      journal_.set_role(slot, Journal<P>::kShared);
      offers_[part].push_back({disk, ball_[slot], owner});
    }
  }
  rims_.resize(kept);
}

template <class P>
Index Part<P>::slot_for(Index ball) {
  Index slot = kNobody;
  if (!free_.empty()) {
    slot = free_.back();
    free_.pop_back();
    ball_[slot] = ball;
  } else {
    slot = static_cast<Index>(ball_.size());
    ball_.push_back(ball);
    owner_.push_back(0);
    owned_.push_back(0);
    rim_.push_back(0);
    stamp_.push_back(0);
    cursor_.push_back(0);
  }
  slot_of_[ball] = slot;
  return slot;
}

// Puts the balls into new slots, without gaps, and keeps room for others.
template <class P>
void Part<P>::make_room(std::size_t more, Ticks now) {
  if (ball_.size() - free_.size() + more <= plot_.slots) return;
  std::vector<Disk> disks;
  for (Index slot = 0; slot < ball_.size(); ++slot) {
    if (ball_[slot] == kNobody) continue;
    const auto to = static_cast<Index>(disks.size());
    disks.push_back(tile_.disks()[slot]);
    slot_of_[ball_[slot]] = to;
    ball_[to] = ball_[slot];
    owner_[to] = owner_[slot];
  }
  ball_.resize(disks.size());
  owner_.resize(disks.size());
  free_.clear();
  start(disks, more, now);
}

template <class P>
void Part<P>::admit(const std::vector<const Part*>& parts, Ticks now) {
  journal_.clear();
  corrections_.clear();
  tile_.commit(now);
  ++turn_;
  std::size_t more = 0;
  for (const Part* part : parts) {
    for (const Offer& offer : part->offers_[number_]) {
      const Index slot = slot_of_[offer.ball];
      if (slot == kNobody) {
        ++more;
      } else {
        stamp_[slot] = turn_;
      }
    }
  }
  for (const Index slot : copies_) {
    if (stamp_[slot] == turn_ || owned_[slot] != 0) continue;
    tile_.take_out(slot);
    slot_of_[ball_[slot]] = kNobody;
    ball_[slot] = kNobody;
    free_.push_back(slot);
  }
  copies_.clear();
  make_room(more, now);
  std::vector<Index> fresh;
  std::vector<Index> lifted;
  for (const Part* part : parts) {
    for (const Offer& offer : part->offers_[number_]) {
      Index slot = slot_of_[offer.ball];
      if (slot == kNobody) {
        slot = slot_for(offer.ball);
        tile_.put(slot, offer.flight);
        fresh.push_back(slot);
      } else if (!(typename Journal<P>::Flight(tile_.disks()[slot]) ==
                   typename Journal<P>::Flight(offer.flight))) {
        tile_.lift(slot);
        tile_.put(slot, offer.flight);
        lifted.push_back(slot);
      }
      owner_[slot] = offer.owner;
      owned_[slot] = offer.owner == number_ ? 1 : 0;
      journal_.set_role(slot, owned_[slot] != 0 ? Journal<P>::kShared : Journal<P>::kCopy);
      if (owned_[slot] != 0) {
        own(slot);
      } else {
        copies_.push_back(slot);
      }
    }
  }
  tile_.resume(lifted, fresh, now);
}

template <class P>
void Part<P>::advance(Ticks from, Ticks until) {
  journal_.clear();
  tile_.commit(from);
  std::vector<Index> lifted;
  for (const Correction& correction : corrections_) {
    tile_.lift(correction.slot);
    tile_.put(correction.slot, correction.flight);
    lifted.push_back(correction.slot);
  }
  if (!lifted.empty()) tile_.resume(lifted, {}, from);
  corrections_.clear();
  tile_.advance_to(until);
  until_ = until;
  publish();
}

template <class P>
void Part<P>::publish() {
  news_.clear();
  copies_entries_.clear();
  const auto& entries = journal_.entries();
  for (const Index k : journal_.border()) {
    const auto& entry = entries[k];
    if (journal_.role(entry.ball) == Journal<P>::kCopy) {
      copies_entries_.push_back(k);
      continue;
    }
    news_.push_back({entry.next == Journal<P>::kNone
                         ? typename Journal<P>::Flight(tile_.disks()[entry.ball])
                         : entries[entry.next].before,
                     entry.time, journal_.group(k), ball_[entry.ball]});
  }
}

// Whether the copy has done the same next.
template <class P>
bool Part<P>::agrees(const News& news, Index slot) const {
  if (cursor_[slot] == Journal<P>::kNone) return false;
  const auto& entry = journal_.entries()[cursor_[slot]];
  if (entry.time != news.time || journal_.group(cursor_[slot]) != news.group) return false;
  return news.after == (entry.next == Journal<P>::kNone
                            ? typename Journal<P>::Flight(tile_.disks()[slot])
                            : journal_.entries()[entry.next].before);
}

template <class P>
void Part<P>::correct(Index slot, Ticks differs, const Part& owner, double speed) {
  owner_[slot] |= kCorrected;
  corrections_.push_back({slot, owner.flight(ball_[slot])});
  // Both versions were here when they parted.
  Disk disk = tile_.disks()[slot];
  if (cursor_[slot] != Journal<P>::kNone) journal_.entries()[cursor_[slot]].before.restore(disk);
  const Motion<P>& motion = tile_.motion();
  const Vec<double> at = motion.wrapped(motion.place(disk, differs));
  const double travel = speed * motion.rules().scale.seconds(until_ - differs);
  if (tile_.is_near(slot, at, travel, owned_)) differs_ = std::min(differs_, differs);
}

template <class P>
void Part<P>::check(const std::vector<const Part*>& parts, double speed) {
  differs_ = kNever;
  corrections_.clear();
  ++turn_;
  const auto begin = [this](Index slot) {
    if (stamp_[slot] == turn_) return;
    stamp_[slot] = turn_;
    cursor_[slot] = journal_.first(slot);
  };
  for (const Part* part : parts) {
    if (part == this) continue;
    for (const News& news : part->news_) {
      const Index slot = slot_of_[news.ball];
      if (slot == kNobody || (owner_[slot] & kCorrected) != 0) continue;
      begin(slot);
      if (agrees(news, slot)) {
        cursor_[slot] = journal_.entries()[cursor_[slot]].next;
        continue;
      }
      Ticks differs = news.time;
      if (cursor_[slot] != Journal<P>::kNone) {
        differs = std::min(differs, journal_.entries()[cursor_[slot]].time);
      }
      correct(slot, differs, *part, speed);
    }
  }
  for (const Index k : copies_entries_) {
    const auto& entry = journal_.entries()[k];
    const Index slot = entry.ball;
    if ((owner_[slot] & kCorrected) != 0) continue;
    begin(slot);
    if (cursor_[slot] == Journal<P>::kNone || cursor_[slot] > k) continue;
    correct(slot, entry.time, *parts[owner_[slot]], speed);
  }
  for (const Correction& correction : corrections_) owner_[correction.slot] &= ~kCorrected;
}

template <class P>
void Part<P>::undo(Ticks moment) {
  tile_.undo(moment);
  until_ = moment;
  publish();
}

template <class P>
void Part<P>::rebase(Ticks by) {
  journal_.clear();
  tile_.rebase(by);
  for (Correction& correction : corrections_) {
    if (correction.flight.start != kEver) correction.flight.start -= by;
  }
}

template <class P>
std::size_t Part<P>::bytes() const {
  std::size_t offers = 0;
  for (const auto& list : offers_) offers += list.capacity() * sizeof(Offer);
  return tile_.bytes() + journal_.bytes() + offers + slot_of_.capacity() * sizeof(Index) +
         ball_.capacity() * (3 * sizeof(Index) + sizeof(std::uint32_t) + 3) +
         news_.capacity() * sizeof(News);
}

}  // namespace carom::event
