#pragma once

#include <cstddef>
#include <iterator>

namespace tagmint::codec {

/// Where the parser is: the line of the last character that it took. A number ends only at the
/// character after it; where that is a line break, it still belongs to the number's line.
struct LineCount {
  int line = 1;
  bool break_taken = false;

  void take(char c) {
    line += break_taken;
    break_taken = c == '\n';
  }
};

/// An input iterator over the text that keeps a LineCount up to date.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, LineCount* count) : at_(at), count_(count) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    count_->take(*at_++);
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const CountingIterator& a, const CountingIterator& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  LineCount* count_;
};

}  // namespace tagmint::codec
