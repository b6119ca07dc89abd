"""The package's reference as Markdown, from its sources alone: signatures and docstrings, read with the standard module ``ast``.

Nothing is imported, so that neither the compiled part nor NumPy need be there. ``python crates/nply-py/reference.py`` prints the page.
"""

from __future__ import annotations

import ast
import re
import sys
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent / "python" / "nply"

#: the parts of the page: a heading, and the modules whose names stand below it
PARTS = [
    ("Arrays", ["arrays"]),
    ("Reports", ["reports", "fits"]),
    ("Studies", ["sweeps", "studies", "tables", "dask"]),
    ("Shapes", ["shapes", "pictures"]),
    ("Curves", ["curves"]),
    ("Errors", ["errors"]),
    ("Threads", ["_nply"]),
]
#: modules that are asked for by their own name, `nply.dask`
APART = ["dask"]


def parsed(module: str) -> ast.Module:
    path = PACKAGE / f"{module}.py"
    return ast.parse((path if path.exists() else path.with_suffix(".pyi")).read_text(encoding="utf-8"))


def public(module: str) -> list[str]:
    """The names of ``__all__``."""
    for node in parsed(module).body:
        if isinstance(node, ast.Assign) and any(isinstance(to, ast.Name) and to.id == "__all__" for to in node.targets):
            return [name for name in ast.literal_eval(node.value) if not name.startswith("__")]
    return []


def given() -> dict[str, list[str]]:
    """Per module the names that the package gives, and those of the modules that stand apart."""
    names: dict[str, list[str]] = {}
    known = set(public("__init__"))
    for node in parsed("__init__").body:
        if isinstance(node, ast.ImportFrom) and node.level == 1 and node.module:
            names[node.module] = [alias.name for alias in node.names if alias.name in known]
    for module in APART:
        names[module] = public(module)
    return names


def definitions(module: str) -> dict[str, ast.FunctionDef | ast.ClassDef]:
    return {node.name: node for node in parsed(module).body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


def signature(name: str, function: ast.FunctionDef, bound: bool, returns: bool = True) -> str:
    """As it is written, without `self`; where that is long, an argument a line."""
    decorators = {ast.unparse(decorator) for decorator in function.decorator_list}
    answer = f" -> {ast.unparse(function.returns)}" if returns and function.returns else ""
    if "property" in decorators:
        return f"{name}{answer.replace(' -> ', ': ')}"
    args = ast.unparse(function.args)
    if bound and "staticmethod" not in decorators:
        args = re.sub(r"^(self|cls)(, /)?(, )?", "", args)
    text = f"{name}({args}){answer}"
    if len(text) <= 100:
        return text
    depth, broken = 0, ""
    for letter in args:
        depth += {"[": 1, "(": 1, "]": -1, ")": -1}.get(letter, 0)
        broken += ",\n   " if letter == "," and depth == 0 else letter
    return f"{name}(\n    {broken},\n){answer}"


def markdown(text: str) -> str:
    """A docstring as Markdown: sections of arguments as lists, examples in blocks, names as links."""
    out: list[str] = []
    code, section = False, ""
    for line in text.split("\n"):
        is_code = line.startswith(">>>") or (code and line.strip() != "")
        if is_code and not code:
            out += ["", "```python"]
        if code and not is_code:
            out += ["```", ""]
        code = is_code
        if code:
            out.append(line)
            continue
        if re.fullmatch(r"(Args|Raises|Returns|Yields):", line):
            section = line[:-1]
            out += ["", "**Arguments**" if section == "Args" else f"**{section}**", ""]
            continue
        if section and line.startswith("    "):
            inner = line[4:]
            if not inner.startswith(" "):
                name, colon, rest = inner.partition(": ")
                listed = bool(colon) and section != "Returns" and re.fullmatch(r"[\w*., ]+", name)
                out.append(f"- `{name}`: {prose(rest)}" if listed else prose(inner))
            else:
                out.append(f"  {prose(inner.strip())}")
            continue
        if line.strip():
            section = ""
        out.append(prose(line))
    if code:
        out.append("```")
    return re.sub(r"\n{3,}", "\n\n", "\n".join(out)).strip()


def prose(line: str) -> str:
    line = re.sub(r":(?:func|class|meth|mod|attr):`~?([\w.]+)`", lambda found: link(found[1]), line)
    line = line.replace("``", "`")
    # what is between backticks is left as it is
    parts = re.split(r"(`[^`]*`|\[`[^`]*`\]\([^)]*\))", line)
    return "".join(part if at % 2 else re.sub(r"([<>_\[\]])", r"\\\1", part) for at, part in enumerate(parts))


def link(name: str) -> str:
    top = name.removeprefix("nply.").split(".")[0]
    known = {one for names in given().values() for one in names}
    return f"[`{name}`](#{top.lower()})" if top in known else f"`{name}`"


def entry(module: str, name: str, node: ast.FunctionDef | ast.ClassDef) -> list[str]:
    prefix = f"nply.{module}." if module in APART else "nply."
    out = [f"### {name}", ""]
    doc = ast.get_docstring(node)
    if isinstance(node, ast.FunctionDef):
        out += ["```python", signature(f"{prefix}{name}", node, bound=False), "```", ""]
        return [*out, markdown(doc or ""), ""]
    members = [one for one in node.body if isinstance(one, ast.FunctionDef)]
    made = next((one for one in members if one.name == "__init__"), None)
    # what is only ever given has no call of its own to show
    shown = made is not None and doc is not None and "Args:" in doc
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    call = signature(f"{prefix}{name}", made, bound=True, returns=False) if shown and made else f"class {prefix}{name}"
    out += ["```python", call if shown or not bases else f"{call}({bases})", "```", "", markdown(doc or ""), ""]
    for member in members:
        said = ast.get_docstring(member)
        if member.name.startswith("_") or said is None:
            continue
        out += [f"#### {name}.{member.name}", "", "```python", signature(member.name, member, bound=True), "```", ""]
        out += [markdown(said), ""]
    return out


def page() -> str:
    out: list[str] = []
    names = given()
    for heading, modules in PARTS:
        out += [f"## {heading}", ""]
        for module in modules:
            about = (ast.get_docstring(parsed(module)) or "") if module != "_nply" else ""
            if about:
                out += [markdown(about), ""]
            found = definitions(module)
            for name in names.get(module, []):
                if name in found:
                    out += entry(module, name, found[name])
    return "\n".join(out).rstrip() + "\n"


if __name__ == "__main__":
    sys.stdout.write(page())
