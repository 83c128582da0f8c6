#include <fmt/format.h>

#include <cmath>

#include "cli/identify_report.h"
#include "cli/identify_words.h"

namespace tagmint::cli {
namespace {

using identify::BorderPart;
using identify::Candidate;

std::string name_of(const Candidate& candidate) {
  return fmt::format("{} id {}", candidate.family->name(), candidate.id);
}

std::string turn_text(double degrees) {
  return degrees == 0 ? "upright" : fmt::format("turned clockwise by {:g} degrees", degrees);
}

/// "mirrored, then turned clockwise by 90 degrees; inverted".
std::string state_text(const Candidate& candidate) {
  std::string text = turn_text(candidate.turned_deg);
  if (candidate.mirrored) {
    text = candidate.turned_deg == 0 ? "mirrored left to right"
                                     : "mirrored left to right, then " + text;
  }
  if (candidate.inverted) text += "; inverted: black and white are exchanged";
  return text;
}

std::string border_text(const Candidate& candidate) {
  switch (candidate.border) {
    case BorderPart::Whole:
      return candidate.quiet_zone ? "whole" : "whole, but no quiet zone around it";
    case BorderPart::Cut:
      return "cut: cells outside the border square are missing";
    case BorderPart::None:
      break;
  }
  return "missing: only what is inside of it is in the picture";
}

std::string accidents_text(double expected) {
  if (expected < 1e-12) return "less than 1e-12 such matches expected by accident";
  return fmt::format("{:.1g} such matches expected by accident", expected);
}

std::string candidate_lines(const Candidate& candidate) {
  std::string text = fmt::format("  {:<12}{}\n", "picture", state_text(candidate));
  text += fmt::format("  {:<12}{}\n", "border", border_text(candidate));
  text +=
      fmt::format("  {:<12}{} of {} cells\n", "wrong", candidate.hamming, candidate.family->bits());
  text += fmt::format("  {:<12}{}\n", "certainty", accidents_text(candidate.expected_accidents));
  if (const auto known = opencv_name(candidate)) {
    text += fmt::format("  {:<12}{} id {}, {}\n", "OpenCV 4", known->dictionary, candidate.id,
                        turn_text(known->turned_deg));
  }
  return text;
}

/// A further candidate in one line: only what differs from the first one.
std::string also_line(const Candidate& candidate, const Candidate& first) {
  std::string text = fmt::format("  {:<12}{}", "also", name_of(candidate));
  if (state_text(candidate) != state_text(first)) text += ", " + state_text(candidate);
  if (candidate.hamming != first.hamming) {
    text += fmt::format(", {} of {} cells wrong", candidate.hamming, candidate.family->bits());
  }
  return text + '\n';
}

std::string tag_text(const identify::TagInPicture& tag, bool with_place) {
  const Candidate& first = tag.front();
  std::string text = name_of(first);
  if (with_place) {
    const auto& c = first.corners;
    const detect::Point middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
    text += fmt::format(" at ({:.0f}, {:.0f}), {:.0f} px wide", middle.x, middle.y,
                        std::sqrt(std::abs(detect::signed_area(c))));
  }
  text += '\n' + candidate_lines(first);
  for (std::size_t i = 1; i < tag.size(); ++i) text += also_line(tag[i], first);
  return text;
}

std::string nothing_text(const identify::Identification& found) {
  if (!found.nearest) return "no tag; nothing in it has cells and a border like one\n";
  const Candidate& nearest = *found.nearest;
  return fmt::format(
      "no tag that could not be an accident\nnearest: {}, {} of {} cells differ; {}\n",
      name_of(nearest), nearest.hamming, nearest.family->bits(),
      accidents_text(nearest.expected_accidents));
}

}  // namespace

std::string identify_text(const IdentifyReport& report) {
  std::string text = fmt::format("{}: {} x {} px, ", report.image, report.width, report.height);
  const auto& tags = report.found.tags;
  if (tags.empty()) return text + nothing_text(report.found);
  text += tags.size() == 1 ? "one tag\n" : fmt::format("{} tags, the largest first\n", tags.size());
  for (const identify::TagInPicture& tag : tags) text += tag_text(tag, tags.size() > 1);
  return text;
}

}  // namespace tagmint::cli
