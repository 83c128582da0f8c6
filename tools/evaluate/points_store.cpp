#include "evaluate/points_store.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "tagmint/codec/errors.h"

namespace tagmint::evaluate {
namespace {

constexpr int kFormat = 1;

[[noreturn]] void throw_output_error(const std::filesystem::path& path) {
  throw codec::OutputError("cannot write: " + std::generic_category().message(errno), path.string(),
                           "choose a folder that may be written with -o");
}

nlohmann::json first_line(const nlohmann::json& run) {
  return {{"tagmint_points", kFormat}, {"run", run}};
}

}  // namespace

PointsStore::PointsStore(std::filesystem::path path, const nlohmann::json& run, bool restart)
    : path_(std::move(path)) {
  if (!restart) {
    std::ifstream file(path_, std::ios::binary);
    std::ostringstream text;
    if (file) text << file.rdbuf();
    load(text.str(), run);
  }
  descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw_output_error(path_);
  if (ftruncate(descriptor_, static_cast<off_t>(good_bytes_)) != 0 ||
      lseek(descriptor_, 0, SEEK_END) < 0) {
    throw_output_error(path_);
  }
  if (good_bytes_ == 0) append(first_line(run).dump());
}

PointsStore::~PointsStore() {
  if (descriptor_ >= 0) close(descriptor_);
}

void PointsStore::load(const std::string& text, const nlohmann::json& run) {
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    try {
      const nlohmann::json line = nlohmann::json::parse(text.substr(begin, end - begin));
      if (begin == 0) {
        if (line.at("tagmint_points") != kFormat || line.at("run") != run) {
          throw codec::InputError("the points in this file are those of a run with other settings",
                                  path_.string(),
                                  "begin anew with --restart, or take another folder with -o");
        }
      } else {
        known_[line.at("point").get<std::string>()] = rows_from_json(line.at("rows"));
      }
    } catch (const nlohmann::json::exception&) {
      if (begin > 0) return;  // what follows a damaged line is computed again
      throw codec::InputError("this is no file of points", path_.string(),
                              "begin anew with --restart, or take another folder with -o");
    }
    good_bytes_ = end + 1;
  }
}

void PointsStore::append(const std::string& line) {
  const std::string text = line + "\n";
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = write(descriptor_, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_output_error(path_);
    done += static_cast<std::size_t>(count);
  }
  if (fdatasync(descriptor_) != 0) throw_output_error(path_);
}

void PointsStore::put(const std::string& point, const Rows& rows) {
  append(nlohmann::json{{"point", point}, {"rows", rows_to_json(rows)}}.dump());
}

void PointsStore::remove() {
  std::error_code error;
  std::filesystem::remove(path_, error);
}

}  // namespace tagmint::evaluate
