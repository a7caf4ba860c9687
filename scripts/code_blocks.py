#!/usr/bin/env python3
"""Writes the code blocks of a Markdown document as programs, so that the document can be tested:

  code_blocks.py DOCUMENT FOLDER      writes superpixels.cpp, superpixels.py, superpixels.sh, CMakeLists.txt

The blocks of a language follow each other in one program, as a reader would type them. Before them come an image,
the next image and a depth map, which a fragment may use without saying where they are from. A block in a language
without a rule is an error, so that none goes untested.
"""
import os
import re
import sys

CPP = """#include <opencv2/imgproc.hpp>
{includes}
int main()
{{
    cv::Mat image(240, 320, CV_8UC3), next_image, depth(image.size(), CV_16UC1);
    cv::randu(image, cv::Scalar::all(0), cv::Scalar::all(256));
    cv::blur(image, image, cv::Size(9, 9));
    cv::blur(image, next_image, cv::Size(3, 3));
    cv::randu(depth, cv::Scalar::all(0), cv::Scalar::all(4000));
    {{
{blocks}
    }}
}}
"""
PYTHON = """import numpy as np
y, x = np.mgrid[0:240, 0:320]
image = np.stack([x % 256, y, 128 + 100 * np.sin(x / 20.0 + y / 30.0)], axis=-1).astype(np.uint8)
next_image = np.roll(image, 1, axis=1)
depth = (1000 + 3 * x).astype(np.uint16)
{blocks}
"""
FILES = {
    "cpp": ("superpixels.cpp", CPP, '#line {line} "{document}"'),
    "python": ("superpixels.py", PYTHON, "# {document}:{line}"),
    "sh": ("superpixels.sh", "{blocks}\n", "# {document}:{line}"),
    "cmake": ("CMakeLists.txt", "{blocks}\n", "# {document}:{line}"),
}


def main():
    document, folder = sys.argv[1:]
    with open(document, encoding="utf-8") as file:
        text = file.read()
    os.makedirs(folder, exist_ok=True)
    blocks = {}
    for match in re.finditer(r"^```(.*)\n((?s:.*?))^```$", text, re.MULTILINE):
        language, code = match.groups()
        if language not in FILES:
            sys.exit("%s: no rule for a block of '%s'" % (document, language))
        line = text.count("\n", 0, match.start()) + 2
        blocks.setdefault(language, []).append(
            FILES[language][2].format(document=document, line=line) + "\n" + code)
    if text.count("```") != 2 * sum(map(len, blocks.values())):
        sys.exit(document + ": a fence that does not stand at the beginning of a line, or is not closed")
    for language, parts in blocks.items():
        name, frame, _ = FILES[language]
        code = "\n".join(parts)
        includes = ""
        if language == "cpp":
            includes = "\n".join(re.findall(r"^#include.*", code, re.MULTILINE))
            code = re.sub(r"^#include.*", "", code, flags=re.MULTILINE)
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(frame.format(blocks=code, includes=includes))
    print(", ".join("%d %s" % (len(parts), language) for language, parts in sorted(blocks.items())))


if __name__ == "__main__":
    main()
