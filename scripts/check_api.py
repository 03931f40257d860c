#!/usr/bin/env python3
"""Compares the public headers with the declarations of ARGoS 3 that users' code may use: scripts/check_api.py BUILD_FOLDER

BUILD_FOLDER needs to be configured only. src/testing/compat/api/*.txt list what ARGoS 3 declares, one declaration per line
without names of parameters; a default argument is "= default". Lines that are not indented:

  include PATH               the header that declares what follows, below argos3/
  class NAME [: BASES] [with T = TYPE]...    its members follow, indented; "with" gives the arguments of a template
  function DECLARATION [with T = TYPE]...
  variable TYPE NAME
  macro NAME

An indented line may end with "with T = TYPE", too, for a member template. "# text" is a comment. Exceptions, with their reason:

  call DECLARATION # reason          the member function differs, but it can be called with these arguments, for this result
  not DECLARATION # reason           the headers do not have it, which is an error if they do

Each line becomes a statement, and one compiler reads all of them, so what fails is reported with the line of the list. A member
function has exactly the listed type, and it can be overridden if it is listed as virtual. Operators, constructors and functions
can be called with the listed arguments, and give the listed type. The result is remembered as by check_headers.py.
"""
import glob
import hashlib
import os
import re
import subprocess
import sys

SOURCE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LISTS = os.path.join(SOURCE, "src", "testing", "compat", "api")
PRELUDE = """
#include <concepts>
#include <type_traits>
#include <utility>
namespace api {
using namespace argos;
template <class BASE, class DERIVED> concept CastsDown = requires(BASE* base) { static_cast<DERIVED*>(base); };
"""


def split(text, separator=","):
    """Splits at separators that are in no bracket."""
    parts, depth, start = [], 0, 0
    for place, letter in enumerate(text):
        depth += letter in "(<[{"
        depth -= letter in ")>]}"
        if letter == separator and depth == 0:
            parts.append(text[start:place].strip())
            start = place + 1
    return [part for part in parts + [text[start:].strip()] if part]


def value_of(parameter):
    return f"std::declval<{parameter}>()"


class Declaration:
    """A line of a list, without its indentation."""

    def __init__(self, text):
        text, *given = re.split(r"\s+with\s+", text)
        self.aliases = "".join(f"using {one.replace('=', '=', 1)}; " if not re.search(r"=\s*\d+$", one)
                               else f"constexpr UInt32 {one}; " for one in given)
        self.arguments = [one.split("=")[0].strip() for one in given]
        template = re.match(r"template\s*<.*?>\s*(?=[A-Za-z])", text)
        self.is_template = template is not None
        self.text = text[template.end():] if template else text
        for word in ("virtual", "static", "explicit"):
            found = re.match(word + r"\s+", self.text)
            setattr(self, "is_" + word, found is not None)
            self.text = self.text[found.end():] if found else self.text
        function = re.match(r"(?P<head>.*?(?:operator\s*\(\))?)\((?P<parameters>.*)\)(?P<const>\s*const)?(?P<pure>\s*=\s*0)?$",
                            self.text)
        self.is_function = function is not None and not self.text.startswith(("typedef", "using", "enum"))
        if self.is_function:
            parameters = split(function["parameters"])
            self.parameters = [one.replace("= default", "").strip() for one in parameters]
            self.required = self.parameters[:sum("= default" not in one for one in parameters)]
            self.is_const = function["const"] is not None
            head = re.match(r"(?P<result>.*?)\s*\b(?P<name>operator\s*(?:\(\)|\[\]|[^\w\s()]+|\s[\w:<>, *&]+)|~?\w+)\s*$",
                            function["head"])
            self.result, self.name = head["result"].strip(), head["name"].strip()

    def type_of(self, scope):
        return f"{self.result} ({scope}*)({', '.join(self.parameters)}){' const' if self.is_const else ''}"

    def operator_call(self, operands):
        sign = self.name[len("operator"):].strip()
        if sign == "()":
            return f"{operands[0]}({', '.join(operands[1:])})"
        if sign == "[]":
            return f"{operands[0]}[{operands[1]}]"
        return f"({sign}{operands[0]})" if len(operands) == 1 else f"({operands[0]} {sign} {operands[1]})"


