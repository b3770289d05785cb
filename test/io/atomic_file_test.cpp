#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <io/temporary_folder.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/atomic_file.hpp>

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(AtomicFileTest, WritesWhatItWasGiven) {
  const TemporaryFolder folder;
  const std::string content("a\0b\n", 4);
  write_file_atomically(folder / "file", content);
  EXPECT_EQ(content_of(folder / "file"), content);
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFileTest, ReplacesAnOldFileAndKeepsItsPermissions) {
  const TemporaryFolder folder;
  const auto path = folder.write("file", "a much longer old content");
  ::chmod(path.c_str(), 0640);
  write_file_atomically(path, "new");
  EXPECT_EQ(content_of(path), "new");
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(AtomicFileTest, GivesANewFileTheUsersPermissions) {
  const TemporaryFolder folder;
  const mode_t old_mask = ::umask(027);
  write_file_atomically(folder / "file", "x");
  ::umask(old_mask);
  struct stat status {};
  ASSERT_EQ(::stat((folder / "file").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(AtomicFileTest, WritesTheFileThatALinkNames) {
  const TemporaryFolder folder;
  const auto path = folder.write("file", "old");
  std::filesystem::create_symlink("file", folder / "link");
  write_file_atomically(folder / "link", "new");
  EXPECT_EQ(content_of(path), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
}

TEST(AtomicFileTest, TellsPathAndReasonWhenTheFolderIsMissing) {
  const TemporaryFolder folder;
  const auto path = folder / "missing/file";
  try {
    write_file_atomically(path, "x");
    FAIL() << "must throw";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Failure);
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr(path.string()), HasSubstr("No such file or directory"), Not(HasSubstr("\n"))));
  }
}

TEST(AtomicFileTest, RefusesWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_of([&] { write_file_atomically(folder.path(), "x"); }), HasSubstr("not a regular file"));
  EXPECT_THAT(message_of([&] { write_file_atomically("/dev/null", "x"); }), HasSubstr("not a regular file"));
  EXPECT_THROW(write_file_atomically("", "x"), Error);
  EXPECT_EQ(folder.file_count(), 0u);
}

/// Runs in a child process, since limits and rights can't be taken back; 0 says that `action` was as it should be.
template <typename Action>
int exit_code_of_child(Action action) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(action() ? 0 : 1);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(AtomicFileTest, LeavesTheOldFileWhenTheNewOneGrowsTooLarge) {
  const TemporaryFolder folder;
  const auto path = folder.write("file", "old");
  const auto action = [&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{10000, 10000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const std::string message = message_of([&] { write_file_atomically(path, std::string(100000, 'x')); });
    return message.find("File too large") != std::string::npos && message.find(path.string()) != std::string::npos;
  };
  EXPECT_EQ(exit_code_of_child(action), 0);
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFileTest, LeavesTheOldFileWhenTheFolderMayNotBeWritten) {
  const TemporaryFolder folder;
  const auto path = folder.write("file", "old");
  ::chmod(folder.path().c_str(), 0555);
  const auto action = [&] {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) return false;  // root may write everywhere
    return message_of([&] { write_file_atomically(path, "x"); }).find("Permission denied") != std::string::npos;
  };
  EXPECT_EQ(exit_code_of_child(action), 0);
  ::chmod(folder.path().c_str(), 0755);
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(AtomicFileTest, LeavesTheOldFileWhenTheDiscIsFull) {
  const TemporaryFolder folder;
  const auto disc = folder / "disc";
  std::filesystem::create_directory(disc);
  if (::mount("tmpfs", disc.c_str(), "tmpfs", 0, "size=64k") != 0) GTEST_SKIP() << "may not mount a small disc";
  write_file_atomically(disc / "file", "old");
  const std::string message = message_of([&] { write_file_atomically(disc / "file", std::string(1 << 20, 'x')); });
  const std::string content = content_of(disc / "file");
  const auto files = std::distance(std::filesystem::directory_iterator(disc), {});
  ::umount(disc.c_str());
  EXPECT_THAT(message, AllOf(HasSubstr((disc / "file").string()), HasSubstr("No space left on device")));
  EXPECT_EQ(content, "old");
  EXPECT_EQ(files, 1);
}

}  // namespace
}  // namespace scrubjay
