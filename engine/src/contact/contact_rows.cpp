#include "contact/contact_rows.hpp"

#include <algorithm>
#include <cmath>

namespace carom::contact {

template <int D>
void ContactProblem<D>::weigh() {
  for (Row<D>& row : rows) {
    row.w = 0;
    for (int c = 0; c < D; ++c) {
      const double square = row.j[c] * row.j[c];
      row.w += inverse_mass[static_cast<std::size_t>(row.a * D + c)] * square;
      if (row.b >= 0) row.w += inverse_mass[static_cast<std::size_t>(row.b * D + c)] * square;
    }
  }
}

// Of the rows of one contact, which follow each other, the impulses are added up before they are
// given to its bodies.
template <int D>
void ContactProblem<D>::spread(const std::vector<double>& impulses, std::vector<double>& motion,
                               bool by_mass) const {
  motion.assign(inverse_mass.size(), 0.0);
  double* const moved = motion.data();
  const double* next = impulses.data();
  const Row<D>* row = rows.data();
  for (const Row<D>* const end = row + rows.size(); row != end;) {
    const int first = row->a;
    const int second = row->b;
    double push[D]{};
    do {
      const double f = *next++;
      for (int c = 0; c < D; ++c) push[c] += f * row->j[c];
    } while (++row != end && row->a == first && row->b == second);
    double* a = moved + first * D;
    for (int c = 0; c < D; ++c) a[c] += c < 2 ? -push[c] : push[c];
    if (second < 0) continue;
    double* b = moved + second * D;
    for (int c = 0; c < D; ++c) b[c] += push[c];
  }
  if (!by_mass) return;
  for (std::size_t i = 0; i < motion.size(); ++i) moved[i] *= inverse_mass[i];
}

template <int D>
void ContactProblem<D>::gather(const std::vector<double>& motion,
                               std::vector<double>& opening) const {
  opening.resize(rows.size());
  const double* const moved = motion.data();
  double* next = opening.data();
  const Row<D>* row = rows.data();
  for (const Row<D>* const end = row + rows.size(); row != end;) {
    const int first = row->a;
    const int second = row->b;
    const double* a = moved + first * D;
    double apart[D];
    for (int c = 0; c < D; ++c) apart[c] = c < 2 ? -a[c] : a[c];
    if (second >= 0) {
      const double* b = moved + second * D;
      for (int c = 0; c < D; ++c) apart[c] += b[c];
    }
    do {
      double sum = 0;
      for (int c = 0; c < D; ++c) sum += row->j[c] * apart[c];
      *next++ = sum;
    } while (++row != end && row->a == first && row->b == second);
  }
}

template <int D>
double ContactProblem<D>::residual(const std::vector<double>& impulses) const {
  std::vector<double> motion;
  std::vector<double> opening;
  spread(impulses, motion, true);
  gather(motion, opening);
  double worst = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double speed = opening[k] + rows[k].q;
    worst = std::max(worst, impulses[k] > 0 ? std::abs(speed) : std::max(0.0, -speed));
  }
  return worst;
}

template struct ContactProblem<2>;
template struct ContactProblem<3>;

}  // namespace carom::contact
