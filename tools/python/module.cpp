#include <string>

#include "python/bindings.h"
#include "tagmint/codec/errors.h"
#include "tagmint/codec/version.h"

PYBIND11_MODULE(_core, module) {
  namespace python = tagmint::python;
  pybind11::register_exception<tagmint::codec::InputError>(module, "InputError", PyExc_ValueError);
  pybind11::register_exception<tagmint::codec::OutputError>(module, "OutputError", PyExc_OSError);
  module.attr("__version__") = std::string(tagmint::codec::kVersion);
  python::add_families(module);
  python::add_detection(module);
  python::add_generate(module);
  python::add_sheet(module);
}
