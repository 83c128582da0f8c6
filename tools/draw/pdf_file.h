#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "draw/canvas.h"

namespace tagmint::draw {

/// Writes the objects of a PDF file as they come, and their places at the end; holds nothing of
/// them but twenty bytes each.
///   source   ISO 32000-1:2008, 7.5 (file structure)
class PdfFile {
 public:
  /// Starts the file.
  explicit PdfFile(ByteSink sink);

  /// A number for an object that is written later.
  int reserve();
  /// Writes the object of a reserved number.
  void write(int number, std::string_view body);
  /// Writes a stream, deflated; `entries` are those of its dictionary besides length and filter.
  void write_stream(int number, std::string_view entries, std::string_view content);
  /// Writes a new object; returns its number.
  int add(std::string_view body);
  int add_stream(std::string_view entries, std::string_view content);
  /// Ends the file. Every reserved number must have been written.
  ///   catalog, info   numbers of these objects
  void finish(int catalog, int info);

 private:
  void put(std::string_view bytes);

  ByteSink sink_;
  std::uint64_t size_ = 0;                // bytes so far
  std::vector<std::uint64_t> places_{0};  // by number; 0 = not written
};

/// A text string (ISO 32000-1, 7.9.2.2) of a UTF-8 text, with its delimiters. Throws
/// std::invalid_argument when it is not UTF-8.
std::string pdf_text(std::string_view utf8);

/// "12 0 R"
std::string pdf_reference(int number);

}  // namespace tagmint::draw
