#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/image/orientation.h"
#include "tests/photo/photo_writer.h"
#include "tests/ui/workstation/gl_screen.h"
#include "tests/ui/workstation/small_capture.h"

namespace bosk {
namespace {

constexpr int kWidth = 1000, kHeight = 700;

class StepPictures : public testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    try {
      screen = std::make_unique<GlScreen>(kWidth, kHeight);
    } catch (const Error& error) {
      GTEST_SKIP() << error.what();
    }
    hand =
        std::make_unique<Hand>(ImVec2(kWidth, kHeight), std::filesystem::path(), screen->screen());
  }
  // The photo with a note of how to turn it; its pixels stay as they are.
  void say_orientation(const std::string& name, int orientation) {
    const auto input = OIIO::ImageInput::open(capture.photo(name).string());
    ASSERT_TRUE(input);
    OIIO::ImageSpec spec = input->spec();
    std::vector<unsigned char> pixels(std::size_t(spec.image_bytes()));
    ASSERT_TRUE(input->read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, pixels.data()));
    input->close();
    spec.attribute("Orientation", orientation);
    spec.attribute("Compression", "jpeg:98");
    const auto output = OIIO::ImageOutput::create(capture.photo(name).string());
    ASSERT_TRUE(output);
    ASSERT_TRUE(output->open(capture.photo(name).string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) && output->close());
  }
  // Without the frame for each letter of its name.
  void open_empty_project(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    Project project;
    project.folder = folder;
    save_project(project);
    open_project(hand->workspace(), folder);
  }
  const Image<glm::u8vec4>& thumbnail(const std::string& name) {
    return *shelved(hand->workspace(), capture.photo(name))->thumbnail;
  }
  // Mean difference of the screen from a picture that lies there, over its middle three quarters:
  // its edges may be drawn over. 0 to 255.
  double difference(const Image<glm::u8vec4>& picture, const glm::dvec2& least,
                    const glm::dvec2& size) {
    const Image<glm::u8vec3> seen = screen->picture();
    double sum = 0.0;
    int count = 0;
    for (int y = picture.height() / 8; y < picture.height() * 7 / 8; ++y) {
      for (int x = picture.width() / 8; x < picture.width() * 7 / 8; ++x) {
        const glm::dvec2 share((x + 0.5) / picture.width(), (y + 0.5) / picture.height());
        const glm::ivec2 at(least + share * size);
        const glm::dvec3 away =
            glm::dvec3(seen(at.x, at.y)) - glm::dvec3(glm::u8vec3(picture(x, y)));
        sum += (std::abs(away.r) + std::abs(away.g) + std::abs(away.b)) / 3.0;
        ++count;
      }
    }
    return sum / count;
  }

  const SmallCapture capture;
  std::unique_ptr<GlScreen> screen;
  std::unique_ptr<Hand> hand;
};

// Measured: 0 in the large view, 2.4 in the view of cameras, whose pieces end between pixels;
// mirrored, the same pictures differ by 34 to 62.
constexpr double kSame = 8.0;

TEST_P(StepPictures, PhotosStandUprightInPhotosAndAsDeliveredBeforeTheirCameras) {
  say_orientation("002", GetParam());
  open_empty_project(capture.scratch / "oak");
  hand->drop({capture.photo("002"), capture.photo("005")});
  ASSERT_TRUE(hand->settle());
  hand->click("photos/tile/002");
  ASSERT_TRUE(hand->settle());
  const Image<glm::u8vec4> shown = thumbnail("002");
  const Landmark large = hand->at("photos/view");
  const ImagePlace place = place_of({}, {shown.width(), shown.height()}, large.least, large.most);
  const glm::dvec2 shown_size = place.size_px * place.scale;
  EXPECT_LT(difference(shown, place.origin, shown_size), kSame);
  EXPECT_GT(difference(upright(shown, 2), place.origin, shown_size), kSame);

  hand->drop({capture.cameras()});
  ASSERT_TRUE(hand->settle());
  hand->workspace().calibrate.through = "002";
  hand->frame(2);
  const Landmark view = hand->at("calibrate/view");
  const glm::dvec2 area(double(view.most.x - view.least.x), double(view.most.y - view.least.y));
  const glm::dvec2 size = std::min(area.x / 96.0, area.y / 128.0) * glm::dvec2(96, 128);
  const glm::dvec2 least =
      glm::dvec2(double(view.least.x), double(view.least.y)) + 0.5 * (area - size);
  // Turned back: what is shown is upright, and the camera sees what the sensor delivered
  const Image<glm::u8vec4> delivered = upright(shown, GetParam() == 6 ? 8 : 1);
  EXPECT_LT(difference(delivered, least, size), kSame);
  EXPECT_GT(difference(upright(delivered, 2), least, size), kSame);
}

INSTANTIATE_TEST_SUITE_P(Orientations, StepPictures, testing::Values(1, 6));

}  // namespace
}  // namespace bosk
