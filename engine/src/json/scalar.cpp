#include "json/scalar.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cstdlib>
#include <utility>

namespace carom::json {

namespace {

void append_utf8(std::string& text, unsigned code) {
  const auto byte = [&text](unsigned value) { text += static_cast<char>(value); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0U | code >> 6);
    byte(0x80U | (code & 0x3FU));
  } else if (code < 0x10000) {
    byte(0xE0U | code >> 12);
    byte(0x80U | (code >> 6 & 0x3FU));
    byte(0x80U | (code & 0x3FU));
  } else {
    byte(0xF0U | code >> 18);
    byte(0x80U | (code >> 12 & 0x3FU));
    byte(0x80U | (code >> 6 & 0x3FU));
    byte(0x80U | (code & 0x3FU));
  }
}

}  // namespace

void malformed(std::size_t offset, std::string message) {
  throw Malformed{offset, "", "is not JSON: " + std::move(message)};
}

// from_chars alone would take "01", "1." and "inf".
Number scan_number(std::string_view text, std::size_t& at) {
  const char* const begin = text.data() + at;
  const char* const end = text.data() + text.size();
  const char* p = begin;
  Number number;
  number.is_negative = *p == '-';
  if (number.is_negative) ++p;
  const auto digits = [&](const char* after) {
    if (p != end && is_digit(*p)) {
      while (p != end && is_digit(*p)) ++p;
      return;
    }
    malformed(static_cast<std::size_t>(p - text.data()),
              fmt::format("expected a digit after {}", after));
  };
  if (p != end && *p == '0') {
    ++p;
  } else {
    digits("'-'");
  }
  number.is_whole = true;
  if (p != end && *p == '.') {
    number.is_whole = false;
    ++p;
    digits("'.'");
  }
  if (p != end && (*p == 'e' || *p == 'E')) {
    number.is_whole = false;
    ++p;
    if (p != end && (*p == '+' || *p == '-')) ++p;
    digits("the 'e' of an exponent");
  }
  at += static_cast<std::size_t>(p - begin);
  if (number.is_whole) {
    const char* const first = begin + (number.is_negative ? 1 : 0);
    number.is_whole = std::from_chars(first, p, number.magnitude).ec == std::errc() &&
                      (!number.is_negative || number.magnitude <= std::uint64_t{1} << 63);
  }
  if (number.is_whole) {
    number.value = static_cast<double>(number.magnitude);
    if (number.magnitude == 0) number.is_negative = false;  // a whole -0 is 0
    if (number.is_negative) number.value = -number.value;
    return number;
  }
  if (std::from_chars(begin, p, number.value).ec == std::errc()) return number;
  // Out of range: from_chars does not say on which side.
  number.value = std::strtod(std::string(begin, p).c_str(), nullptr);
  return number;
}

std::string unescaped(std::string_view written, std::size_t offset) {
  std::string text;
  std::size_t i = 0;
  const auto unit = [&] {
    unsigned code = 0;
    for (int k = 0; k < 4; ++k, ++i) {
      const char c = i < written.size() ? written[i] : '\0';
      if (std::isxdigit(static_cast<unsigned char>(c)) == 0) {
        malformed(offset + i, "expected four hexadecimal digits after \\u");
      }
      const char lower = static_cast<char>(c | 0x20);
      code = code * 16 + static_cast<unsigned>(is_digit(c) ? c - '0' : lower - 'a' + 10);
    }
    return code;
  };
  while (i < written.size()) {
    if (written[i] != '\\') {
      text += written[i++];
      continue;
    }
    const std::size_t begin = i++;
    constexpr std::string_view kEscapes = "\"\\/bfnrt";
    constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
    const std::size_t which = kEscapes.find(written[i]);
    if (which != std::string_view::npos) {
      text += kMeanings[which];
      ++i;
      continue;
    }
    if (written[i] != 'u') malformed(offset + i, "expected one of \" \\ / b f n r t u after \\");
    ++i;
    unsigned code = unit();
    if (code >= 0xD800 && code < 0xE000) {
      const bool pair = code < 0xDC00 && written.substr(i).starts_with("\\u");
      i += pair ? 2 : 0;
      const unsigned low = pair ? unit() : 0;
      if (low < 0xDC00 || low >= 0xE000) {
        malformed(offset + begin, "half of a surrogate pair stands alone");
      }
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    }
    append_utf8(text, code);
  }
  return text;
}

}  // namespace carom::json
