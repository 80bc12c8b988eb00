#include "numbers/wide_number.hpp"

#include <memory>

namespace carom {

WideNumber::WideNumber() {
  start(MPFR_ZERO_KIND);
}

WideNumber::WideNumber(double value) : WideNumber() {
  mpfr_set_d(it(), value, MPFR_RNDN);
}

WideNumber::WideNumber(Integer whole) : WideNumber() {
  mpfr_set_si(it(), whole.value, MPFR_RNDN);
}

WideNumber::WideNumber(const std::string& text) : WideNumber() {
  mpfr_set_str(it(), text.c_str(), 10, MPFR_RNDN);
}

WideNumber::WideNumber(const WideNumber& other) : limbs_(other.limbs_) {
  take(other);
}

WideNumber& WideNumber::operator=(const WideNumber& other) {
  limbs_ = other.limbs_;
  take(other);
  return *this;
}

void WideNumber::start(int kind) {
  mpfr_custom_init_set(it(), kind, 0, bits_, limbs_.data());
}

void WideNumber::take(const WideNumber& other) {
  value_ = other.value_;
  mpfr_custom_move(it(), limbs_.data());
}

WideNumber WideNumber::infinity() {
  WideNumber result;
  result.start(MPFR_INF_KIND);
  return result;
}

WideNumber::operator double() const {
  return mpfr_get_d(it(), MPFR_RNDN);
}

WideNumber::operator std::int64_t() const {
  return mpfr_get_si(it(), MPFR_RNDZ);
}

template <class Function>
WideNumber WideNumber::of(const Function& function, const WideNumber& a) {
  WideNumber result;
  function(result.it(), a.it(), MPFR_RNDN);
  return result;
}

template <class Function>
WideNumber WideNumber::of(const Function& function, const WideNumber& a, const WideNumber& b) {
  WideNumber result;
  function(result.it(), a.it(), b.it(), MPFR_RNDN);
  return result;
}

WideNumber operator-(const WideNumber& a) {
  return WideNumber::of(mpfr_neg, a);
}

WideNumber operator+(const WideNumber& a, const WideNumber& b) {
  return WideNumber::of(mpfr_add, a, b);
}

WideNumber operator-(const WideNumber& a, const WideNumber& b) {
  return WideNumber::of(mpfr_sub, a, b);
}

WideNumber operator*(const WideNumber& a, const WideNumber& b) {
  return WideNumber::of(mpfr_mul, a, b);
}

WideNumber operator/(const WideNumber& a, const WideNumber& b) {
  return WideNumber::of(mpfr_div, a, b);
}

WideNumber sqrt(const WideNumber& a) {
  return WideNumber::of(mpfr_sqrt, a);
}

WideNumber exp(const WideNumber& a) {
  return WideNumber::of(mpfr_exp, a);
}

WideNumber log1p(const WideNumber& a) {
  return WideNumber::of(mpfr_log1p, a);
}

WideNumber abs(const WideNumber& a) {
  return WideNumber::of(mpfr_abs, a);
}

WideNumber floor(const WideNumber& a) {
  return WideNumber::of(mpfr_rint_floor, a);
}

WideNumber rint(const WideNumber& a) {
  return WideNumber::of(mpfr_rint, a);
}

WideNumber ldexp(const WideNumber& a, int exponent) {
  WideNumber result;
  mpfr_mul_2si(result.it(), a.it(), exponent, MPFR_RNDN);
  return result;
}

bool operator==(const WideNumber& a, const WideNumber& b) {
  return mpfr_equal_p(a.it(), b.it()) != 0;
}

bool operator<(const WideNumber& a, const WideNumber& b) {
  return mpfr_less_p(a.it(), b.it()) != 0;
}

bool operator<=(const WideNumber& a, const WideNumber& b) {
  return mpfr_lessequal_p(a.it(), b.it()) != 0;
}

int ilogb(const WideNumber& a) {
  return static_cast<int>(mpfr_get_exp(a.it())) - 1;
}

std::string WideNumber::text() const {
  const auto precision = static_cast<double>(mpfr_get_prec(it()));
  const int digits = static_cast<int>(std::ceil(precision * 0.30103)) + 2;
  char* text = nullptr;
  if (mpfr_asprintf(&text, "%.*Re", digits, it()) < 0) throw std::bad_alloc();
  const std::unique_ptr<char, void (*)(char*)> owner(text, mpfr_free_str);
  return text;
}

void WidePrecision::free_caches_with_thread() {
  struct Caches {
    ~Caches() { mpfr_free_cache(); }
  };
  thread_local const Caches kCaches;
}

}  // namespace carom