def same(expression, result):
    return f"static_assert(std::is_same_v<decltype({expression}), {result}>);"


def typedef_check(text):
    name = re.search(r"(\w+)\s*(\(.*\))?$", text)
    return f"{text[:name.start(1)]}TType{text[name.end(1):]}; static_assert(std::is_same_v<TType, typename Probe::{name[1]}>);"


def enum_check(text, scope):
    name, values = re.match(r"enum (?:class )?(\w+).*?\{(.*)\}", text).groups()
    checks, number = "", 0
    for value in split(values):
        given = re.match(r"(\w+)\s*=\s*(-?\w+)", value)
        value, number = (given[1], int(given[2], 0)) if given else (value, number)
        place = f"{scope}::{name}" if text.startswith("enum class") else scope
        checks += f"static_assert({place}::{value} == static_cast<{scope}::{name}>({number})); "
        number += 1
    return checks


def member_check(text, class_name, number):
    """Returns a statement, and members of a class beside it, that compile if the class has the member."""
    only_called = text.startswith("call ")
    text = text.removeprefix("call ")
    one = Declaration(text)
    if text.startswith("typedef"):
        return typedef_check(text), ""
    if text.startswith("enum"):
        return enum_check(text, "Probe"), ""
    if not one.is_function:
        kind, names = re.match(r"(.*?[\s&*>])((?:\w+(?:\[.*?\])?(?:,\s*)?)+)$", one.text).groups()
        checks = ""
        for name in split(names):
            array = re.search(r"\[.*\]$", name)
            checks += same(f"Probe::{name[:array.start()] if array else name}", kind.strip() + (array[0] if array else "")) + " "
        return checks, ""
    if one.name == re.sub(r"<.*", "", class_name).split("::")[-1]:
        return constructor_check(one, number)
    more = ""
    if one.is_virtual and not only_called:
        more = (f"struct Override{number} : Listed {{ {one.result} {one.name}({', '.join(one.parameters)})"
                f"{' const' if one.is_const else ''} override; }};")
    self = value_of("const Probe&" if one.is_const else "Probe&")
    if one.name.startswith("operator"):
        if not one.result:
            return f"static_assert(std::is_convertible_v<decltype({self}), {one.name[len('operator'):]}>);", more
        if one.name == "operator=":
            self = value_of("Listed&")
        return one.aliases + same(one.operator_call([self] + [value_of(p) for p in one.parameters]), one.result), more
    if only_called:
        return one.aliases + same(f"{self}.{one.name}({', '.join(map(value_of, one.parameters))})", one.result), more
    name = f"Probe::{'template ' if one.is_template else ''}{one.name}" + (f"<{', '.join(one.arguments)}>" if one.is_template else "")
    check = f"{one.aliases}static_cast<void>(static_cast<{one.type_of('' if one.is_static else 'Listed::')}>(&{name}));"
    if len(one.required) < len(one.parameters):
        check += f" static_cast<void>(sizeof(({self}.{one.name}({', '.join(map(value_of, one.required))}), 0)));"
    return check, more


def constructor_check(one, number):
    checks, made = one.aliases, ""
    for count in {len(one.required), len(one.parameters)}:
        parameters = one.parameters[:count]
        names = ", ".join(f"std::type_identity_t<{p}> a{i}" for i, p in enumerate(parameters))
        values = ", ".join(f"static_cast<{p}>(a{i})" for i, p in enumerate(parameters))
        made += f"struct Made{number}_{count} : Listed {{ Made{number}_{count}({names}) : Listed({values}) {{}} }};"
        checks += f"static_assert(std::is_abstract_v<Listed> || std::is_constructible_v<Listed{''.join(', ' + p for p in parameters)}>);"
    if len(one.required) <= 1 <= len(one.parameters):
        wanted = "!" if one.is_explicit else ""
        checks += f"static_assert(std::is_abstract_v<Listed> || {wanted}std::is_convertible_v<{one.parameters[0]}, Listed>);"
    if one.is_template:
        return checks, ""
    return checks, made


