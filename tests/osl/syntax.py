#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""syntax.py FOLDER CXX: are the shaders of FOLDER sound?

With oslc on PATH they are compiled. Debian 12 has no oslc; without it each is
rewritten as C++ (metadata dropped, `surface NAME` made a function) and given to
a C++ compiler with declarations of OSL's functions: that finds wrong syntax,
names, types and numbers of arguments, and nothing that is OSL's own.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

KINDS = ("surface", "displacement", "shader", "volume")
OF_CXX = ("class", "template", "auto", "double", "static", "const", "this", "new", "&&", "::")


def as_cxx(text, name):
    found = re.search(r"^(%s) (\w+)" % "|".join(KINDS), text, re.M)
    if name.endswith(".osl") and (not found or found[2] + ".osl" != name):
        sys.exit("%s: holds no shader of that name" % name)
    code = re.sub(r"//[^\n]*", "", text)
    for word in OF_CXX:
        if re.search(r"(?<!\w)%s(?!\w)" % re.escape(word), code):
            sys.exit("%s: '%s' is C++'s, not OSL's" % (name, word))
    code = re.sub(r"\[\[.*?\]\]", lambda m: "\n" * m[0].count("\n"), code, flags=re.S)
    code = re.sub(r"^(%s) (?=\w+)" % "|".join(KINDS), "void ", code, flags=re.M)
    code = code.replace("closure color", "closure_color")
    return code.replace('#include "stdosl.h"', '#include "osl_as_cxx.h"')


def check(folder, compiler):
    names = sorted(n for n in os.listdir(folder) if n.endswith((".osl", ".h")))
    shaders = [n for n in names if n.endswith(".osl")]
    here = os.path.dirname(os.path.abspath(__file__))
    with tempfile.TemporaryDirectory() as scratch:
        oslc = shutil.which("oslc")
        if not oslc:
            for name in names:
                with open(os.path.join(folder, name), encoding="utf-8") as source:
                    text = as_cxx(source.read(), name)
                with open(os.path.join(scratch, name), "w", encoding="utf-8") as out:
                    out.write(text)
        for name in shaders:
            command = [oslc, "-q", "-o", os.path.join(scratch, name + ".oso"),
                       os.path.join(folder, name)] if oslc else \
                [compiler, "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-x", "c++",
                 "-I", here, os.path.join(scratch, name)]
            subprocess.run(command, check=True)
    print("%d shaders, %s" % (len(shaders), "compiled by oslc" if oslc else
                              "read as C++: there is no oslc here"))
    if not shaders:
        sys.exit("no shaders in " + folder)


try:
    check(sys.argv[1], sys.argv[2])
except subprocess.CalledProcessError:
    sys.exit(1)
