#include "tagmint/codec/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tagmint/codec/errors.h"

namespace tagmint::codec {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed afterwards.
class AtomicFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "tagmint-atomic-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }
  std::ptrdiff_t files_in_folder() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  static std::string message_of(const fs::path& path) {
    try {
      write_file_atomically(path, "x");
    } catch (const OutputError& error) {
      return error.what();
    }
    return "written";
  }

  fs::path folder_;
};

TEST_F(AtomicFile, WritesEveryByteAndLeavesNothingElse) {
  const std::string content = std::string("a\0b\n", 4) + std::string(300000, 'z');
  write_file_atomically(folder_ / "new.json", content);
  EXPECT_EQ(content_of(folder_ / "new.json"), content);
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(AtomicFile, ReplacesAFileAndKeepsItsMode) {
  const fs::path path = folder_ / "old.json";
  write_file_atomically(path, "old");
  ::chmod(path.c_str(), 0640);
  write_file_atomically(path, "new");
  EXPECT_EQ(content_of(path), "new");
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST_F(AtomicFile, KeepsASymbolicLinkAndReplacesWhatItLeadsTo) {
  write_file_atomically(folder_ / "target", "old");
  fs::create_symlink("target", folder_ / "link");
  write_file_atomically(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content_of(folder_ / "target"), "new");
}

TEST_F(AtomicFile, StreamedContentIsReadableBeforeItHasItsName) {
  const fs::path path = folder_ / "streamed.pdf";
  codec::AtomicFile file(path);
  file.write("first ");
  file.write("second");
  file.close();
  EXPECT_FALSE(fs::exists(path));
  EXPECT_EQ(content_of(file.written_path()), "first second");
  file.publish();
  EXPECT_EQ(content_of(path), "first second");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(AtomicFile, WhatIsNotPublishedIsRemoved) {
  { codec::AtomicFile(folder_ / "never").write("content"); }
  EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(AtomicFile, ADeviceIsWrittenDirectly) {
  write_file_atomically("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFile, FaultsNameTheFileAndTheRemedy) {
  const std::string missing = message_of(folder_ / "no" / "such.json");
  EXPECT_NE(missing.find("No such file or directory"), std::string::npos) << missing;
  EXPECT_NE(missing.find("make the folder " + (folder_ / "no").string()), std::string::npos);
  EXPECT_NE(message_of(folder_).find("Is a directory"), std::string::npos);
  EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(AtomicFile, AFullDeviceIsTold) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  EXPECT_NE(message_of("/dev/full").find("No space left on device"), std::string::npos);
}

TEST_F(AtomicFile, AFailedWriteLeavesTheOldFileAndNoHalfOne) {
  const fs::path path = folder_ / "f";
  write_file_atomically(path, "old");
  // Files may grow to 1000 bytes only while this lasts; the write then fails half-way.
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  const rlimit small{1000, limit.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  EXPECT_THROW(write_file_atomically(path, std::string(5000, 'z')), OutputError);
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, before);
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(files_in_folder(), 1);
}

}  // namespace
}  // namespace tagmint::codec
