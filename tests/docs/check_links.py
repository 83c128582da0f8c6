"""Fails where README, CONTRIBUTING, CHANGELOG or docs/ link to, or name in `code`, what is not there.

usage: check_links.py SOURCE_FOLDER
"""

import re
import sys
from pathlib import Path

TOP_LEVEL = ("libcodec/", "libdetect/", "tools/", "families/", "tests/", "docs/", "cmake/")


def without_code(text):
    """The text with its fenced blocks left empty, so that lines keep their numbers."""
    return re.sub(r"```.*?```", lambda block: "\n" * block.group().count("\n"), text, flags=re.S)


def anchor(heading):
    """The name that a heading is linked by: small letters, spaces as hyphens, no other signs."""
    words = re.sub(r"[`*]|\[([^]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def anchors(page):
    return {anchor(h) for h in re.findall(r"^#+ (.*)$", without_code(page.read_text()), flags=re.M)}


def link_fault(page, target):
    if re.match(r"[a-z]+:", target):
        return None
    place, _, fragment = target.partition("#")
    path = (page.parent / place) if place else page
    if not path.exists():
        return f"{target} is not there"
    if fragment and path.suffix == ".md" and fragment not in anchors(path):
        return f"{path.name} has no heading #{fragment}"
    return None


def path_fault(root, code):
    """Of `code` that is plainly a path of the source tree; `*` stands for any name, NAME for one to be."""
    if not code.startswith(TOP_LEVEL) or not re.fullmatch(r"[\w./*+-]+", code) or "NAME" in code:
        return None
    if any(root.glob(code.rstrip("/"))) or any(root.glob(code + ".cpp")):
        return None
    return f"`{code}` is not there"


def main():
    root = Path(sys.argv[1])
    pages = sorted([*root.glob("*.md"), *(root / "docs").rglob("*.md"), *(root / "families").glob("*.md")])
    faults, links = [], 0
    for page in pages:
        for number, line in enumerate(without_code(page.read_text()).splitlines(), 1):
            found = [link_fault(page, t) for t in re.findall(r"\]\(([^)\s]+)\)", line)]
            found += [path_fault(root, c) for c in re.findall(r"`([^`]+)`", line)]
            links += len(found)
            faults += [f"{page.relative_to(root)}:{number}: {f}" for f in found if f]
    print(*faults, sep="\n")
    print(f"{links} links and names in {len(pages)} pages, {len(faults)} wrong")
    return 1 if faults or not links else 0


if __name__ == "__main__":
    sys.exit(main())
