#include "draw/pdf_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cassert>
#include <new>

#include "draw/utf8.h"

namespace tagmint::draw {
namespace {

std::string deflated(std::string_view content) {
  std::string packed(compressBound(static_cast<uLong>(content.size())), '\0');
  uLongf length = static_cast<uLongf>(packed.size());
  const int status = compress2(reinterpret_cast<Bytef*>(packed.data()), &length,
                               reinterpret_cast<const Bytef*>(content.data()),
                               static_cast<uLong>(content.size()), Z_DEFAULT_COMPRESSION);
  if (status != Z_OK) throw std::bad_alloc();  // the only fault with room for the bound
  packed.resize(length);
  return packed;
}

}  // namespace

PdfFile::PdfFile(ByteSink sink) : sink_(std::move(sink)) {
  // Four bytes above 127 tell transfer programs that the file is binary.
  put("%PDF-1.7\n%\xe2\xe3\xcf\xd3\n");
}

void PdfFile::put(std::string_view bytes) {
  sink_(bytes);
  size_ += bytes.size();
}

int PdfFile::reserve() {
  places_.push_back(0);
  return static_cast<int>(places_.size()) - 1;
}

void PdfFile::write(int number, std::string_view body) {
  std::uint64_t& place = places_[static_cast<std::size_t>(number)];
  assert(place == 0);
  place = size_;
  put(fmt::format("{} 0 obj\n{}\nendobj\n", number, body));
}

void PdfFile::write_stream(int number, std::string_view entries, std::string_view content) {
  const std::string packed = deflated(content);
  std::string body =
      fmt::format("<<{}/Filter/FlateDecode/Length {}>>\nstream\n", entries, packed.size());
  body += packed;
  body += "\nendstream";
  write(number, body);
}

int PdfFile::add(std::string_view body) {
  const int number = reserve();
  write(number, body);
  return number;
}

int PdfFile::add_stream(std::string_view entries, std::string_view content) {
  const int number = reserve();
  write_stream(number, entries, content);
  return number;
}

void PdfFile::finish(int catalog, int info) {
  const std::uint64_t table = size_;
  put(fmt::format("xref\n0 {}\n0000000000 65535 f \n", places_.size()));
  for (std::size_t number = 1; number < places_.size(); ++number) {
    assert(places_[number] != 0);
    put(fmt::format("{:010} 00000 n \n", places_[number]));
  }
  put(fmt::format("trailer\n<</Size {}/Root {}/Info {}>>\nstartxref\n{}\n%%EOF\n", places_.size(),
                  pdf_reference(catalog), pdf_reference(info), table));
}

std::string pdf_text(std::string_view utf8) {
  std::string text = "<FEFF";  // UTF-16, big-endian, in hexadecimal
  for (const char32_t character : characters_of(utf8)) {
    if (character < 0x10000) {
      text += fmt::format("{:04X}", static_cast<std::uint32_t>(character));
    } else {
      const std::uint32_t above = character - 0x10000;
      text += fmt::format("{:04X}{:04X}", 0xd800 + (above >> 10), 0xdc00 + (above & 0x3ff));
    }
  }
  return text + ">";
}

std::string pdf_reference(int number) { return fmt::format("{} 0 R", number); }

}  // namespace tagmint::draw
