#pragma once

#include <string>
#include <string_view>

namespace tagmint::io {

/// Whether the bytes begin as a gzip file does.
bool is_gzip(std::string_view bytes);

/// The content of a gzip file of one or more members.
///   source   name used in messages
/// Throws codec::InputError: damaged, cut short, or more than 2 GiB unpacked.
std::string gunzip(std::string_view bytes, const std::string& source);

/// The content as a gzip file without name and time: equal contents give equal files.
std::string gzip(std::string_view content);

}  // namespace tagmint::io