def base_checks(bases):
    checks = ""
    for base in split(bases):
        is_virtual = " virtual " in f" {base} "
        name = re.sub(r"\b(public|virtual)\b", "", base).strip()
        checks += (f"static_assert(std::is_convertible_v<Listed*, {name}*> && "
                   f"{'!' if is_virtual else ''}CastsDown<{name}, Listed>); ")
    return checks


def function_check(text):
    one = Declaration(text)
    values = [value_of(p) for p in one.parameters]
    if one.name.startswith("operator"):
        return one.aliases + same(one.operator_call(values), one.result)
    deduced = all(re.search(rf"\b{name}\b", " ".join(one.parameters)) for name in one.arguments)
    name = one.name if deduced else f"{one.name}<{', '.join(one.arguments)}>"
    check = one.aliases + same(f"{name}({', '.join(values)})", one.result)
    if len(one.required) < len(one.parameters):
        check += f" static_cast<void>(sizeof(({name}({', '.join(values[:len(one.required)])}), 0)));"
    return check


class Program:
    """The statements made of all lists; those of one class are members of a class that is derived from it."""

    def __init__(self):
        self.includes, self.body, self.open, self.count = [], [], "", 0

    def close(self):
        if self.open:
            self.body.append("\n".join(["static void Check() {", *self.statements, "}", *self.members, self.open]))
        self.open = ""

    def begin_class(self, text, where):
        self.close()
        text, *given = re.split(r"\s+with\s+", text)
        name, _, bases = text.partition(" : ")
        aliases = "".join(f"constexpr UInt32 {one}; " if re.search(r"=\s*\d+$", one) else f"using {one}; " for one in given)
        head = f"namespace n{self.count} {{ {aliases}\n{where}\n"
        outer, _, _ = name.rpartition("::")
        self.class_name = name
        if outer:
            head += f"struct Outer : {outer} {{ "
        self.body.append(head + f"struct Probe : {name} {{ using Listed = {name};\n")
        self.statements, self.members = [f"{where}\n{base_checks(bases)}"], []
        self.open = "};" + ("};" if outer else "") + "}"

    def add(self, line, where, absent):
        """Adds a line of a list: what the headers have, or, if absent, what they do not have."""
        text = re.sub(r"\s+#.*|^#.*", "", line).rstrip()
        kind, _, rest = text.strip().partition(" ")
        if not text or (kind == "not") != absent and kind not in ("include", "class"):
            return
        if kind == "not":
            text = text.replace("not ", "", 1)
            kind, _, rest = text.strip().partition(" ")
        self.count += 1
        if text.startswith(" "):
            statement, member = member_check(text.strip(), self.class_name, self.count)
            self.statements.append(f"{where}\n{{ {statement} }}")
            self.members.append(f"{where}\n{member}" if member else "")
        elif kind == "include":
            self.includes.append(f"{where}\n#include <argos3/{rest}>")
        elif kind == "class":
            self.begin_class(rest, where)
        elif kind == "macro":
            self.close()
            self.body.append(f'#ifndef {rest}\n{where}\nstatic_assert(false, "{rest} is not defined");\n#endif')
        else:
            self.close()
            check = function_check(rest) if kind == "function" else variable_check(rest)
            self.body.append(f"namespace n{self.count} {{ inline void Check() {{\n{where}\n{check} }} }}")

    def text(self):
        self.close()
        return "\n".join([*self.includes, PRELUDE, *self.body, "}\n"])


