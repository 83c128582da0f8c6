#include "draw/read_back_kinds.h"

#ifdef TAGMINT_HAVE_RSVG
#include <librsvg/rsvg.h>

#include "draw/units.h"
#else
#include <stdexcept>
#endif

namespace tagmint::draw {

#ifdef TAGMINT_HAVE_RSVG
namespace {

struct Unreference {
  void operator()(gpointer object) const { g_object_unref(object); }
};
struct FreeError {
  void operator()(GError* error) const { g_error_free(error); }
};

/// Draws the page with librsvg.
class WrittenSvg final : public WrittenFile {
 public:
  explicit WrittenSvg(const std::filesystem::path& path) : path_(path) {
    GError* error = nullptr;
    const std::unique_ptr<GFile, Unreference> file(g_file_new_for_path(path.c_str()));
    handle_.reset(
        rsvg_handle_new_from_gfile_sync(file.get(), RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
    const std::unique_ptr<GError, FreeError> owner(error);
    if (!handle_) fail_to_read_back(path, error ? error->message : "unknown fault");
  }
  ReadPage page(std::size_t, double dpi) const override {
    rsvg_handle_set_dpi(handle_.get(), dpi);
    double width = 0;
    double height = 0;
    if (!rsvg_handle_get_intrinsic_size_in_pixels(handle_.get(), &width, &height)) {
      fail_to_read_back(path_, "it has no size");
    }
    detect::Image picture = drawn_page(width, height, [&](cairo_t* context) {
      const RsvgRectangle all = {0, 0, width, height};
      GError* error = nullptr;
      const bool drawn = rsvg_handle_render_document(handle_.get(), context, &all, &error);
      const std::unique_ptr<GError, FreeError> owner(error);
      if (!drawn) fail_to_read_back(path_, error ? error->message : "unknown fault");
    });
    return {std::move(picture), dpi / kMmAnInch};
  }

 private:
  std::filesystem::path path_;
  std::unique_ptr<RsvgHandle, Unreference> handle_;
};

}  // namespace

std::unique_ptr<WrittenFile> open_written_svg(const std::filesystem::path& path) {
  return std::make_unique<WrittenSvg>(path);
}
#else
std::unique_ptr<WrittenFile> open_written_svg(const std::filesystem::path&) {
  throw std::invalid_argument("this build cannot read SVG files");
}
#endif

}  // namespace tagmint::draw
