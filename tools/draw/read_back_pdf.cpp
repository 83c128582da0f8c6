#include "draw/read_back_kinds.h"

#ifdef TAGMINT_HAVE_POPPLER
#include <poppler.h>

#include "draw/units.h"
#else
#include <stdexcept>
#endif

namespace tagmint::draw {

#ifdef TAGMINT_HAVE_POPPLER
namespace {

struct Unreference {
  void operator()(gpointer object) const { g_object_unref(object); }
};
struct FreeError {
  void operator()(GError* error) const { g_error_free(error); }
};

/// Draws pages with Poppler.
class WrittenPdf final : public WrittenFile {
 public:
  explicit WrittenPdf(const std::filesystem::path& path) : path_(path) {
    GError* error = nullptr;
    const std::unique_ptr<GFile, Unreference> file(g_file_new_for_path(path.c_str()));
    document_.reset(poppler_document_new_from_gfile(file.get(), nullptr, nullptr, &error));
    const std::unique_ptr<GError, FreeError> owner(error);
    if (!document_) fail_to_read_back(path, error ? error->message : "unknown fault");
  }
  ReadPage page(std::size_t index, double dpi) const override {
    const std::unique_ptr<PopplerPage, Unreference> page(
        poppler_document_get_page(document_.get(), static_cast<int>(index)));
    if (!page) fail_to_read_back(path_, "a page is missing");
    double width_pt = 0;
    double height_pt = 0;
    poppler_page_get_size(page.get(), &width_pt, &height_pt);
    const double scale = dpi / kPointsAnInch;
    detect::Image picture = drawn_page(width_pt * scale, height_pt * scale, [&](cairo_t* context) {
      cairo_scale(context, scale, scale);
      poppler_page_render(page.get(), context);
    });
    return {std::move(picture), dpi / kMmAnInch};
  }

 private:
  std::filesystem::path path_;
  std::unique_ptr<PopplerDocument, Unreference> document_;
};

}  // namespace

std::unique_ptr<WrittenFile> open_written_pdf(const std::filesystem::path& path) {
  return std::make_unique<WrittenPdf>(path);
}
#else
std::unique_ptr<WrittenFile> open_written_pdf(const std::filesystem::path&) {
  throw std::invalid_argument("this build cannot read PDF files");
}
#endif

}  // namespace tagmint::draw
