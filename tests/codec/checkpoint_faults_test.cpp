#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/lexicode_options.h"
#include "support/scratch_folder.h"
#include "support/written_search.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/search/checkpoint.h"

namespace tagmint::codec {
namespace {

using tagmint::test::read_file;
using tagmint::test::ScratchFolder;
using tagmint::testing::options_for;
using tagmint::testing::parameters_of;
using tagmint::testing::small_search;
using tagmint::testing::write_search;
using tagmint::testing::WrittenSearch;

/// The message of the fault that going on from a file with `content` ends with; nothing when it
/// does not.
std::optional<std::string> refusal(const std::string& content,
                                   const CheckpointParameters& parameters) {
  const ScratchFolder folder;
  const std::string path = folder.write("search", content);
  try {
    Checkpoint::resume(path, parameters);
  } catch (const InputError& fault) {
    std::string message = fault.what();
    const std::string place = " (" + path + ")";
    const std::size_t at = message.find(place);
    if (at != std::string::npos) message.erase(at, place.size());
    EXPECT_EQ(read_file(path), content) << "a refused file is left as it is";
    return message;
  }
  return std::nullopt;
}

TEST(CheckpointFaults, ChangedByteIsRefusedWhereverItIs) {
  const LexicodeOptions options = small_search();
  const WrittenSearch written = write_search(options, 4);
  const ScratchFolder folder;
  for (std::size_t at = 0; at < written.file.size(); ++at) {
    std::string file = written.file;
    file[at] = static_cast<char>(file[at] ^ 1 << at % 8);
    const std::string path = folder.write(fmt::format("byte{}", at), file);
    EXPECT_THROW(Checkpoint::resume(path, parameters_of(options)), InputError) << "byte " << at;
  }
}

TEST(CheckpointFaults, DamagedRecordIsToldWithWhatIsSound) {
  const LexicodeOptions options = small_search();
  WrittenSearch written = write_search(options, 4);
  const std::size_t sound = written.places[1].bytes;
  written.file[sound + 3] ^= 1;
  EXPECT_EQ(refusal(written.file, parameters_of(options)),
            fmt::format("the checkpoint is damaged between byte {} and its end at {}; 'truncate -s "
                        "{} FILE' leaves what is sound, or search anew",
                        sound, written.file.size(), sound));
  EXPECT_EQ(refusal(written.file.substr(0, sound), parameters_of(options)), std::nullopt);
}

TEST(CheckpointFaults, AnotherSearchIsRefusedWithWhatDiffers) {
  const LexicodeOptions options = small_search();
  const std::string file = write_search(options, 4).file;
  const auto differs = [&](const CheckpointParameters& other, const std::string& how) {
    EXPECT_EQ(refusal(file, other),
              "the checkpoint belongs to another search: " + how +
                  "; repeat the options of that search, or search anew with another file");
  };
  differs(parameters_of(options_for("classic:8", 7, "apriltag3", "energy:0.3333")),
          R"(layout is "circle:9" there, "classic:8" here)");
  differs(parameters_of(options_for("circle:9", 6, "apriltag3", "energy:0.3333")),
          "min_hamming is 7 there, 6 here");
  differs(parameters_of(options_for("circle:9", 7, "seed:210710", "energy:0.3333")),
          R"(order is "apriltag3" there, "seed:210710" here)");
  differs(parameters_of(options_for("circle:9", 7, "apriltag3", "energy:0.3334")),
          R"(complexity is "energy:0.3333" there, "energy:0.3334" here)");
  differs(parameters_of(options, 2), "attempts is 1 there, 2 here");
}

TEST(CheckpointFaults, OtherFormatIsRefused) {
  const LexicodeOptions options = small_search();
  std::string file = write_search(options, 4).file;
  file.replace(0, file.find('\n'), "tagmint checkpoint 2");
  EXPECT_EQ(refusal(file, parameters_of(options)),
            "the checkpoint has format 2, this program reads format 1; go on with the version that "
            "wrote it, or search anew with another file");
}

TEST(CheckpointFaults, FileThatIsNoneIsRefused) {
  const LexicodeOptions options = small_search();
  for (const char* content : {"\n", "tagminted\n", "{\"name\": \"tag16h5\"}\n",
                              "\x7f"
                              "ELF"}) {
    EXPECT_EQ(refusal(content, parameters_of(options)),
              "is not a checkpoint of a search; give the file that --checkpoint has written");
  }
}

TEST(CheckpointFaults, HeaderOfAnotherSearchThatIsCutOffIsRefused) {
  const LexicodeOptions options = small_search();
  const LexicodeOptions other = options_for("classic:8", 5, "seed:1", "none");
  const WrittenSearch written = write_search(options, 4);
  const std::size_t header = written.places.front().bytes;
  const std::size_t shared = written.file.find("circle");
  for (std::size_t bytes = shared + 2; bytes < header; ++bytes) {
    EXPECT_EQ(refusal(written.file.substr(0, bytes), parameters_of(other)),
              "the checkpoint is cut off within its first two lines; remove it, and search anew")
        << bytes;
  }
}

TEST(CheckpointFaults, IsUsedByOneSearchAtATime) {
  const ScratchFolder folder;
  const std::string path = folder.file("search");
  const CheckpointParameters parameters = parameters_of(small_search());
  const auto message = [&](auto&& open) -> std::string {
    try {
      open(path, parameters);
    } catch (const OutputError& fault) {
      return fault.what();
    }
    return "no fault";
  };
  {
    const Checkpoint first = Checkpoint::begin(path, parameters);
    EXPECT_EQ(message(Checkpoint::resume), "another search is using the checkpoint (" + path +
                                               "); wait for it, or give another file");
  }
  EXPECT_EQ(message(Checkpoint::resume), "no fault");
  EXPECT_EQ(message(Checkpoint::begin), "the checkpoint exists already (" + path +
                                            "); go on from it with --resume, or remove it");
}

TEST(CheckpointFaults, PlacesThatHoldNoFileAreTold) {
  const ScratchFolder folder;
  const CheckpointParameters parameters = parameters_of(small_search());
  const std::string folder_name = folder.path().string();
  const auto message = [&](auto&& open, const std::string& path) -> std::string {
    try {
      open(path, parameters);
    } catch (const Fault& fault) {
      return fault.what();
    }
    return "no fault";
  };
  EXPECT_EQ(message(Checkpoint::resume, folder_name),
            "the checkpoint is not a file (" + folder_name + "); give the name of its file");
  EXPECT_EQ(message(Checkpoint::begin, folder_name),
            "cannot write the file: Is a directory (" + folder_name +
                "); give the name of a file, not of a folder");
  const std::string missing = folder.file("missing");
  EXPECT_EQ(message(Checkpoint::resume, missing),
            "there is no such checkpoint (" + missing + "); give the name of its file");
  EXPECT_EQ(message(Checkpoint::begin, missing + "/search"),
            "cannot write the file: No such file or directory (" + missing +
                "/search); make the folder " + missing + " first");
}

TEST(CheckpointFaults, FileThatMayNotBeUsedIsTold) {
  const ScratchFolder folder;
  const CheckpointParameters parameters = parameters_of(small_search());
  const std::string path = folder.file("search");
  Checkpoint::begin(path, parameters);
  namespace fs = std::filesystem;
  const uid_t user = geteuid();
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(path, fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write);
  constexpr uid_t kNobody = 65534;  // permissions do not hold root back
  if (user == 0 && seteuid(kNobody) != 0) GTEST_SKIP() << "root may read everything";
  EXPECT_THROW(Checkpoint::resume(path, parameters), InputError);
  ASSERT_EQ(seteuid(user), 0);
  fs::permissions(path, fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
  ASSERT_EQ(seteuid(user == 0 ? kNobody : user), 0);
  EXPECT_THROW(Checkpoint::resume(path, parameters), OutputError);
  ASSERT_EQ(seteuid(user), 0);
}

/// While it lives, no file grows beyond `bytes`, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(CheckpointFaults, FullDiskLosesNothingOnceThereIsRoomAgain) {
  const ScratchFolder folder;
  const std::string path = folder.file("search");
  const CheckpointParameters parameters = parameters_of(small_search());
  const std::vector<Codeword> codes = {1, 2, 3, 4, 5, 6, 7, 8};
  Checkpoint checkpoint = Checkpoint::begin(path, parameters);
  checkpoint.add({SearchPhase::Walk, 10, std::span(codes).first(2)});
  checkpoint.flush();
  const std::size_t sound = std::filesystem::file_size(path);
  {
    const FullDisk full(sound + 70);  // half of the next record
    checkpoint.add({SearchPhase::Walk, 20, std::span(codes).subspan(2)});
    EXPECT_THROW(checkpoint.flush(), OutputError);
    EXPECT_GT(std::filesystem::file_size(path), sound);
  }
  checkpoint.flush();
  checkpoint = Checkpoint::begin(folder.file("other"), parameters);
  const CheckpointContent content = Checkpoint::resume(path, parameters).take_content();
  EXPECT_EQ(content.state.codewords, codes);
  EXPECT_EQ(content.state.words_walked, 20u);
}

TEST(CheckpointFaults, FullDiskLeavesNoFileWithoutAHeader) {
  const ScratchFolder folder;
  const FullDisk full(10);
  EXPECT_THROW(Checkpoint::begin(folder.file("search"), parameters_of(small_search())),
               OutputError);
  EXPECT_EQ(folder.names(), std::vector<std::string>{});
}

}  // namespace
}  // namespace tagmint::codec
