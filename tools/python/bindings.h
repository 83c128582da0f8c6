#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <vector>

namespace tagmint::python {

namespace py = pybind11;

/// What module.cpp calls, in this order: each adds its part of the module.
void add_families(py::module_& module);
void add_detection(py::module_& module);
void add_generate(py::module_& module);
void add_sheet(py::module_& module);

/// A read-only array that looks at `data`, which lives as long as `owner`.
template <typename T>
py::array view_of(const T* data, std::vector<py::ssize_t> shape, py::handle owner) {
  py::array view(py::dtype::of<T>(), std::move(shape), data, owner);
  py::detail::array_proxy(view.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return view;
}

}  // namespace tagmint::python
