// C source that `tagmint convert` writes, compiled as it is against the installed libapriltag: its
// detector reads our printed sheet, and its drawing of each tag is ours.
#include <apriltag/apriltag.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <string>

#include "io/images.h"
#include "support/rasterise.h"
#include "support/scratch_folder.h"
#include "support/tagmint_program.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/tag_cells.h"
#include "tagmint/detect/detector.h"

namespace tagmint {
namespace {

/// A bundled family, or a new one in a layout.
struct Exported {
  const char* title;
  const char* family;  ///< of the bundled ones; "" = a new one:
  const char* layout = "";
  const char* min_hamming = "";
};

/// A family of libapriltag from a source file, through the functions NAME_create and NAME_destroy
/// of a shared library.
class CompiledFamily {
 public:
  /// `flags` of the compiler besides those that make all warnings errors.
  CompiledFamily(const std::string& source, const std::string& name, const std::string& flags) {
    const std::string library = source + ".so";
    test::output_of(TAGMINT_CC " -Wall -Wextra -Werror -shared -fPIC " + flags + " -o '" + library +
                    "' '" + source + "' 2>&1");
    library_ = dlopen(library.c_str(), RTLD_NOW);
    if (!library_) throw std::runtime_error(dlerror());
    using Create = apriltag_family_t* (*)();
    family_ = reinterpret_cast<Create>(function(name + "_create"))();
    destroy_ = reinterpret_cast<Destroy>(function(name + "_destroy"));
  }
  ~CompiledFamily() {
    destroy_(family_);
    dlclose(library_);
  }
  CompiledFamily(const CompiledFamily&) = delete;
  CompiledFamily& operator=(const CompiledFamily&) = delete;

  apriltag_family_t* get() const { return family_; }

 private:
  using Destroy = void (*)(apriltag_family_t*);

  void* function(const std::string& name) const {
    void* const found = dlsym(library_, name.c_str());
    if (!found) throw std::runtime_error(dlerror());
    return found;
  }

  void* library_ = nullptr;
  apriltag_family_t* family_ = nullptr;
  Destroy destroy_ = nullptr;
};

class ExportedC : public testing::TestWithParam<Exported> {
 protected:
  void SetUp() override {
    const Exported& exported = GetParam();
    name_ = exported.family;
    input_ = exported.family;
    if (name_.empty()) {
      name_ = "tagOwn";
      input_ = folder_.file("own.json");
      run({"generate", "--layout", exported.layout, "--min-hamming", exported.min_hamming,
           "--limit-codes", "24", "--name", name_, "-o", input_});
    }
    family_ = codec::load_family(input_);
    run({"convert", input_, "-o", source()});
  }

  std::string source() const { return folder_.file("exported.c"); }
  const codec::SharedFamily& family() const { return family_; }
  const std::string& name() const { return name_; }

  /// The sheet of the first 12 tags as the program prints it.
  detect::Image printed_sheet() {
    const std::string sheet = folder_.file("sheet.png");
    run({"sheet", input_, "--ids", "0-11", "--edge", "22mm", "--dpi", "150", "--no-ruler", "-o",
         sheet});
    return io::read_gray_image(sheet);
  }

  static void run(const std::vector<std::string>& words) {
    const test::ProgramResult result = test::tagmint(words);
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }

