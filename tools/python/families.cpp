#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "python/bindings.h"
#include "tagmint/codec/builtin_families.h"
#include "tagmint/codec/decoder.h"
#include "tagmint/codec/family_check.h"
#include "tagmint/codec/family_file.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/tag_cells.h"

namespace tagmint::python {
namespace {

using codec::Family;

codec::TagId checked_id(const Family& family, std::uint64_t id) {
  if (id < family.size()) return static_cast<codec::TagId>(id);
  throw py::index_error(family.name() + " has no id " + std::to_string(id) + "; it has " +
                        std::to_string(family.size()));
}

/// All codewords: the family's own where they are listed.
py::array codewords(const std::shared_ptr<Family>& family) {
  if (family->is_listed()) {
    return view_of(family->codewords().data(), {static_cast<py::ssize_t>(family->size())},
                   py::cast(family));
  }
  auto made = std::make_unique<std::vector<codec::Codeword>>();
  {
    const py::gil_scoped_release released;
    *made = codec::first_codewords(*family, family->size());
  }
  const auto* words = made.release();
  const py::capsule owner(
      words, [](void* held) { delete static_cast<std::vector<codec::Codeword>*>(held); });
  return view_of(words->data(), {static_cast<py::ssize_t>(words->size())}, owner);
}

py::array_t<std::uint8_t> cells(const Family& family, std::uint64_t id) {
  const auto picture = codec::tag_cells(family.layout(), family.codeword(checked_id(family, id)));
  py::array_t<std::uint8_t> pixels({picture.width(), picture.width()});
  auto out = pixels.mutable_unchecked<2>();
  for (int y = 0; y < picture.width(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const codec::Cell cell = picture.at(x, y);
      out(y, x) = cell == codec::Cell::Black ? 0 : cell == codec::Cell::White ? 255 : 127;
    }
  }
  return pixels;
}

std::vector<std::string> prove(const Family& family, int threads) {
  const py::gil_scoped_release released;
  codec::FamilyCheck check = codec::check_family(family, threads);
  if (check.violation) throw std::invalid_argument(check.violation->message);
  return check.proven;
}

std::shared_ptr<codec::Decoder> make_decoder(const std::shared_ptr<Family>& family,
                                             std::optional<int> max_errors,
                                             std::vector<codec::TagId> ids) {
  const py::gil_scoped_release released;
  return std::make_shared<codec::Decoder>(
      family, codec::DecoderOptions{.max_errors = max_errors, .ids = std::move(ids)});
}

std::optional<codec::Match> decode(const codec::Decoder& decoder, codec::Codeword word) {
  const int bits = decoder.family()->bits();
  if ((word & ~codec::low_mask(bits)) != 0) {
    throw std::invalid_argument("the word has more than the family's " + std::to_string(bits) +
                                " bits");
  }
  return decoder.decode(word);
}

}  // namespace

void add_families(py::module_& module) {
  py::class_<Family, std::shared_ptr<Family>>(module, "Family")
      .def_property_readonly("name", &Family::name)
      .def_property_readonly("bits", &Family::bits)
      .def_property_readonly("min_hamming", &Family::min_hamming)
      .def_property_readonly("max_safe_errors", &Family::max_safe_errors)
      .def_property_readonly("layout",
                             [](const Family& f) { return codec::layout_name(f.layout()); })
      .def_property_readonly("width", [](const Family& f) { return f.layout().width(); })
      .def_property_readonly("width_at_border",
                             [](const Family& f) { return f.layout().width_at_border(); })
      .def("__len__", &Family::size)
      .def("__repr__",
           [](const Family& f) {
             return "<tagmint.Family " + f.name() + ", " + std::to_string(f.size()) + " tags>";
           })
      .def(
          "codeword",
          [](const Family& f, std::uint64_t id) { return f.codeword(checked_id(f, id)); },
          py::arg("id"))
      .def("codewords", &codewords)
      .def("cells", &cells, py::arg("id"))
      .def("check", &prove, py::arg("threads") = 0)
      .def(
          "save", [](const Family& f, const std::string& path) { codec::write_family(f, path); },
          py::arg("path"));
  module.def("family_names", [] {
    const auto names = codec::family_names();
    return std::vector<std::string>(names.begin(), names.end());
  });
  module.def(
      "family",
      [](const std::string& name_or_path) {
        return std::const_pointer_cast<Family>(codec::load_family(name_or_path));
      },
      py::arg("name_or_path"));
  py::class_<codec::Match>(module, "Match")
      .def_readonly("id", &codec::Match::id)
      .def_readonly("hamming", &codec::Match::hamming)
      .def_readonly("rotation", &codec::Match::rotation);
  py::class_<codec::Decoder, std::shared_ptr<codec::Decoder>>(module, "Decoder")
      .def(py::init(&make_decoder), py::arg("family"), py::kw_only(),
           py::arg("max_errors") = py::none(), py::arg("ids") = std::vector<codec::TagId>{})
      .def_property_readonly("max_errors", &codec::Decoder::max_errors)
      .def("decode", &decode, py::arg("word"));
}

}  // namespace tagmint::python
