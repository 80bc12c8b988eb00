#pragma once

#include <vector>

#include "contact/block_cholesky.hpp"
#include "contact/contact_rows.hpp"

namespace carom::contact {

/// Solves a contact problem from a guess which rows carry an impulse: those are made to open
/// neither way, rows that then pull are left out, rows that then close are added, until none does.
///
/// A good guess takes one to a few factorisations, where an interior point takes a dozen or two; a
/// bad one is given up soon.  Impulses that are not determined (more rows than the bodies have
/// velocities) are spread evenly, by a small compliance that is refined away.
///
/// Source: Judice, Pires, Comput. Oper. Res. 21 (1994) 587 (block pivoting); Hestenes, J. Optim.
/// Theory Appl. 4 (1969) 303 (multipliers).
template <int D>
class ActiveSet {
 public:
  struct Outcome {
    bool solved = false;
    int factorisations = 0;
  };

  /// Holds: where it is not solved `impulses` are unchanged.
  /// REQUIRES: matrix.analyse(problem) has been called.
  Outcome solve(const ContactProblem<D>& problem, BlockCholesky<D>& matrix, double goal,
                std::vector<char> carries, std::vector<double>& impulses);

 private:
  using Column = std::vector<double>;

  [[nodiscard]] bool hold(const ContactProblem<D>& problem, BlockCholesky<D>& matrix,
                          const std::vector<char>& carries, double goal);

  Column f_, weight_, scratch_, opening_, motion_, change_;
};

}  // namespace carom::contact
