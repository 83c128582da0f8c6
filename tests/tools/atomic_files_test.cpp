#include "io/atomic_files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "tagmint/codec/errors.h"

namespace tagmint::io {
namespace {

using test::read_file;
using test::ScratchFolder;

TEST(AtomicFiles, NothingAppearsBeforeTheEnd) {
  const ScratchFolder folder;
  AtomicFiles files;
  files.add(folder.file("a.txt"), "first");
  files.add(folder.file("b.txt"), "second");
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.txt")));
  files.finish();
  EXPECT_EQ(read_file(folder.file("a.txt")), "first");
  EXPECT_EQ(read_file(folder.file("b.txt")), "second");
}

TEST(AtomicFiles, NothingIsLeftOverWithoutTheEnd) {
  const ScratchFolder folder;
  folder.write("a.txt", "older");
  {
    AtomicFiles files;
    files.add(folder.file("a.txt"), "newer");
    files.add(folder.file("b.txt"), "second");
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.txt"}));
  EXPECT_EQ(read_file(folder.file("a.txt")), "older");
}

TEST(AtomicFiles, NoOtherFilesStayAfterTheEnd) {
  const ScratchFolder folder;
  folder.write("a.txt", "older");
  {
    AtomicFiles files;
    files.add(folder.file("a.txt"), "newer");
    files.add(folder.file("b.txt"), "second");
    files.finish();
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.txt", "b.txt"}));
  EXPECT_EQ(read_file(folder.file("a.txt")), "newer");
}

TEST(AtomicFiles, WhatWasRenamedIsTakenBackWhereALaterOneFails) {
  const ScratchFolder folder;
  folder.write("older.txt", "older");
  AtomicFiles files;
  files.add(folder.file("older.txt"), "newer");
  files.add(folder.file("new.txt"), "new");
  files.add(folder.file("last.txt"), "last");
  // A folder takes the place of the last file before it gets its name.
  std::filesystem::create_directory(folder.file("last.txt"));
  EXPECT_THROW(files.finish(), codec::OutputError);
  EXPECT_EQ(read_file(folder.file("older.txt")), "older");
  EXPECT_FALSE(std::filesystem::exists(folder.file("new.txt")));
}

TEST(AtomicFiles, OneFileTakesOneResult) {
  const ScratchFolder folder;
  AtomicFiles files;
  files.add(folder.file("a.txt"), "first");
  EXPECT_THROW(files.add(folder.path() / "." / "a.txt", "second"), codec::OutputError);
}

TEST(AtomicFiles, LinksAndRightsStay) {
  const ScratchFolder folder;
  const std::string target = folder.write("target.txt", "older");
  ::chmod(target.c_str(), 0640);
  std::filesystem::create_symlink("target.txt", folder.file("link.txt"));
  AtomicFiles files;
  files.add(folder.file("link.txt"), "newer");
  files.finish();
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(read_file(target), "newer");
  struct stat status {};
  ::stat(target.c_str(), &status);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(AtomicFiles, AFullDeviceKeepsAllOthersAway) {
  const ScratchFolder folder;
  {
    AtomicFiles files;
    files.add(folder.file("a.txt"), "first");
    EXPECT_THROW(files.add("/dev/full", "second"), codec::OutputError);
  }
  EXPECT_EQ(folder.names(), (std::vector<std::string>{}));
}

TEST(AtomicFiles, FoldersAndMissingFoldersAreRefused) {
  const ScratchFolder folder;
  AtomicFiles files;
  EXPECT_THROW(files.add(folder.path(), "x"), codec::OutputError);
  EXPECT_THROW(files.add(folder.file("no/such.txt"), "x"), codec::OutputError);
}

}  // namespace
}  // namespace tagmint::io
