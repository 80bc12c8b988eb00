#include "numbers/wide_number.hpp"

#include <memory>

namespace carom {

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
