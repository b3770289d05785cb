#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <io/temporary_folder.hpp>
#include <scrubjay/error.hpp>
#include <scrubjay/io/image.hpp>

namespace scrubjay {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::filesystem::path kImages = std::filesystem::path(SCRUBJAY_SOURCE_DIR) / "test/data/images";

Image decode(const std::string& file) {
  return decode_image({reinterpret_cast<const std::uint8_t*>(file.data()), file.size()}, "test.pgm");
}

std::string image_error(const std::string& file) {
  return message_of([&] { decode(file); });
}

TEST(ImageTest, ReadsPlainPgmWithComments) {
  EXPECT_EQ(read_image(kImages / "plain.pgm"), (Image{2, 2, 1, {0, 254, 205, 100}}));
}

TEST(ImageTest, ReadsBinaryPgm) {
  EXPECT_EQ(decode("P5 3 1 255\n\n #"), (Image{3, 1, 1, {'\n', ' ', '#'}}))
      << "pixels may look like blanks and comments";
}

TEST(ImageTest, ReadsBinaryPgmOf16BitsHighByteFirst) {
  EXPECT_EQ(decode(std::string("P5 3 1 65535\n\x00\x00\x80\x00\xff\xff", 19)), (Image{3, 1, 1, {0, 128, 255}}));
}

TEST(ImageTest, ScalesOtherMaximaToTheWholeRange) {
  EXPECT_EQ(decode("P2 4 1 100\n0 20 50 100\n"), (Image{4, 1, 1, {0, 51, 128, 255}}));
  EXPECT_EQ(decode("P2 3 1 65535 0 257 65535"), (Image{3, 1, 1, {0, 1, 255}}));
}

TEST(ImageTest, TellsFormatsApartByContentNotByName) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_image(folder.write("map.png", "P2 1 1 255 7")), (Image{1, 1, 1, {7}}));
  EXPECT_EQ(image_error("GIF89a"), "test.pgm: neither a PGM nor a PNG image");
  EXPECT_EQ(image_error(""), "test.pgm: neither a PGM nor a PNG image");
}

struct BrokenPgm {
  std::string file;
  std::string complaint;
};

class BrokenPgmTest : public testing::TestWithParam<BrokenPgm> {};

TEST_P(BrokenPgmTest, IsRefusedWithItsReason) {
  EXPECT_THAT(image_error(GetParam().file),
              AllOf(HasSubstr("test.pgm: "), HasSubstr(GetParam().complaint), Not(HasSubstr("\n"))));
}

INSTANTIATE_TEST_SUITE_P(
    Pgm, BrokenPgmTest,
    testing::Values(
        BrokenPgm{"P5", "width does not stand apart"}, BrokenPgm{"P5 ", "ends before width"},
        BrokenPgm{"P52 2 255\n1234", "width does not stand apart"}, BrokenPgm{"P5 -2 2 255\n", "width is not a number"},
        BrokenPgm{"P5 2 2 255", "no blank"}, BrokenPgm{"P5 2 2 255\n123", "has 3 bytes of pixels, wants 4"},
        BrokenPgm{"P5 2 2 255\n", "has 0 bytes of pixels"}, BrokenPgm{"P5 2 2 300\n1234567", "has 7 bytes"},
        BrokenPgm{"P5 0 2 255\n", "0 x 2 pixels"}, BrokenPgm{"P5 2 0 255\n", "2 x 0 pixels"},
        BrokenPgm{"P5 2 2 0\n1234", "maximum is 0"}, BrokenPgm{"P5 2 2 65536\n12345678", "maximum is over 65535"},
        BrokenPgm{"P5 4294967297 1 255\n1", "width is over"},
        BrokenPgm{"P5 18446744073709551617 1 255\n1", "width is over"},
        BrokenPgm{"P5 65536 65536 255\n1", "65536 x 65536 pixels"},
        BrokenPgm{"P2 9000 7000 255\n1 2 3", "too short for 63000000 pixels"},
        BrokenPgm{"P2 2 1 255 1 256", "pixel is over 255"}, BrokenPgm{"P2 2 1 255 1 x", "pixel is not a number"},
        BrokenPgm{"P2 2 1 255 1 # 2 ", "ends before pixel"}, BrokenPgm{"P5 1 1 100\nz", "pixel 0 is 122"}));

