#include "tagmint/codec/search/checkpoint.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "posix_file.h"
#include "search/checkpoint_record.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/layout_presets.h"

namespace tagmint::codec {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;
using Kind = CheckpointRecord::Kind;

constexpr std::string_view kFirstWords = "tagmint checkpoint ";
/// To be raised when the numbers in a record change their meaning: the form of the file, the walk,
/// or which words belong to which subtree of SearchCrew::list_open().
constexpr int kFormatVersion = 1;
constexpr std::chrono::milliseconds kWriteEvery{200};
constexpr std::chrono::seconds kFlushEvery{10};

Json parameters_json(const CheckpointParameters& parameters) {
  const SearchRules& rules = parameters.rules;
  Json json;
  json["layout"] = layout_name(rules.layout);
  json["min_hamming"] = rules.min_hamming;
  json["order"] = to_string(rules.order);
  json["complexity"] = to_string(rules.complexity);
  json["attempts"] = parameters.attempts;
  if (parameters.attempts > 1) {
    json["limit_words"] = parameters.limit_words ? Json(*parameters.limit_words) : Json();
    json["limit_codes"] = parameters.limit_codes ? Json(*parameters.limit_codes) : Json();
  }
  return json;
}

std::string header(const CheckpointParameters& parameters) {
  return fmt::format("{}{}\n{}\n", kFirstWords, kFormatVersion, parameters_json(parameters).dump());
}

std::string first_line(std::string_view header) {
  return std::string(header.substr(0, header.find('\n')));
}

/// The first two lines of a file with their ends, or all of a file that has fewer.
std::string read_header(std::istream& file) {
  std::string header;
  for (int lines = 0; lines < 2;) {
    const int byte = file.get();
    if (byte == std::char_traits<char>::eof()) break;
    header.push_back(static_cast<char>(byte));
    lines += byte == '\n';
  }
  return header;
}

/// Throws InputError unless `second`, a line of a checkpoint, tells of the search by `parameters`.
void require_parameters(std::string_view second, const CheckpointParameters& parameters,
                        const fs::path& path) {
  const Json theirs = Json::parse(second, nullptr, false);
  const Json ours = parameters_json(parameters);
  for (const auto& [key, value] : ours.items()) {
    if (!theirs.is_object() || !theirs.contains(key)) {
      throw InputError("the checkpoint is damaged in its second line", path.string(),
                       "search anew with another file");
    }
    if (theirs[key] == value) continue;
    throw InputError(
        fmt::format("the checkpoint belongs to another search: {} is {} there, {} here", key,
                    theirs[key].dump(), value.dump()),
        path.string(), "repeat the options of that search, or search anew with another file");
  }
}

/// Throws InputError unless `header`, the beginning of a file, is that of a checkpoint of the
/// search by `parameters`.
void require_header(const std::string& header, const CheckpointParameters& parameters,
                    const fs::path& path) {
  if (!header.starts_with(kFirstWords)) {
    throw InputError("is not a checkpoint of a search", path.string(),
                     "give the file that --checkpoint has written");
  }
  const std::string first = first_line(header);
  if (first.size() + 1 >= header.size() || !header.ends_with('\n')) {
    throw InputError("the checkpoint is cut off within its first two lines", path.string(),
                     "remove it, and search anew");
  }
  if (first != fmt::format("{}{}", kFirstWords, kFormatVersion)) {
    throw InputError(fmt::format("the checkpoint has format {}, this program reads format {}",
                                 first.substr(kFirstWords.size()), kFormatVersion),
                     path.string(),
                     "go on with the version that wrote it, or search anew with another file");
  }
  require_parameters(std::string_view(header).substr(first.size() + 1), parameters, path);
}

[[noreturn]] void fail_to_read(const fs::path& path) {
  throw InputError("cannot read the checkpoint", path.string(), "check that the file may be read");
}

/// What the records add up to, and where the last whole one ends: 0 where not even the header is
/// there.
struct Replay {
  CheckpointContent content;
  std::uint64_t end = 0;
  std::string digest;
};

void apply(const CheckpointRecord& record, CheckpointContent& content) {
  if (record.kind != Kind::EndOfAttempt) {
    content.state.apply({static_cast<SearchPhase>(record.kind), record.done, record.words});
    return;
  }
  const auto end = static_cast<SearchEnd>(record.words.empty() ? 0 : record.words.front());
  content.finished.push_back({std::move(content.state.codewords), record.done, end});
  content.state = {};
}

Replay replay(const fs::path& path, const CheckpointParameters& parameters) {
  std::ifstream file(path, std::ios::binary);
  if (!file) fail_to_read(path);
  const std::uint64_t size = fs::file_size(path);
  const std::string expected = header(parameters);
  const std::string found = read_header(file);
  const bool both_lines = std::count(found.begin(), found.end(), '\n') == 2;
  if (!both_lines && found.size() < size) fail_to_read(path);
  Replay replayed;
  // A search that was killed while it began its file.
  if (found.size() < expected.size() && expected.starts_with(found)) return replayed;
  require_header(found, parameters, path);

  replayed.end = found.size();
  replayed.digest = chained_digest("", found);
  // Room for all words at once: what is not used costs no memory.
  replayed.content.state.open_tags.reserve(size / sizeof(Codeword));
  CheckpointRecord record;
  while (replayed.end < size) {
    std::uint64_t bytes = 0;
    const RecordReading reading =
        read_record(file, size - replayed.end, replayed.digest, record, bytes);
    if (reading == RecordReading::CutOff) break;
    if (reading == RecordReading::Unreadable) fail_to_read(path);
    if (reading == RecordReading::Damaged) {
      throw InputError(
          fmt::format("the checkpoint is damaged between byte {} and its end at {}", replayed.end,
                      size),
          path.string(),
          fmt::format("'truncate -s {} FILE' leaves what is sound, or search anew", replayed.end));
    }
    apply(record, replayed.content);
    replayed.end += bytes;
  }
  return replayed;
}

}  // namespace

