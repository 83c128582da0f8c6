#include "search/checkpoint_record.h"

#include "sha256.h"

namespace tagmint::codec {
namespace {

constexpr std::size_t kDigestBytes = 16;
constexpr std::size_t kNumberBytes = 8;
constexpr std::size_t kHeadBytes = 3 * kNumberBytes + kDigestBytes;

void append_number(std::string& bytes, std::uint64_t number) {
  for (std::size_t i = 0; i < kNumberBytes; ++i) {
    bytes.push_back(static_cast<char>(number >> (8 * i) & 0xff));
  }
}

std::uint64_t number_at(std::string_view bytes, std::size_t at) {
  std::uint64_t number = 0;
  for (std::size_t i = kNumberBytes; i-- > 0;) {
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return number;
}

/// `bytes` end with their digest, which follows `before`.
bool digest_holds(std::string_view bytes, std::string_view before) {
  const std::size_t end = bytes.size() - kDigestBytes;
  return bytes.substr(end) == chained_digest(before, bytes.substr(0, end));
}

std::string digest_of(std::string_view bytes) {
  return std::string(bytes.substr(bytes.size() - kDigestBytes));
}

std::string read_bytes(std::istream& stream, std::uint64_t count) {
  std::string bytes(count, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

bool known(std::uint64_t kind) {
  return kind >= static_cast<std::uint64_t>(CheckpointRecord::Kind::Walk) &&
         kind <= static_cast<std::uint64_t>(CheckpointRecord::Kind::EndOfAttempt);
}

}  // namespace

std::string chained_digest(std::string_view before, std::string_view bytes) {
  return sha256_hex(std::string(before).append(bytes)).substr(0, kDigestBytes);
}

std::string format_record(const CheckpointRecord& record, std::string& digest) {
  std::string head;
  append_number(head, static_cast<std::uint64_t>(record.kind));
  append_number(head, record.done);
  append_number(head, record.words.size());
  digest = chained_digest(digest, head);
  head += digest;
  std::string words;
  words.reserve(record.words.size() * kNumberBytes);
  for (const Codeword word : record.words) append_number(words, word);
  digest = chained_digest(digest, words);
  return head + words + digest;
}

RecordReading read_record(std::istream& stream, std::uint64_t bytes_left, std::string& digest,
                          CheckpointRecord& record, std::uint64_t& bytes_read) {
  if (bytes_left < kHeadBytes) return RecordReading::CutOff;
  const std::string head = read_bytes(stream, kHeadBytes);
  if (head.size() < kHeadBytes) return RecordReading::Unreadable;
  const std::uint64_t kind = number_at(head, 0);
  const std::uint64_t count = number_at(head, 2 * kNumberBytes);
  if (!digest_holds(head, digest) || !known(kind)) return RecordReading::Damaged;

  const std::uint64_t after_head = bytes_left - kHeadBytes;
  if (after_head < kDigestBytes || (after_head - kDigestBytes) / kNumberBytes < count) {
    return RecordReading::CutOff;
  }
  const std::string body = read_bytes(stream, count * kNumberBytes + kDigestBytes);
  if (body.size() < count * kNumberBytes + kDigestBytes) return RecordReading::Unreadable;
  if (!digest_holds(body, digest_of(head))) return RecordReading::Damaged;

  record.kind = static_cast<CheckpointRecord::Kind>(kind);
  record.done = number_at(head, kNumberBytes);
  record.words.resize(count);
  for (std::size_t i = 0; i < count; ++i) record.words[i] = number_at(body, i * kNumberBytes);
  digest = digest_of(body);
  bytes_read = head.size() + body.size();
  return RecordReading::Whole;
}

}  // namespace tagmint::codec
