# SPDX-License-Identifier: Apache-2.0
"""The text of a .sozai file. No part of Blender is used here."""
import json
import os
import struct


def number(value):
    """Shortest text that reads back as the same single float."""
    if isinstance(value, int):
        return str(value)
    for digits in range(1, 10):
        text = "%.*g" % (digits, value)
        if struct.pack("f", float(text)) == struct.pack("f", value):
            break
    return text if abs(value) < 1e-4 else repr(float(text)).removesuffix(".0")


def scalar(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return number(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(scalar(v) for v in value) + "]"
    return json.dumps(value, ensure_ascii=False)  # JSON's strings are YAML's


def section(name, values):
    lines = ["  %s: %s" % (key, scalar(value)) for key, value in values.items()]
    return [name + ":", *lines] if lines else []


HEAD = "# Written by Blender's add-on, and written over when the material changes."


def output(whole, image):
    """One output of another file: Blender takes one picture from a file, and no query."""
    return "\n".join([HEAD, "# It shows one output of the file named here, which has all the rest.",
                      "include: " + scalar(whole), *section("image", image)]) + "\n"


def text(material, preset, params, surface, image):
    lines = [HEAD, "material: " + material]
    if preset:
        lines.append("preset: " + preset)
    lines += section("params", params) + section("surface", surface) + section("image", image)
    return "\n".join(lines) + "\n"


def write(path, content):
    """As a whole or not at all; false: it was there already, the same."""
    try:
        with open(path, encoding="utf-8") as old:
            if old.read() == content:
                return False
    except OSError:
        pass
    os.makedirs(os.path.dirname(path), exist_ok=True)
    unfinished = path + ".part"
    with open(unfinished, "w", encoding="utf-8") as new:
        new.write(content)
    os.replace(unfinished, path)
    return True