 private:
  const test::ScratchFolder folder_;
  std::string name_;
  std::string input_;
  codec::SharedFamily family_;
};

TEST_P(ExportedC, CompiledUnchangedItReadsOurPrintedSheet) {
  const CompiledFamily compiled(source(), name(), "");
  apriltag_detector_t* const theirs = apriltag_detector_create();
  apriltag_detector_add_family_bits(theirs, compiled.get(), 1);
  theirs->quad_decimate = 1.0f;
  detect::Image sheet = printed_sheet();
  image_u8_t picture = {sheet.width(), sheet.height(), sheet.width(), sheet.row(0)};
  zarray_t* const found = apriltag_detector_detect(theirs, &picture);

  detect::Detector ours({std::make_shared<const codec::Decoder>(family())});
  std::map<codec::TagId, detect::Corners> expected;
  for (const detect::Detection& tag : ours.detect(sheet)) expected[tag.id] = tag.corners;
  EXPECT_EQ(expected.size(), 12U);
  EXPECT_EQ(zarray_size(found), 12);
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* tag = nullptr;
    zarray_get(found, i, &tag);
    EXPECT_EQ(tag->hamming, 0);
    const auto place = expected.find(static_cast<codec::TagId>(tag->id));
    ASSERT_NE(place, expected.end()) << "only libapriltag sees id " << tag->id;
    for (int corner = 0; corner < 4; ++corner) {
      EXPECT_NEAR(tag->p[corner][0], place->second[corner].x, 0.5) << "id " << tag->id;
      EXPECT_NEAR(tag->p[corner][1], place->second[corner].y, 0.5) << "id " << tag->id;
    }
  }
  apriltag_detections_destroy(found);
  apriltag_detector_destroy(theirs);
}

TEST_P(ExportedC, LibapriltagDrawsEachTagAsWeDo) {
  const CompiledFamily compiled(source(), name(), "");
  ASSERT_EQ(compiled.get()->ncodes, family()->size());
  EXPECT_EQ(compiled.get()->h, static_cast<unsigned>(family()->min_hamming()));
  EXPECT_EQ(compiled.get()->name, name());
  const int width = family()->layout().width();
  for (codec::TagId id = 0; id < family()->size(); id += 1 + family()->size() / 500) {
    const codec::TagCells ours = codec::tag_cells(family()->layout(), family()->codeword(id));
    image_u8_t* const theirs = apriltag_to_image(compiled.get(), static_cast<int>(id));
    ASSERT_EQ(theirs->width, width);
    for (int y = 0; y < width; ++y) {
      for (int x = 0; x < width; ++x) {
        // What is no cell to us has no meaning to libapriltag.
        if (ours.at(x, y) == codec::Cell::None) continue;
        ASSERT_EQ(theirs->buf[y * theirs->stride + x] != 0, ours.at(x, y) == codec::Cell::White)
            << "id " << id << ", cell (" << x << ", " << y << ")";
      }
    }
    std::free(theirs->buf);  // image_u8_destroy() is in a library of its own on some systems
    std::free(theirs);
  }
}

TEST_P(ExportedC, CompilesBesideLibapriltagsOwnFilesAndAsCxx) {
  for (const char* flags : {"-I" TAGMINT_APRILTAG_HEADERS, "-x c++", "-std=c99 -D_GNU_SOURCE",
                            "-Wpedantic -Wstrict-prototypes -Wmissing-prototypes"}) {
    EXPECT_NO_THROW(CompiledFamily(source(), name(), flags)) << flags;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Layouts, ExportedC,
    testing::Values(
        Exported{"tag36h11", "tag36h11"}, Exported{"tagCircle49h12", "tagCircle49h12"},
        Exported{"tagCustom48h12", "tagCustom48h12"}, Exported{"OwnClassic", "", "classic:9", "9"},
        Exported{"OwnStandard", "", "standard:8", "9"}, Exported{"OwnCircle", "", "circle:9", "6"},
        // Reversed border, a hole in the middle and no corners.
        Exported{"OwnCustom", "",
                 "custom:xddddddx/dbbbbbbd/dbwwwwbd/dbwxxwbd/dbwxxwbd/dbwwwwbd/dbbbbbbd/xddddddx",
                 "6"},
        // Black on white with data outside of the border too.
        Exported{"OwnBlackOnWhite", "",
                 "custom:ddddddddd/dwwwwwwwd/dwbbbbbwd/dwbdddbwd/dwbdddbwd/dwbdddbwd/dwbbbbbwd/"
                 "dwwwwwwwd/ddddddddd",
                 "12"}),
    [](const auto& info) { return std::string(info.param.title); });

}  // namespace
}  // namespace tagmint
