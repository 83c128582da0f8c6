#pragma once

#include <cstddef>
#include <functional>

#include "draw/file_canvas.h"
#include "poster/poster_plan.h"

namespace tagmint::poster {

/// Writes a poster as one file: the map, then its pages row by row.
///   kind      one that holds several pages, draw::holds_pages()
///   on_page   called after each page with the number of pages done
/// Throws codec::OutputError where it cannot be drawn, and what the sink throws.
void write_poster(const PosterPlan& plan, draw::FileKind kind, const draw::FileOptions& options,
                  draw::ByteSink sink, const std::function<void(std::size_t done)>& on_page = {});

}  // namespace tagmint::poster
