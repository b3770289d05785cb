#include <gmock/gmock.h>

#include "bag_content.hpp"
#include "temporary_folder.hpp"

namespace scrubjay {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void write_bag(const std::filesystem::path& path, bool zstd = false) {
  const std::unique_ptr<BagWriter> writer = make_bag_writer(path, zstd);
  writer->add(kScanTopic);
  writer->write(0, 5, bytes_of("scan"));
  writer->close();
}

TEST(BagTest, IsWrittenInTheFormatThatItsNameAsksFor) {
  const TemporaryFolder folder;
  for (const std::string name : {"run.mcap", "run"}) {
    write_bag(folder / name);
    EXPECT_THAT(content_of_bag(folder / name).messages, ElementsAre("/scan 5 scan"));
  }
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "run.mcap"));
  EXPECT_TRUE(std::filesystem::is_regular_file(folder / "run/run_0.db3"));
}

TEST(BagTest, IsReadByWhatItHolds) {
  const TemporaryFolder folder;
  write_bag(folder / "run.mcap");
  write_bag(folder / "run");
  std::filesystem::rename(folder / "run.mcap", folder / "misnamed.db3");
  std::filesystem::rename(folder / "run/run_0.db3", folder / "misnamed.mcap");
  EXPECT_THAT(content_of_bag(folder / "misnamed.db3").messages, ElementsAre("/scan 5 scan"));
  EXPECT_THAT(content_of_bag(folder / "misnamed.mcap").messages, ElementsAre("/scan 5 scan"));
}

TEST(BagTest, IsPackedOnlyWhereTheFormatCanBe) {
  const TemporaryFolder folder;
  write_bag(folder / "run.mcap", true);
  EXPECT_THAT(content_of_bag(folder / "run.mcap").messages, ElementsAre("/scan 5 scan"));
  EXPECT_THAT(message_of([&] { write_bag(folder / "run", true); }),
              HasSubstr("run: a database can't be packed; want a name that ends in .mcap"));
  EXPECT_FALSE(std::filesystem::exists(folder / "run"));
}

}  // namespace
}  // namespace scrubjay
