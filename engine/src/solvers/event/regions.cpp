#include "solvers/event/regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace carom::event {
namespace {

// Columns times rows with the least length of borders.
std::array<std::size_t, 2> shape(const Domain& domain, std::size_t regions) {
  std::array<std::size_t, 2> best{regions, 1};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t columns = 1; columns <= regions; ++columns) {
    if (regions % columns != 0) continue;
    const std::array<std::size_t, 2> count{columns, regions / columns};
    double length = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const bool round = domain.period[axis] > 0 && count[axis] > 1;
      const auto borders = static_cast<double>(round ? count[axis] : count[axis] - 1);
      length += borders * (domain.upper[1 - axis] - domain.lower[1 - axis]);
    }
    if (length < least) {
      least = length;
      best = count;
    }
  }
  return best;
}

// Where all but the first of equal shares of the values begin.
std::vector<double> cuts(std::vector<double> values, std::size_t shares) {
  std::sort(values.begin(), values.end());
  std::vector<double> result;
  for (std::size_t k = 1; k < shares; ++k) {
    result.push_back(values.empty() ? 0 : values[values.size() * k / shares]);
  }
  return result;
}

std::size_t share_of(const std::vector<double>& begins, double x) {
  return static_cast<std::size_t>(std::upper_bound(begins.begin(), begins.end(), x) -
                                  begins.begin());
}

}  // namespace

Regions::Regions(const Domain& domain, std::size_t regions, const std::vector<Vec<double>>& places)
    : domain_(domain) {
  const auto [columns, rows] = shape(domain, regions);
  std::vector<double> xs;
  xs.reserve(places.size());
  for (const Vec<double>& at : places) xs.push_back(at.x);
  columns_ = cuts(std::move(xs), columns);
  std::vector<std::vector<double>> ys(columns);
  for (const Vec<double>& at : places) ys[share_of(columns_, at.x)].push_back(at.y);
  const auto between = [&](const std::vector<double>& begins, std::size_t k, std::size_t axis) {
    const double infinite = std::numeric_limits<double>::infinity();
    const bool round = domain.period[axis] > 0;
    const double first = round ? domain.lower[axis] : -infinite;
    const double last = round ? domain.upper[axis] : infinite;
    return std::pair(k == 0 ? first : begins[k - 1], k == begins.size() ? last : begins[k]);
  };
  for (std::size_t c = 0; c < columns; ++c) {
    rows_.push_back(cuts(std::move(ys[c]), rows));
    const auto [left, right] = between(columns_, c, 0);
    for (std::size_t r = 0; r < rows; ++r) {
      const auto [bottom, top] = between(rows_[c], r, 1);
      regions_.push_back({{left, bottom}, {right, top}});
    }
  }
}

std::size_t Regions::of(const Vec<double>& at) const {
  const std::size_t column = share_of(columns_, at.x);
  return column * (rows_[0].size() + 1) + share_of(rows_[column], at.y);
}

bool Regions::whole(const Region& region, std::size_t axis) const {
  return !(region.lower[axis] > domain_.lower[axis]) && !(region.upper[axis] < domain_.upper[axis]);
}

double Regions::outside(std::size_t region, const Vec<double>& at) const {
  const Region& r = regions_[region];
  double most = -std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (whole(r, axis)) continue;
    const double x = axis == 0 ? at.x : at.y;
    const double period = domain_.period[axis];
    if (period > 0) {
      const double centre = (r.lower[axis] + r.upper[axis]) / 2;
      const double off = nearest(x - centre, period, period / 2);
      most = std::max(most, std::abs(off) - (r.upper[axis] - r.lower[axis]) / 2);
    } else {
      most = std::max({most, r.lower[axis] - x, x - r.upper[axis]});
    }
  }
  return most;
}

Plot Regions::plot(std::size_t region, double rim) const {
  const Region& r = regions_[region];
  Plot plot(domain_);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (whole(r, axis)) continue;
    const double low = r.lower[axis] - rim;
    const double high = r.upper[axis] + rim;
    if (domain_.period[axis] > 0) {
      // Cut off only where the two ends are well apart.
      if (high - low > 0.75 * domain_.period[axis]) continue;
      plot.lower[axis] = low;
      plot.upper[axis] = high;
      plot.whole[axis] = false;
    } else {
      plot.lower[axis] = std::max(low, domain_.lower[axis]);
      plot.upper[axis] = std::min(high, domain_.upper[axis]);
    }
  }
  return plot;
}

double Regions::narrowest() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Region& r : regions_) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      least = std::min(least, std::min(r.upper[axis], domain_.upper[axis]) -
                                  std::max(r.lower[axis], domain_.lower[axis]));
    }
  }
  return least;
}

}  // namespace carom::event
