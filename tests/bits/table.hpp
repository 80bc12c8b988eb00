#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "carom/scene.hpp"

namespace carom::bits {

/// A line of the table: a scene, a method, how long it runs and what it ends with.
struct Row {
  std::string scene;  ///< path from the top of the tree
  Method method = Method::event;
  double seconds = 0;
  std::string outcome;
};

/// The pinned table.  A line is "SCENE METHOD SECONDS OUTCOME"; lines that begin with # are
/// comments.
std::vector<Row> read_table(const std::filesystem::path& file);
void write_table(const std::filesystem::path& file, const std::vector<Row>& rows);

/// Every scene of the tree with each method, in order; those that `known` does not have run for at
/// most `seconds` and have no outcome yet.
std::vector<Row> all_rows(const std::filesystem::path& top, const std::vector<Row>& known,
                          double seconds);

std::string to_line(const Row& row);

}  // namespace carom::bits