def variable_check(text):
    kind, name = text.rsplit(" ", 1)
    return same(f"({name})", kind + "&")


def read_lists():
    """@return (line, its place in a list) of all lines."""
    for file in sorted(glob.glob(os.path.join(LISTS, "*.txt"))):
        with open(file, encoding="utf-8") as lines:
            for number, line in enumerate(lines.read().split("\n"), 1):
                yield line, f"{os.path.relpath(file, SOURCE)}:{number}"


def program_of(lines, absent):
    program = Program()
    for line, place in lines:
        file, number = place.rsplit(":", 1)
        program.add(line, f'#line {number} "{file}"', absent)
    return program.text()


class Compiler:
    def __init__(self, build):
        folder = os.path.join(build, "header_checks")
        if not os.path.exists(os.path.join(folder, "compiler")):
            sys.exit(f"{build} is not configured; run: cmake -S {SOURCE} -B {build}")
        with open(os.path.join(folder, "compiler"), encoding="utf-8") as file:
            compiler = file.read().split("\n")[0]
        self.roots = {}
        for file in sorted(glob.glob(os.path.join(folder, "*.roots"))):
            with open(file, encoding="utf-8") as lines:
                self.roots.update(dict.fromkeys(root for root in lines.read().split("\n") if root and root != "/usr/include"))
        self.command = [compiler, "-std=c++20", "-fsyntax-only", "-w", "-fdiagnostics-color=never", "-x", "c++", "-",
                        *(f"-I{root}" for root in self.roots)]

    def errors(self, text):
        return subprocess.run(self.command, input=text, capture_output=True, text=True, check=False).stderr

    def hash_headers(self):
        """Of all headers in the include roots of this project, and of the compiler."""
        found = hashlib.sha256(subprocess.run([self.command[0], "--version"], capture_output=True, check=True).stdout)
        for root in self.roots:
            for folder, folders, files in os.walk(root, followlinks=True) if root.startswith(os.path.dirname(SOURCE)) else ():
                folders.sort()
                for name in sorted(files):
                    if name.endswith(".h"):
                        with open(os.path.join(folder, name), "rb") as file:
                            found.update(name.encode() + file.read())
        return found.hexdigest()


def stamp_of(*texts):
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
    with open(__file__, "rb") as script:
        hashed = hashlib.sha256(script.read() + "\n".join(texts).encode())
    return os.path.join(cache, "argos3-checks", "headers", hashed.hexdigest())


def find_errors(compiler, lines):
    """@return messages for what the headers lack, and for exceptions of what they have."""
    found = compiler.errors(program_of(lines, absent=False))
    errors = [found] if found else []
    exceptions = any(line.strip().startswith("not ") for line, _ in lines)
    absent = compiler.errors(program_of(lines, absent=True)) if exceptions else ""
    for line, place in lines:
        if line.strip().startswith("not ") and not re.search(re.escape(place) + r":.*error", absent):
            errors.append(f"{place}: the headers have what is listed as absent: {line.strip()}")
    return errors


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    compiler = Compiler(os.path.abspath(sys.argv[1]))
    lines = list(read_lists())
    stamp = stamp_of(compiler.hash_headers(), "\n".join(line for line, _ in lines))
    if not os.path.exists(stamp) or os.environ.get("ARGOS_CHECK_ALL", "0") != "0":
        errors = find_errors(compiler, lines)
        if errors:
            sys.exit("\n".join(errors))
        try:
            os.makedirs(os.path.dirname(stamp), exist_ok=True)
            with open(stamp, "w", encoding="utf-8"):
                pass
        except OSError:
            pass
    listed = [line.split()[0] for line, _ in lines if line.strip() and not line.startswith(("#", "include"))]
    print(f"{len(listed)} declarations of ARGoS 3: {listed.count('call')} can only be called, {listed.count('not')} are absent")


if __name__ == "__main__":
    main()
