#include "detector/measure.h"

#include <time.h>

#include <algorithm>
#include <memory>

namespace tagmint::bench {
namespace {

double seconds_now(TimeKind kind) {
  timespec now{};
  clock_gettime(kind == TimeKind::Wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A contender at work: its answers and its times by picture.
struct Entry {
  std::string name;
  std::unique_ptr<Contender> contender;
  Score score;
  std::vector<std::vector<double>> nanoseconds;  ///< by picture, one for each repetition
};

double nanoseconds_of(Contender& contender, detect::ImageView image, TimeKind kind) {
  const double start = seconds_now(kind);
  contender.detect(image);
  return 1e9 * (seconds_now(kind) - start);
}

std::vector<Picture> draw_all(const PictureSet& set, const MeasureOptions& options) {
  int count = options.pictures;
  if (set.most > 0) count = set.whole ? set.most : std::min(set.most, count);
  std::vector<Picture> pictures;
  for (int i = 0; i < count; ++i) pictures.push_back(set.draw(i, options.seed));
  return pictures;
}

std::vector<Entry> enter(const PictureSet& set, std::span<const ContenderKind> kinds,
                         std::size_t pictures) {
  std::vector<Entry> entries;
  for (const ContenderKind& kind : kinds) {
    std::unique_ptr<Contender> contender = kind.make_for(set.task);
    if (!contender) continue;
    Entry& entry = entries.emplace_back();
    entry.name = kind.name;
    entry.contender = std::move(contender);
    entry.nanoseconds.resize(pictures);
  }
  return entries;
}

Row row_of(const PictureSet& set, const Entry& entry, std::span<const Picture> pictures) {
  Row row{.set = set.name, .contender = entry.name, .score = entry.score};
  row.pictures = static_cast<int>(pictures.size());
  double time = 0;
  double pixels = 0;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    time += quantile(entry.nanoseconds[i], 0.5);
    pixels += static_cast<double>(pictures[i].image.width()) * pictures[i].image.height();
  }
  row.nanoseconds_per_pixel = pixels > 0 ? time / pixels : 0;
  return row;
}

}  // namespace

std::vector<Row> measure(const PictureSet& set, std::span<const ContenderKind> kinds,
                         const MeasureOptions& options) {
  const std::vector<Picture> pictures = draw_all(set, options);
  std::vector<Entry> entries = enter(set, kinds, pictures.size());
  for (int pass = 0; pass <= options.repetitions; ++pass) {
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      for (Entry& entry : entries) {
        const double time = nanoseconds_of(*entry.contender, pictures[i].image, options.time);
        if (pass == 0) {
          judge(entry.contender->found(), pictures[i], entry.score);
        } else {
          entry.nanoseconds[i].push_back(time);
        }
      }
    }
  }
  std::vector<Row> rows;
  for (const Entry& entry : entries) rows.push_back(row_of(set, entry, pictures));
  const auto yardstick = std::find_if(rows.begin(), rows.end(),
                                      [](const Row& row) { return row.contender == kYardstick; });
  if (yardstick != rows.end()) {
    const double theirs = yardstick->nanoseconds_per_pixel;
    for (Row& row : rows) row.times_as_fast = theirs / row.nanoseconds_per_pixel;
  }
  return rows;
}

}  // namespace tagmint::bench
