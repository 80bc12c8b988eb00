#include "solvers/event/groups/conflict_sets.hpp"

#include <utility>

namespace carom::event {
namespace {

bool before(const Encounter& one, const Encounter& other) {
  return one.first != other.first ? one.first < other.first : one.second < other.second;
}

}  // namespace

void ConflictSets::reset(const std::vector<char>& fixed) {
  fixed_ = &fixed;
  fixed_of_.assign(fixed.size(), {});
  lasting_.assign(fixed.size(), 0);
  closed_.assign(fixed.size(), 0);
}

void ConflictSets::begin_window() {
  sets_.reset(fixed_->size());
  clusters_.reset(fixed_->size());
  supports_.clear();
}

void ConflictSets::touch(std::span<const Encounter> pairs) {
  if (pairs.empty()) return;
  for (const Encounter& pair : pairs) {
    if ((*fixed_)[pair.second] != 0) {
      supports_.push_back(pair);
    } else {
      clusters_.merge(pair.first, pair.second);
    }
  }
  std::sort(supports_.begin(), supports_.end(), before);
}

void ConflictSets::meet(std::span<const Encounter> pairs) {
  for (const Encounter& pair : pairs) {
    met_.push_back(pair.first);
    if (pair.lasts) lasting_[pair.first] = 1;
    if ((*fixed_)[pair.second] != 0) {
      fixed_of_[sets_.find(pair.first)].push_back(pair.second);
    } else {
      join(pair.first, pair.second);
    }
  }
}

const std::vector<ConflictSets::Group>& ConflictSets::joined() {
  roots_.clear();
  for (const Index i : met_) {
    if (closed_[sets_.find(i)] != 0) continue;
    close(i);
    const Index root = sets_.find(i);
    if (std::exchange(closed_[root], 1) == 0) roots_.push_back(root);
  }
  joined_.clear();
  for (const Index root : roots_) {
    closed_[root] = 0;
    if (sets_.find(root) == root) add(root);  // else another group has taken it in since
  }
  std::sort(joined_.begin(), joined_.end(), [](const Group& a, const Group& b) {
    return a.size != b.size ? a.size > b.size : a.root < b.root;
  });
  return joined_;
}

void ConflictSets::add(Index root) {
  std::vector<Index>& fixed = fixed_of_[root];
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  Group group{root, 0, false};
  sets_.each(root, [&](Index k) {
    ++group.size;
    group.lasting = group.lasting || lasting_[k] != 0;
  });
  joined_.push_back(group);
}

void ConflictSets::forget(Index ball) {
  lasting_[ball] = 0;
  fixed_of_[ball].clear();
}

void ConflictSets::join(Index i, Index j) {
  const Index one = sets_.find(i);
  const Index other = sets_.find(j);
  if (!sets_.merge(one, other)) return;
  const Index root = sets_.find(one);
  std::vector<Index>& from = fixed_of_[root == one ? other : one];
  fixed_of_[root].insert(fixed_of_[root].end(), from.begin(), from.end());
  from.clear();
}

// All balls of the clusters that the group's members are of, and the fixed balls that these touch.
void ConflictSets::close(Index ball) {
  closing_.clear();
  const auto list = [this](Index i) { closing_.push_back(i); };
  sets_.each(ball, list);
  std::size_t next = 0;
  while (next < closing_.size()) {  // it grows on the way
    const Index i = closing_[next++];
    const auto first =
        std::lower_bound(supports_.begin(), supports_.end(), Encounter{i, 0}, before);
    for (auto at = first; at != supports_.end() && at->first == i; ++at) {
      fixed_of_[sets_.find(i)].push_back(at->second);
    }
    if (clusters_.alone(i)) continue;
    clusters_.each(i, [&](Index k) {
      if (sets_.find(k) == sets_.find(i)) return;
      sets_.each(k, list);
      join(i, k);
    });
  }
}

}  // namespace carom::event
