#include "export/events.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>

namespace carom {
namespace {

constexpr std::array<std::string_view, 8> kKinds{"ball", "wall", "joint",  "rest",
                                                 "wake", "add",  "remove", "set"};
constexpr std::array<std::string_view, 5> kSides{"", "left", "right", "bottom", "top"};

std::string number(std::size_t ball) {
  return ball == Impact::kNoBall ? "" : fmt::format("{}", ball);
}

}  // namespace

std::string events_header() {
  return "event,time,kind,a,b,wall,x,y,nx,ny,impulse,tangential,energy_lost\n";
}

std::string events_lines(const std::vector<Impact>& impacts) {
  std::string text;
  for (const Impact& impact : impacts) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                   impact.event, impact.time, kKinds[static_cast<std::size_t>(impact.kind)],
                   number(impact.a), number(impact.b),
                   kSides[static_cast<std::size_t>(impact.wall)], impact.position.x(),
                   impact.position.y(), impact.normal.x(), impact.normal.y(), impact.impulse,
                   impact.tangential, impact.energy_lost);
  }
  return text;
}

}  // namespace carom
