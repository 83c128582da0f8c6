#include "false_accepts/photograph_quads.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <regex>
#include <set>
#include <thread>

#include "io/images.h"
#include "pipeline/s7_decode.h"
#include "tagmint/detect/detector.h"

namespace tagmint::bench {
namespace {

namespace fs = std::filesystem;

/// Pictures are halved as long as their shorter side stays at this.
constexpr int kLeastSide_px = 500;

/// Keeps the candidates that the detector would decode.
class QuadCollector : public detect::DebugSink {
 public:
  void refined_quads(std::span<const detect::Corners> corners) override {
    quads.assign(corners.begin(), corners.end());
  }
  std::vector<detect::Corners> quads;
};

/// The mean of each 2 x 2 pixels; a last odd row or column is left out.
detect::Image halved(const detect::Image& image) {
  detect::Image half(image.width() / 2, image.height() / 2);
  for (int y = 0; y < half.height(); ++y) {
    for (int x = 0; x < half.width(); ++x) {
      const int sum = image.at(2 * x, 2 * y) + image.at(2 * x + 1, 2 * y) +
                      image.at(2 * x, 2 * y + 1) + image.at(2 * x + 1, 2 * y + 1);
      half.at(x, y) = static_cast<std::uint8_t>((sum + 2) / 4);
    }
  }
  return half;
}

/// One thread's detector for each kind of border, and its counts.
class Worker {
 public:
  explicit Worker(std::span<const MeasuredCode> codes) : codes_(codes) {
    counts.by_code.resize(codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
      counts.by_code[i].accepted.resize(static_cast<std::size_t>(codes[i].safe_errors) + 1);
    }
    for (const bool reversed : {false, true}) {
      std::vector<std::shared_ptr<const codec::Decoder>> decoders;
      for (const MeasuredCode& code : codes) {
        if (reversed == code.family->layout().reversed_border()) decoders.push_back(code.at_two);
      }
      if (!decoders.empty()) detectors_[reversed].emplace(std::move(decoders));
    }
  }

  void add_picture(detect::Image image) {
    ++counts.pictures;
    while (true) {
      ++counts.images;
      counts.megapixels += 1e-6 * image.width() * image.height();
      for (const bool reversed : {false, true}) add_quads(image, reversed);
      if (std::min(image.width(), image.height()) < 2 * kLeastSide_px) return;
      image = halved(image);
    }
  }

  PhotographCounts counts;

 private:
  void add_quads(const detect::Image& image, bool reversed) {
    if (!detectors_[reversed]) return;
    QuadCollector collector;
    detectors_[reversed]->detect(image.view(), nullptr, &collector);
    for (const detect::Corners& corners : collector.quads) {
      for (std::size_t i = 0; i < codes_.size(); ++i) {
        if (codes_[i].family->layout().reversed_border() != reversed) continue;
        add_quad(image, {corners, reversed}, *codes_[i].at_safe, counts.by_code[i]);
      }
    }
  }

  void add_quad(const detect::Image& image, const detect::Quad& quad, const codec::Decoder& decoder,
                QuadCounts& of_code) {
    ++of_code.quads;
    const detect::DecodeResult result =
        detect::decode_quad(image.view(), quad, decoder, detect::DecodeOptions{}, scratch_);
    if (result.outcome < detect::DecodeOutcome::NoCodeword) return;
    ++of_code.words;
    if (result.detection) ++of_code.accepted[result.detection->hamming];
  }

