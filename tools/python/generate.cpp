#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>

#include "python/bindings.h"
#include "tagmint/codec/layout_presets.h"
#include "tagmint/codec/search/lexicode.h"
#include "tagmint/codec/search/rotation_codes.h"

namespace tagmint::python {
namespace {

/// Runs a search without the interpreter's lock; Ctrl-C stops it and becomes KeyboardInterrupt.
///   search   called with a stop token and a function to call from time to time
template <typename Search>
auto interruptible(Search search) {
  std::stop_source stop;
  bool interrupted = false;
  const auto look = [&](const auto&) {
    const py::gil_scoped_acquire held;
    if (interrupted || PyErr_CheckSignals() == 0) return;
    PyErr_Clear();
    interrupted = true;
    stop.request_stop();
  };
  auto result = [&] {
    const py::gil_scoped_release released;
    return search(stop.get_token(), look);
  }();
  if (interrupted) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
  return result;
}

std::shared_ptr<codec::Family> generate(const std::string& layout, int min_hamming,
                                        const std::string& order, const std::string& complexity,
                                        const std::string& name,
                                        std::optional<std::size_t> limit_codes, int threads) {
  codec::LexicodeOptions options{.layout = codec::parse_layout(layout),
                                 .min_hamming = min_hamming,
                                 .order = codec::parse_order(order),
                                 .complexity = codec::parse_complexity(complexity),
                                 .limit_codes = limit_codes,
                                 .threads = threads};
  const codec::LexicodeResult result = interruptible([&](std::stop_token stop, const auto& look) {
    options.stop = stop;
    options.progress = look;
    return codec::search_lexicode(options);
  });
  return std::make_shared<codec::Family>(codec::make_family(options, result, name));
}

std::shared_ptr<codec::Family> generate_rotation_code(const std::string& layout, int min_hamming,
                                                      const std::string& complexity,
                                                      const std::string& name, std::uint64_t seed,
                                                      int attempts, int threads) {
  codec::RotationCodeOptions options{.layout = codec::parse_layout(layout),
                                     .min_hamming = min_hamming,
                                     .complexity = codec::parse_complexity(complexity),
                                     .seed = seed,
                                     .attempts = attempts,
                                     .threads = threads};
  codec::RotationCodeResult result = interruptible([&](std::stop_token stop, const auto& look) {
    options.stop = stop;
    options.progress = look;
    return codec::search_rotation_code(options);
  });
  if (!result.found()) throw std::invalid_argument("no code of that distance was found");
  return std::make_shared<codec::Family>(codec::make_family(std::move(result), name));
}

}  // namespace

void add_generate(py::module_& module) {
  module.def("generate", &generate, py::arg("layout"), py::arg("min_hamming"), py::kw_only(),
             py::arg("order") = "apriltag3", py::arg("complexity") = "energy:0.3333",
             py::arg("name") = "", py::arg("limit_codes") = py::none(), py::arg("threads") = 0);
  module.def("generate_rotation_code", &generate_rotation_code, py::arg("layout"),
             py::arg("min_hamming"), py::kw_only(), py::arg("complexity") = "energy:0.3333",
             py::arg("name") = "", py::arg("seed") = 0, py::arg("attempts") = 1,
             py::arg("threads") = 0);
}

}  // namespace tagmint::python