class Checkpoint::File {
 public:
  /// `flags` beside O_WRONLY as of open(). Nobody else may write while the object lives.
  File(const fs::path& path, int flags) : path_(path), file_(path, O_WRONLY | flags) {
    if (!file_.is_open()) fail_to_write(errno, path);
    // Some network file systems have no locks; there the user sees to it.
    if (::flock(file_.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    throw OutputError("another search is using the checkpoint", path.string(),
                      "wait for it, or give another file");
  }

  void begin(const std::string& header) {
    put(header);
    digest_ = chained_digest("", header);
    flush();
  }

  void restore(Replay replayed, const std::string& header) {
    if (::ftruncate(file_.get(), static_cast<off_t>(replayed.end)) != 0) {
      fail_to_write(errno, path_);
    }
    if (replayed.end == 0) return begin(header);
    size_ = replayed.end;
    digest_ = std::move(replayed.digest);
    content_ = std::move(replayed.content);
  }

  CheckpointContent& content() { return content_; }

  void add(Kind kind, std::uint64_t done, std::span<const Codeword> words) {
    if (pending_ && pending_->kind != kind) write();
    if (!pending_) pending_ = CheckpointRecord{.kind = kind, .done = 0, .words = {}};
    pending_->done = done;
    pending_->words.insert(pending_->words.end(), words.begin(), words.end());
    const auto now = Clock::now();
    if (now - written_ >= kWriteEvery) write();
    if (now - flushed_ >= kFlushEvery) flush();
  }

  /// Hands what is pending to the system, which keeps it when the program is killed.
  void write() {
    if (!pending_) return;
    std::string digest = digest_;
    const std::string bytes = format_record(*pending_, digest);
    put(bytes);
    digest_ = std::move(digest);
    pending_.reset();
    written_ = Clock::now();
  }

  void flush() {
    write();
    if (::fdatasync(file_.get()) != 0) fail_to_write(errno, path_);
    flushed_ = Clock::now();
  }

 private:
  /// Appends; what a failure left behind the last whole record is overwritten by the next attempt.
  void put(std::string_view bytes) {
    if (::lseek(file_.get(), static_cast<off_t>(size_), SEEK_SET) < 0 ||
        !write_all(file_.get(), bytes)) {
      fail_to_write(errno, path_);
    }
    size_ += bytes.size();
  }

  fs::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;  // of all that was written whole
  std::string digest_;      // of the last record written
  CheckpointContent content_;
  std::optional<CheckpointRecord> pending_;
  Clock::time_point written_ = Clock::now();
  Clock::time_point flushed_ = Clock::now();
};

Checkpoint::Checkpoint(std::unique_ptr<File> file) : file_(std::move(file)) {}
Checkpoint::Checkpoint(Checkpoint&&) noexcept = default;
Checkpoint& Checkpoint::operator=(Checkpoint&&) noexcept = default;

Checkpoint::~Checkpoint() {
  try {
    if (file_) file_->write();
  } catch (const OutputError&) {
    // What was not written is searched again.
  }
}

Checkpoint Checkpoint::begin(const fs::path& path, const CheckpointParameters& parameters) {
  if (fs::is_directory(path)) fail_to_write(EISDIR, path);
  if (fs::exists(path)) {
    throw OutputError("the checkpoint exists already", path.string(),
                      "go on from it with --resume, or remove it");
  }
  auto file = std::make_unique<File>(path, O_CREAT | O_EXCL);
  try {
    file->begin(header(parameters));
  } catch (const OutputError&) {
    std::error_code ignored;
    fs::remove(path, ignored);
    throw;
  }
  return Checkpoint(std::move(file));
}

Checkpoint Checkpoint::resume(const fs::path& path, const CheckpointParameters& parameters) {
  if (!fs::is_regular_file(path)) {
    throw InputError(
        fs::exists(path) ? "the checkpoint is not a file" : "there is no such checkpoint",
        path.string(), "give the name of its file");
  }
  auto file = std::make_unique<File>(path, 0);
  file->restore(replay(path, parameters), header(parameters));
  return Checkpoint(std::move(file));
}

const CheckpointContent& Checkpoint::content() const { return file_->content(); }
CheckpointContent Checkpoint::take_content() { return std::exchange(file_->content(), {}); }

void Checkpoint::add(const SearchStep& step) {
  file_->add(static_cast<Kind>(step.phase), step.done, step.words);
}

void Checkpoint::end_attempt(const LexicodeResult& result) {
  const Codeword end = static_cast<Codeword>(result.end);
  file_->add(Kind::EndOfAttempt, result.words_searched, std::span(&end, 1));
  file_->flush();
}

void Checkpoint::flush() { file_->flush(); }

}  // namespace tagmint::codec