  std::span<const MeasuredCode> codes_;
  std::map<bool, std::optional<detect::Detector>> detectors_;
  detect::DecodeScratch scratch_;
};

void add(PhotographCounts& sum, const PhotographCounts& part) {
  sum.pictures += part.pictures;
  sum.images += part.images;
  sum.megapixels += part.megapixels;
  sum.by_code.resize(part.by_code.size());
  for (std::size_t i = 0; i < part.by_code.size(); ++i) {
    QuadCounts& to = sum.by_code[i];
    const QuadCounts& from = part.by_code[i];
    to.quads += from.quads;
    to.words += from.words;
    to.accepted.resize(from.accepted.size());
    for (std::size_t e = 0; e < from.accepted.size(); ++e) to.accepted[e] += from.accepted[e];
  }
}

std::uint64_t accepted_between(const QuadCounts& counts, int first, int last) {
  std::uint64_t sum = 0;
  for (int errors = first; errors <= last; ++errors) sum += counts.accepted[errors];
  return sum;
}

}  // namespace

std::vector<std::string> find_pictures(const std::vector<std::string>& folders) {
  const std::regex size_name("(\\d+)x(\\d+)\\.\\w+");
  std::set<std::string> files;
  std::map<std::string, std::pair<long, std::string>> largest;  // by folder
  for (const std::string& folder : folders) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.is_symlink() || !entry.is_regular_file()) continue;
      static const std::set<std::string> kKinds = {".png",  ".jpg", ".jpeg", ".tif",
                                                   ".tiff", ".pgm", ".ppm"};
      if (!kKinds.contains(entry.path().extension().string())) continue;
      const std::string name = entry.path().filename().string();
      std::smatch sizes;
      if (!std::regex_match(name, sizes, size_name)) {
        files.insert(entry.path().string());
        continue;
      }
      auto& best = largest[entry.path().parent_path().string()];
      best = std::max(best, {std::stol(sizes[1]) * std::stol(sizes[2]), entry.path().string()});
    }
  }
  for (const auto& [folder, best] : largest) files.insert(best.second);
  return {files.begin(), files.end()};
}

PhotographCounts decode_photographs(std::span<const std::string> files,
                                    std::span<const MeasuredCode> codes, int threads) {
  if (threads == 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  PhotographCounts sum;
  std::vector<std::thread> crew;
  for (int t = 0; t < threads; ++t) {
    crew.emplace_back([&] {
      Worker worker(codes);
      for (std::size_t i = next++; i < files.size(); i = next++) {
        try {
          worker.add_picture(io::read_gray_image(files[i]));
        } catch (const std::exception& fault) {
          fmt::print(stderr, "left out: {}\n", fault.what());
        }
      }
      const std::lock_guard lock(mutex);
      add(sum, worker.counts);
    });
  }
  for (std::thread& thread : crew) thread.join();
  return sum;
}

Table photographs_table(const PhotographCounts& counts, std::span<const MeasuredCode> codes) {
  Table table = {{"family", "tags", "distance", "quads", "words", "0 errors", "1", "2",
                  "3 to the safe radius"}};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const MeasuredCode& code = codes[i];
    const QuadCounts& of_code = counts.by_code[i];
    const auto words = static_cast<double>(of_code.words);
    std::vector<std::string> row = {code.family->name(), fmt::to_string(code.codes),
                                    fmt::to_string(code.min_hamming), fmt::to_string(of_code.quads),
                                    fmt::to_string(of_code.words)};
    for (int errors = 0; errors <= 2; ++errors) {
      row.push_back(errors > code.safe_errors
                        ? "-"
                        : beside(of_code.accepted[errors], words * code.share_at(errors)));
    }
    row.push_back(code.safe_errors <= 2
                      ? "-"
                      : fmt::format("to {}: {}", code.safe_errors,
                                    beside(accepted_between(of_code, 3, code.safe_errors),
                                           words * (code.share_within(code.safe_errors) -
                                                    code.share_within(2)))));
    table.push_back(std::move(row));
  }
  return table;
}

Table photographs_by_errors(const PhotographCounts& counts, std::span<const MeasuredCode> codes) {
  Table table = {
      {"family", "tags", "distance", "quads", "words", "errors", "accepted", "expected"}};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const MeasuredCode& code = codes[i];
    const QuadCounts& of_code = counts.by_code[i];
    for (int errors = 0; errors <= code.safe_errors; ++errors) {
      table.push_back(
          {code.family->name(), fmt::to_string(code.codes), fmt::to_string(code.min_hamming),
           fmt::to_string(of_code.quads), fmt::to_string(of_code.words), fmt::to_string(errors),
           fmt::to_string(of_code.accepted[errors]),
           fmt::format("{:.4g}", static_cast<double>(of_code.words) * code.share_at(errors))});
    }
  }
  return table;
}

}  // namespace tagmint::bench
