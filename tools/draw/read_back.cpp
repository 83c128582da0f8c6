#include "draw/read_back.h"

#include <stdexcept>

#include "draw/read_back_kinds.h"
#include "draw/units.h"
#include "io/images.h"
#include "tagmint/codec/errors.h"

namespace tagmint::draw {
namespace {

class WrittenPicture final : public WrittenFile {
 public:
  WrittenPicture(const std::filesystem::path& path, double dpi)
      : picture_(io::read_gray_image(path.string())), pixels_a_mm_(dpi / kMmAnInch) {}
  ReadPage page(std::size_t, double) const override { return {picture_, pixels_a_mm_}; }

 private:
  detect::Image picture_;
  double pixels_a_mm_;
};

}  // namespace

bool can_read_back(FileKind kind) {
  switch (kind) {
    case FileKind::Pdf:
      return kReadsPdf;
    case FileKind::Svg:
      return kReadsSvg;
    case FileKind::Png:
    case FileKind::Tiff:
      return true;
    case FileKind::Ps:
    case FileKind::Eps:
    case FileKind::Dxf:
      return false;
  }
  return false;
}

std::unique_ptr<WrittenFile> open_written(const std::filesystem::path& path, FileKind kind,
                                          double raster_dpi) {
  if (!can_read_back(kind)) throw std::invalid_argument("this kind of file cannot be read back");
  if (kind == FileKind::Pdf) return open_written_pdf(path);
  if (kind == FileKind::Svg) return open_written_svg(path);
  try {
    return std::make_unique<WrittenPicture>(path, raster_dpi);
  } catch (const codec::InputError& fault) {
    throw codec::OutputError(fault.what(), "", "");
  }
}

}  // namespace tagmint::draw