TEST(ImageTest, ReadsEveryKindOfPng) {
  const std::vector<std::uint8_t> pixels{0, 254, 205, 100};
  EXPECT_EQ(read_image(kImages / "grey8.png"), (Image{2, 2, 1, pixels}));
  EXPECT_EQ(read_image(kImages / "grey16.png"), (Image{2, 2, 1, pixels})) << "rounded, not cut";
  EXPECT_EQ(read_image(kImages / "grey1.png"), (Image{2, 2, 1, {0, 255, 255, 0}}));
  EXPECT_EQ(read_image(kImages / "grey_gamma.png"), (Image{2, 2, 1, pixels})) << "gamma says nothing about maps";
  EXPECT_EQ(to_grey(read_image(kImages / "indexed8.png")), (Image{2, 2, 1, pixels}));
  EXPECT_EQ(to_grey(read_image(kImages / "indexed2.png")), (Image{2, 2, 1, pixels}));
  EXPECT_EQ(to_grey(read_image(kImages / "indexed_transparent.png")),
            (Image{2, 2, 2, {0, 255, 254, 255, 205, 0, 100, 255}}));
  EXPECT_EQ(read_image(kImages / "grey_alpha.png"), (Image{2, 2, 2, {0, 255, 254, 255, 205, 0, 100, 128}}));
  EXPECT_EQ(to_grey(read_image(kImages / "rgb.png")), (Image{2, 2, 1, {0, 254, 205, 76}}));
  EXPECT_EQ(to_grey(read_image(kImages / "rgba.png")), (Image{2, 2, 2, {0, 255, 254, 255, 205, 7, 100, 255}}));
}

TEST(ImageTest, RefusesAPngThatWasCutAnywhere) {
  const std::string whole = content_of(kImages / "indexed8.png");
  constexpr std::size_t kEndChunk = 12;  // without its last chunk a PNG is broken as well
  for (std::size_t size = 8; size < whole.size(); ++size) {
    EXPECT_THAT(image_error(whole.substr(0, size)), HasSubstr("test.pgm: broken PNG: ")) << size;
  }
  EXPECT_NE(image_error(whole.substr(0, whole.size() - kEndChunk)), "");
}

TEST(ImageTest, RefusesAPngThatClaimsAllMemory) {
  std::string huge = content_of(kImages / "grey8.png");
  huge.replace(16, 8, std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff", 8));
  EXPECT_NE(image_error(huge), "");
}

TEST(ImageTest, LeavesGreyExactlyAsItIs) {
  Image grey{256, 1, 3, {}};
  for (int v = 0; v < 256; ++v) grey.pixels.insert(grey.pixels.end(), 3, static_cast<std::uint8_t>(v));
  const Image result = to_grey(grey);
  ASSERT_EQ(result.channels, 1);
  for (std::size_t v = 0; v < 256; ++v) EXPECT_EQ(result.pixels[v], v);
}

TEST(ImageTest, WritesPgmByTheByte) {
  EXPECT_THAT(encode_pgm({2, 1, 1, {0, 254}}),
              ElementsAre('P', '5', '\n', '2', ' ', '1', '\n', '2', '5', '5', '\n', 0, 254));
}

TEST(ImageTest, ReadsBackWhatItWrote) {
  for (const int channels : {1, 2, 3, 4}) {
    Image image{5, 3, channels, {}};
    for (std::size_t i = 0; i < image.row_bytes() * 3; ++i)
      image.pixels.push_back(static_cast<std::uint8_t>(i * 37 + 11));
    EXPECT_EQ(decode_image(encode_png(image), "png"), image) << channels;
    if (channels == 1) {
      EXPECT_EQ(decode_image(encode_pgm(image), "pgm"), image);
    }
  }
}

TEST(ImageTest, WritesTheSameBytesAgainAndNoTime) {
  const Image image{2, 2, 1, {0, 254, 205, 100}};
  const std::vector<std::uint8_t> file = encode_png(image);
  EXPECT_EQ(encode_png(image), file);
  const std::string text(file.begin(), file.end());
  EXPECT_EQ(text.find("tIME"), std::string::npos);
  EXPECT_EQ(text.find("tEXt"), std::string::npos);
}

TEST(ImageTest, TellsWhichFileIsMissing) {
  EXPECT_THAT(message_of([] { read_image("no/such/map.pgm"); }),
              AllOf(HasSubstr("no/such/map.pgm"), HasSubstr("No such file or directory")));
  EXPECT_THAT(message_of([] { read_image(kImages); }), HasSubstr("Is a directory"));
}

}  // namespace
}  // namespace scrubjay
