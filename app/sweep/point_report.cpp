#include "sweep/point_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "text/csv_cell.hpp"

namespace carom::sweeps {
namespace {

using Json = nlohmann::ordered_json;
using Value = std::optional<double>;

/// The means of some columns of a table, over the lines that have a value there.
std::map<std::string, Value> means(const std::string& table,
                                   const std::vector<std::string>& wanted) {
  std::istringstream lines(table);
  const auto cells = [](const std::string& line) {
    std::vector<std::string> result;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) result.push_back(cell);
    return result;
  };
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = cells(line);
  std::map<std::string, std::pair<double, std::uint64_t>> sums;
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = cells(line);
    for (std::size_t k = 0; k < row.size() && k < names.size(); ++k) {
      if (row[k].empty()) continue;
      auto& [sum, count] = sums[names[k]];
      sum += std::strtod(row[k].c_str(), nullptr);
      ++count;
    }
  }
  std::map<std::string, Value> result;
  for (const std::string& name : wanted) {
    const auto found = sums.find(name);
    result[name] = found == sums.end()
                       ? Value{}
                       : found->second.first / static_cast<double>(found->second.second);
  }
  return result;
}

Value number_at(const Json& report, const char* pointer) {
  const Json::json_pointer place(pointer);
  if (!report.contains(place) || !report.at(place).is_number()) return {};
  return report.at(place).get<double>();
}

struct Quantity {
  const char* name;
  const char* pointer;
};
constexpr Quantity kQuantities[] = {{"time", "/time"},
                                    {"balls", "/balls"},
                                    {"ball_ball", "/events/ball_ball"},
                                    {"ball_wall", "/events/ball_wall"},
                                    {"collision_rate", "/collision_rate"},
                                    {"temperature", "/temperature"},
                                    {"pressure", "/pressure"},
                                    {"Z", "/Z"},
                                    {"energy_initial", "/energy/initial"},
                                    {"energy_final", "/energy/final"},
                                    {"dissipated", "/energy/dissipated"},
                                    {"energy_error", "/energy/relative_error"},
                                    {"max_overlap", "/max_overlap"}};

std::string text(const Value& value) {
  return value ? fmt::format("{}", *value) : "";
}

/// Sums of Neumaier: rounded once, more or less.
class Sum {
 public:
  void add(double value) {
    const double sum = sum_ + value;
    rest_ += std::abs(sum_) >= std::abs(value) ? (sum_ - sum) + value : (value - sum) + sum_;
    sum_ = sum;
  }
  [[nodiscard]] double value() const { return sum_ + rest_; }

 private:
  double sum_ = 0;
  double rest_ = 0;
};

/// The mean and its standard error, the latter of two values at the least.
std::pair<Value, Value> statistics(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto n = static_cast<double>(values.size());
  Sum sum;
  for (const double value : values) sum.add(value);
  const double mean = sum.value() / n;
  if (values.size() < 2) return {mean, {}};
  Sum squares;
  for (const double value : values) squares.add((value - mean) * (value - mean));
  return {mean, std::sqrt(squares.value() / (n - 1) / n)};
}

}  // namespace

std::string point_report(const std::string& report, const std::string& series,
                         const std::vector<Axis>& axes, const std::vector<std::string>& values) {
  try {
    Json json = Json::parse(report);
    // What is not the same every time.
    for (const char* name : {"wall_seconds", "cpu_seconds", "phases", "effects", "computing",
                             "waiting", "workers", "islands_again", "state"}) {
      json.erase(name);
    }
    Json point = Json::object();
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const Json value = Json::parse(values[k], nullptr, false);
      point[axes[k].pointer] = value.is_discarded() ? Json(values[k]) : value;
    }
    const double ball_time = json.at("balls").get<double>() * json.at("time").get<double>();
    json["collision_rate"] = nullptr;  // of a ball
    if (ball_time > 0) {
      json["collision_rate"] = 2 * json.at("events").at("ball_ball").get<double>() / ball_time;
    }
    for (const auto& [name, mean] : means(series, {"temperature", "pressure", "Z"})) {
      json[name] = mean ? Json(*mean) : Json(nullptr);
    }
    json["point"] = point;
    return json.dump(1) + '\n';
  } catch (const Json::exception& error) {
    throw std::runtime_error(fmt::format("its report cannot be read: {}", error.what()));
  }
}

std::string runs_csv(const std::vector<Axis>& axes, const std::vector<std::string>& reports) {
  std::string table = "run";
  for (const Axis& axis : axes) table += ',' + csv_cell(axis.pointer);
  for (const Quantity& quantity : kQuantities) table += fmt::format(",{}", quantity.name);
  table += ",state_hash\n";
  for (std::size_t point = 0; point < reports.size(); ++point) {
    if (reports[point].empty()) continue;
    const Json report = Json::parse(reports[point]);
    table += fmt::format("{:06}", point);
    for (const std::string& value : values_of(axes, point)) table += ',' + csv_cell(value);
    for (const Quantity& quantity : kQuantities) {
      table += ',' + text(number_at(report, quantity.pointer));
    }
    table += ',' + report.at("state_hash").get<std::string>() + '\n';
  }
  return table;
}

std::string summary_csv(const std::vector<Axis>& axes, const std::vector<std::string>& reports) {
  constexpr const char* kSeed = "/seed";
  std::string table;
  for (const Axis& axis : axes) {
    if (axis.pointer != kSeed) table += csv_cell(axis.pointer) + ',';
  }
  table += 'n';
  for (const Quantity& quantity : kQuantities) {
    table += fmt::format(",{0}_mean,{0}_stderr", quantity.name);
  }
  table += '\n';
  std::vector<std::string> groups;  // in the order of their first points
  std::map<std::string, std::vector<Json>> members;
  for (std::size_t point = 0; point < reports.size(); ++point) {
    const std::vector<std::string> values = values_of(axes, point);
    std::string group;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      if (axes[k].pointer != kSeed) group += csv_cell(values[k]) + ',';
    }
    const auto [at, is_new] = members.try_emplace(group);
    if (is_new) groups.push_back(group);
    if (!reports[point].empty()) at->second.push_back(Json::parse(reports[point]));
  }
  for (const std::string& group : groups) {
    const std::vector<Json>& runs = members[group];
    table += group + fmt::format("{}", runs.size());
    for (const Quantity& quantity : kQuantities) {
      std::vector<double> values;
      for (const Json& run : runs) {
        if (const Value value = number_at(run, quantity.pointer)) values.push_back(*value);
      }
      const auto [mean, error] = statistics(values);
      table += ',' + text(mean) + ',' + text(error);
    }
    table += '\n';
  }
  return table;
}

}  // namespace carom::sweeps
