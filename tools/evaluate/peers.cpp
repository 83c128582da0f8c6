#include "evaluate/peers.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "evaluate/peers/peer_interface.h"

namespace tagmint::evaluate {
namespace {

namespace fs = std::filesystem;

/// Families of more tags are not listed for peers: none of them would take so many.
constexpr std::size_t kMostCodes = 200'000;

/// A family as peers are told of it, and what that points to.
class ToldFamily {
 public:
  explicit ToldFamily(const codec::Family& family)
      : name_(family.name()), codewords_(codec::first_codewords(family, family.size())) {
    const codec::Layout& layout = family.layout();
    for (const codec::CellPosition cell : layout.data_cells()) {
      bit_x_.push_back(static_cast<std::uint32_t>(cell.x - layout.border_offset()));
      bit_y_.push_back(static_cast<std::uint32_t>(cell.y - layout.border_offset()));
    }
    told_ = {.name = name_.c_str(),
             .codes = static_cast<std::uint32_t>(codewords_.size()),
             .codewords = codewords_.data(),
             .bits = static_cast<std::uint32_t>(family.bits()),
             .bit_x = bit_x_.data(),
             .bit_y = bit_y_.data(),
             .width_at_border = layout.width_at_border(),
             .total_width = layout.width(),
             .reversed_border = layout.reversed_border() ? 1 : 0,
             .min_hamming = static_cast<std::uint32_t>(family.min_hamming())};
  }
  ToldFamily(const ToldFamily&) = delete;
  ToldFamily& operator=(const ToldFamily&) = delete;

  tagmint_peer_task task(const Task& task) const {
    return {.family = &told_,
            .decimate = task.decimate,
            .threads = task.threads,
            .max_hamming = task.max_hamming};
  }

 private:
  std::string name_;
  std::vector<codec::Codeword> codewords_;
  std::vector<std::uint32_t> bit_x_, bit_y_;
  tagmint_peer_family told_{};
};

class PeerContender : public Contender {
 public:
  PeerContender(const tagmint_peer& peer, std::unique_ptr<ToldFamily> family, void* detector)
      : peer_(peer), family_(std::move(family)), detector_(detector) {}
  ~PeerContender() override { peer_.close(detector_); }

  void detect(detect::ImageView image) override {
    peer_.detect(detector_, image.data, image.width, image.height, image.stride);
  }

  std::vector<FoundTag> found() const override {
    std::vector<FoundTag> tags;
    const int count = peer_.count(detector_);
    for (int i = 0; i < count; ++i) {
      const tagmint_peer_tag one = peer_.tag(detector_, i);
      FoundTag& tag = tags.emplace_back();
      tag.id = static_cast<codec::TagId>(one.id);
      if (one.hamming >= 0) tag.hamming = one.hamming;
      for (std::size_t k = 0; k < 4; ++k) {
        tag.corners[k] = {one.corners[2 * k], one.corners[2 * k + 1]};
      }
    }
    return tags;
  }

  std::optional<std::int64_t> candidates() const override {
    const std::int64_t count = peer_.candidates(detector_);
    return count < 0 ? std::nullopt : std::optional(count);
  }

 private:
  const tagmint_peer& peer_;
  std::unique_ptr<ToldFamily> family_;
  void* detector_;
};

ContenderKind kind_of(const tagmint_peer& peer) {
  ContenderKind kind{.name = peer.name, .release = peer.release, .style = peer.style, .make = {}};
  kind.make = [&peer](const Task& task) -> std::unique_ptr<Contender> {
    if (task.family->size() > kMostCodes) return nullptr;
    auto family = std::make_unique<ToldFamily>(*task.family);
    const tagmint_peer_task told = family->task(task);
    void* const detector = peer.open(&told);
    if (detector == nullptr) return nullptr;
    return std::make_unique<PeerContender>(peer, std::move(family), detector);
  };
  if (peer.table_cost != nullptr) {
    kind.table_cost = [&peer](const Task& task) -> std::optional<TableCost> {
      if (task.family->size() > kMostCodes) return std::nullopt;
      const ToldFamily family(*task.family);
      const tagmint_peer_task told = family.task(task);
      TableCost cost;
      if (peer.table_cost(&told, &cost.bytes, &cost.seconds) == 0) return std::nullopt;
      return cost;
    };
  }
  return kind;
}

void open_peer(const fs::path& path, Peers& peers) {
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    peers.left_out.push_back(fmt::format("{}: {}", path.stem().string(), dlerror()));
    return;
  }
  using Entry = const tagmint_peer* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(library, "tagmint_peer_entry"));
  const tagmint_peer* const peer = entry == nullptr ? nullptr : entry();
  if (peer == nullptr || peer->version != TAGMINT_PEER_VERSION) {
    peers.left_out.push_back(path.stem().string() + ": no peer of this version of tagmint");
    return;
  }
  peers.kinds.push_back(kind_of(*peer));
}

}  // namespace

std::vector<fs::path> peer_folders() {
  // Read before any thread is started.
  if (const char* named = std::getenv("TAGMINT_PEERS")) return {named};  // NOLINT(concurrency-*)
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  return {program.parent_path() / "peers", program.parent_path() / TAGMINT_PEERS_FROM_PROGRAM};
}

Peers find_peers(const std::vector<fs::path>& folders) {
  Peers peers;
  for (const fs::path& folder : folders) {
    std::vector<fs::path> libraries;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      if (entry.path().extension() == ".so") libraries.push_back(entry.path());
    }
    if (libraries.empty()) continue;
    std::sort(libraries.begin(), libraries.end());
    for (const fs::path& library : libraries) open_peer(library, peers);
    break;
  }
  return peers;
}

}  // namespace tagmint::evaluate
