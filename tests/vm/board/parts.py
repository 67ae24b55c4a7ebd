#!/usr/bin/env python3
"""parts.py KERNEL BOOT FILES LEFT_OUT LINES -- checks the device trees and the settings of the firmware on the card.

QEMU emulates no Raspberry Pi 4. This test therefore reads the device trees on the card (BOOT). For each enabled part of a
board, the kernel's list of aliases (KERNEL) names the module that drives it. That module must be among the modules on the
card (in the list of files of the initramfs, FILES), or in the table LEFT_OUT with a reason. Parts without a module have drivers in the kernel
itself, or none. Prints one line for each board.

Each tree must also name the lines of the cabinet (LINES, a kingyo.conf), and config.txt must name only files that BOOT has.
Exit code 1: one of these is missing, or a row of LEFT_OUT is not needed.
"""
import fnmatch
import pathlib
import re
import subprocess
import sys


def read_aliases(kernel):
    """Returns pairs of a pattern of the compatible string and the module that drives such a part."""
    pairs = []
    for line in next(pathlib.Path(kernel).glob("lib/modules/*/modules.alias")).read_text().splitlines():
        words = line.split()
        if words[:1] == ["alias"] and words[1].startswith("of:N"):
            pattern = words[1].partition("C")[2]
            pairs.append((pattern[:-2] if pattern.endswith("C*") else pattern, words[2]))
    return pairs


def source_of(path):
    return subprocess.run(["dtc", "-q", "-I", "dtb", "-O", "dts", path], check=True, capture_output=True, text=True).stdout


def missing_lines(text, lines):
    """Returns the names of the file LINES that no gpio-line-names of the tree has."""
    wanted = re.findall(r"^line = [^=\s]+=([^,\s]+)", pathlib.Path(lines).read_text(), re.M)
    named = set()
    for names in re.findall(r"gpio-line-names = ([^;]*);", text):
        named |= set(re.split(r"\\0", ", ".join(re.findall(r'"([^"]*)"', names)).replace(", ", "\\0")))
    return [name for name in wanted if name not in named] if wanted else ["every line"]


def missing_files(boot):
    """Returns the files that config.txt names and BOOT lacks. The firmware searches overlays in a folder of their own."""
    text = (boot / "config.txt").read_text()
    named = re.findall(r"^(?:kernel|device_tree|include|ramfsfile)[= ](\S+)", text, re.M)
    named += re.findall(r"^initramfs (\S+)", text, re.M)
    named += [f"overlays/{name}.dtbo" for name in re.findall(r"^(?:dtoverlay|device_tree_overlay)=([^,\s]+)", text, re.M)]
    if not named:
        return ["a kernel"]
    return [name for name in named if not (boot / name).exists()]


def enabled_parts(text):
    """Yields the name and the compatible strings of each enabled node. A disabled node disables its children."""
    stack = []
    for line in map(str.strip, text.splitlines()):
        if line.endswith("{"):
            stack.append({"name": line[:-1].strip(), "compatible": [], "disabled": bool(stack) and stack[-1]["disabled"]})
        elif line.startswith("}") and stack:
            node = stack.pop()
            if not node["disabled"]:
                yield node["name"], node["compatible"]
        elif stack and line.startswith("compatible ="):
            stack[-1]["compatible"] = re.split(r"\\0", ", ".join(re.findall(r'"([^"]*)"', line)).replace(", ", "\\0"))
        elif stack and re.match(r'status = "(disabled|fail)', line):
            stack[-1]["disabled"] = True


def main():
    kernel, boot, files, left_out, lines = sys.argv[1:]
    aliases = read_aliases(kernel)
    on_card = {re.sub(r"\.ko.*", "", pathlib.Path(line).name).replace("-", "_")
               for line in pathlib.Path(files).read_text().splitlines() if ".ko" in line}
    rows = [line.split(None, 1) for line in pathlib.Path(left_out).read_text().splitlines() if line and line[0] != "#"]
    reasons, used, failed = dict(rows), set(), False
    for tree in sorted(pathlib.Path(boot).glob("*.dtb")):
        modules = {}
        text = source_of(str(tree))
        for name, compatible in enabled_parts(text):
            for word in compatible:
                modules.update({module: name for pattern, module in aliases if fnmatch.fnmatchcase(word, pattern)})
        missing = [m for m in modules if m not in on_card and m not in reasons]
        used |= set(modules) & set(reasons)
        unnamed = missing_lines(text, lines)
        failed |= bool(missing or unnamed)
        print(f"{tree.stem}: {len(modules)} modules, {len(set(modules) & on_card)} on the card"
              + "".join(f"; no driver for {modules[m]} ({m})" for m in missing)
              + "".join(f"; no line is named {name}" for name in unnamed))
    for name in missing_files(pathlib.Path(boot)):
        print(f"config.txt: the card has no {name}")
        failed = True
    for module in sorted(set(reasons) - used):
        print(f"{left_out}: no board needs {module}")
        failed = True
    sys.exit(1 if failed else 0)


main()
