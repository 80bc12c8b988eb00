#pragma once

#include <cstddef>
#include <vector>

namespace carom::event {

/// Of fewer and of more contacts than this the impulses are not guessed.
inline constexpr std::size_t kLeastGuessed = 3;
inline constexpr std::size_t kMostGuessed = 512;

/// What a contact may do, but for nothing, 0: push, or push and pull.
inline constexpr char kPushes = 1;
inline constexpr char kHolds = 2;

/// How fast each impulse parts each contact, in double: a full matrix, row by row.
class ResponseMatrix {
 public:
  explicit ResponseMatrix(std::size_t size) : size_(size), values_(size * size, 0.0) {}
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double& at(std::size_t row, std::size_t column) {
    return values_[row * size_ + column];
  }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return values_[row * size_ + column];
  }

 private:
  std::size_t size_;
  std::vector<double> values_;
};

/// Impulses that may be those by which no contact approaches: a quick solution in double, which
/// the order of the contacts shows in by its rounding.
///
/// Contacts give way to their impulses by the part `give` of what these do to them alone, so that
/// there is one solution, however many contacts hold a body; that is taken back `refinements` times
/// (proximal point method).  It is found by block pivoting and, where that goes round in circles,
/// by an interior point; what rounding leaves wrong then is changed one contact at a time.
/// Source: Judice, Pires, Comput. Oper. Res. 21 (1994) 587.
[[nodiscard]] std::vector<double> guess_impulses(const ResponseMatrix& response,
                                                 const std::vector<double>& parting,
                                                 const std::vector<char>& may, double give,
                                                 int refinements);

}  // namespace carom::event
