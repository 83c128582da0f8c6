#include <filesystem>
#include <string>
#include <utility>

#include "draw/sheet_writer.h"
#include "python/bindings.h"
#include "tagmint/codec/atomic_file.h"

namespace tagmint::python {
namespace {

/// Writes `ids` of a family (empty = all) to one file, whose kind is its extension's; returns the
/// number of pages.
std::size_t sheet(std::shared_ptr<codec::Family> family, const std::string& path, double edge_mm,
                  std::vector<codec::TagId> ids, std::pair<double, double> paper_mm,
                  double margin_mm, double gap_mm, const std::string& title,
                  const std::string& label, bool cut_marks, double dpi) {
  const py::gil_scoped_release released;
  if (!family) throw std::invalid_argument("a sheet needs a family");
  const std::string extension = std::filesystem::path(path).extension().string();
  const auto kind = draw::file_kind_of(extension.empty() ? "" : extension.substr(1));
  if (!kind) throw std::invalid_argument("no kind of sheet has the extension '" + extension + "'");
  if (ids.empty()) {
    for (codec::TagId id = 0; id < family->size(); ++id) ids.push_back(id);
  }
  const std::string name = family->name();
  const std::vector<draw::TagGroup> groups = {{std::move(family), edge_mm, std::move(ids)}};
  draw::SheetDecor decor;
  decor.title = title;
  decor.cut_marks = cut_marks;
  if (!label.empty()) decor.label = draw::TextFormat(label, draw::label_fields());
  draw::SheetOptions page;
  page.page_width_mm = paper_mm.first;
  page.page_height_mm = paper_mm.second;
  page.margin_mm = margin_mm;
  page.gap_mm = gap_mm;
  page.label_mm = draw::label_height_mm(decor, groups);
  page.header_mm = draw::header_height_mm(decor);
  page.footer_mm = draw::footer_height_mm(decor, groups.size());
  const draw::SheetPlan plan = draw::plan_sheet(groups, page);
  if (plan.pages.size() > 1 && !draw::holds_pages(*kind)) {
    throw std::invalid_argument("the tags take " + std::to_string(plan.pages.size()) +
                                " pages, and such a file holds one; write a PDF");
  }
  draw::FileOptions options;
  options.title = title.empty() ? name : title;
  options.dpi = dpi;
  codec::AtomicFile file(path);
  draw::write_sheet(plan, decor, 0, plan.pages.size(), *kind, options,
                    [&](std::string_view bytes) { file.write(bytes); });
  file.publish();
  return plan.pages.size();
}

}  // namespace

void add_sheet(py::module_& module) {
  py::register_exception<draw::DoesNotFit>(module, "DoesNotFit", PyExc_ValueError);
  module.def("sheet", &sheet, py::arg("family"), py::arg("path"), py::kw_only(), py::arg("edge_mm"),
             py::arg("ids") = std::vector<codec::TagId>{},
             py::arg("paper_mm") = std::pair(210.0, 297.0), py::arg("margin_mm") = 10.0,
             py::arg("gap_mm") = 5.0, py::arg("title") = "", py::arg("label") = "{family}  {id}",
             py::arg("cut_marks") = false, py::arg("dpi") = 300.0);
}

}  // namespace tagmint::python
