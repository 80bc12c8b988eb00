#include <algorithm>
#include <charconv>

#include "json/pointer.hpp"
#include "json/reader.hpp"
#include "scene/read_scene.hpp"

namespace carom::scene {

namespace {

/// A pointer that leads to the present value or into it.
struct Sought {
  std::size_t number = 0;  // among those that were asked for
  std::string_view rest;   // of the pointer, from here on
};

/// Cuts the first step off.
std::string_view take_step(Sought& sought) {
  sought.rest.remove_prefix(1);
  const std::size_t end = std::min(sought.rest.find('/'), sought.rest.size());
  const std::string_view step = sought.rest.substr(0, end);
  sought.rest.remove_prefix(end);
  return step;
}

/// All pointers in one pass over the text.
class Locator {
 public:
  Locator(std::string_view text, std::size_t count) : reader_(text), offsets_(count, 0) {}

  void locate(std::vector<Sought> sought) {
    for (const Sought& each : sought) offsets_[each.number] = reader_.offset();
    std::erase_if(sought, [](const Sought& each) { return each.rest.empty(); });
    const json::Kind kind = reader_.peek();
    if (!sought.empty() && kind == json::Kind::object) {
      locate_in_object(sought);
    } else if (!sought.empty() && kind == json::Kind::list) {
      locate_in_list(sought);
    } else {
      reader_.skip();
    }
  }

  std::vector<std::size_t> take() { return std::move(offsets_); }

 private:
  void locate_in_object(const std::vector<Sought>& sought) {
    reader_.begin_object();
    while (reader_.next_member()) {
      const std::string step = json::pointer_step(reader_.key());
      std::vector<Sought> inside;
      for (Sought each : sought) {
        if (take_step(each) == step) inside.push_back(each);
      }
      if (inside.empty()) {
        reader_.skip();
      } else {
        locate(std::move(inside));
      }
    }
  }

  void locate_in_list(const std::vector<Sought>& sought) {
    std::vector<std::pair<std::size_t, Sought>> items;
    for (Sought each : sought) {
      const std::string_view step = take_step(each);
      std::size_t index = 0;
      const auto [stop, error] = std::from_chars(step.data(), step.data() + step.size(), index);
      if (error == std::errc() && stop == step.data() + step.size())
        items.emplace_back(index, each);
    }
    std::stable_sort(items.begin(), items.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    auto next = items.begin();
    reader_.begin_list();
    for (std::size_t index = 0; reader_.next_item(); ++index) {
      std::vector<Sought> inside;
      for (; next != items.end() && next->first == index; ++next) inside.push_back(next->second);
      if (inside.empty()) {
        reader_.skip();
      } else {
        locate(std::move(inside));
      }
    }
  }

  json::Reader reader_;
  std::vector<std::size_t> offsets_;
};

}  // namespace

std::vector<std::size_t> offsets_of(std::string_view text,
                                    const std::vector<std::string_view>& pointers) {
  Locator locator(text, pointers.size());
  std::vector<Sought> sought;
  for (std::size_t i = 0; i < pointers.size(); ++i) sought.push_back({i, pointers[i]});
  locator.locate(std::move(sought));
  return locator.take();
}

}  // namespace carom::scene
