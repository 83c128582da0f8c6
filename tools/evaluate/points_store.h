#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "evaluate/table.h"

namespace tagmint::evaluate {

/// The points of a run on disk, so that a run that was ended in the middle goes on. A file of JSON
/// lines: what the run is, then a line for each point that was finished, which is on the disk when
/// put() returns. Half a line at the end, of a run that was killed, is not counted.
class PointsStore {
 public:
  /// Opens the file of an earlier run, or begins a new one.
  ///   run       what the points depend on
  ///   restart   an earlier file is replaced, whatever it holds
  /// Throws codec::InputError where the file belongs to another run or is none, and
  /// codec::OutputError where it cannot be written.
  PointsStore(std::filesystem::path path, const nlohmann::json& run, bool restart);
  ~PointsStore();
  PointsStore(const PointsStore&) = delete;
  PointsStore& operator=(const PointsStore&) = delete;

  /// Points of earlier runs by name.
  const std::map<std::string, Rows>& known() const { return known_; }
  void put(const std::string& point, const Rows& rows);
  /// Removes the file: the run is complete.
  void remove();

 private:
  void load(const std::string& text, const nlohmann::json& run);
  void append(const std::string& line);

  std::filesystem::path path_;
  std::map<std::string, Rows> known_;
  std::size_t good_bytes_ = 0;
  int descriptor_ = -1;
};

}  // namespace tagmint::evaluate
