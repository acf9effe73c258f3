#!/usr/bin/python3
"""Makes docs/pictures/diagnosis-case.svg from the page of the diagnosis that docs/diagnosis-case.md tells of:

    docs/diagnosis_case.py out/case/diagnosis.html
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHOWN = ("against time", "against speed", "against the reading", "with the extended scene, against time")
WIDE, HIGH, GAP = 460, 280, 20  # pixels, of the page's plots


def main():
    page = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    plots = {title.group(1): svg for svg in re.findall(r"<svg.*?</svg>", page, re.S) if (title := re.search(r"<title>(.*?)</title>", svg))}
    style = re.sub(r"svg\{[^}]*\}", "", re.search(r"<style>.*?</style>", page, re.S).group(0)) + "<rect width='100%' height='100%' fill='white'/>"
    size = f"{2 * WIDE + GAP} {2 * HIGH + GAP}"
    parts = [f'<svg viewBox="0 0 {size}" width="{2 * WIDE + GAP}" height="{2 * HIGH + GAP}" role="img" xmlns="http://www.w3.org/2000/svg">{style}']
    for k, title in enumerate(SHOWN):
        inside = re.sub(r"</?svg[^>]*>", "", plots[title])
        parts.append(f'<g transform="translate({(WIDE + GAP) * (k % 2)} {(HIGH + GAP) * (k // 2)})">{inside}</g>')
    (ROOT / "docs/pictures/diagnosis-case.svg").write_text("\n".join(parts) + "\n</svg>\n", encoding="utf-8")


if __name__ == "__main__":
    main()
