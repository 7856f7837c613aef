"""Reads C and C++ far enough to measure it: lines with and without comments, functions with their class and their lines.

No compiler and no index: a scanner of brackets and words. It is right for code in the style of this project; figures
of other trees are good to a few per cent.
"""
import bisect
import dataclasses
import re

TOKEN = re.compile(
    r'(?P<comment>//[^\n]*(?:\\\n[^\n]*)*|/\*.*?\*/)'
    r'|(?P<string>(?:u8|u|U|L)?R"(?P<fence>[^()\\\s]{0,16})\(.*?\)(?P=fence)"'
    r'|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])+\')',
    re.DOTALL)
PIECE = re.compile(r"[A-Za-z_]\w*|::|->|[{}();:<>,=~\[\]]|[^\s]")
NO_FUNCTION = {"if", "for", "while", "switch", "catch", "return", "do", "else", "try", "new", "sizeof", "alignas", "decltype"}
TAIL = {"const", "noexcept", "override", "final", "mutable", "volatile", "&", "try"}


@dataclasses.dataclass
class Function:
    name: str       # with the class as it is written: Machine::tick
    owner: str      # namespaces and class, "" for a free function
    path: str
    first: int
    last: int

    @property
    def lines(self):
        return self.last - self.first + 1


def blanked(text):
    return re.sub(r"[^\n]", " ", text)


class Source:
    """One file: `lines` as they stand, `code` without comments and with empty literals, `comments` by line."""

    def __init__(self, path, text):
        self.path = path
        self.lines = text.split("\n")
        if self.lines and not self.lines[-1]:
            self.lines.pop()
        self.comments = {}
        number = 1
        at = 0
        parts = []
        for token in TOKEN.finditer(text):
            number += text.count("\n", at, token.start())
            parts.append(text[at:token.start()])
            whole = token.group()
            if token.lastgroup == "comment" or token.group("comment"):
                for offset, line in enumerate(whole.split("\n")):
                    self.comments[number + offset] = (self.comments.get(number + offset, "") + " " + line.strip("/* \t")).strip()
                parts.append(blanked(whole))
            else:
                parts.append(whole[0] + blanked(whole[1:-1]) + whole[-1] if "R\"" not in whole[:4] else blanked(whole))
            number += whole.count("\n")
            at = token.end()
        parts.append(text[at:])
        self.code_text = "".join(parts)
        self.code = self.code_text.split("\n")[:len(self.lines)]

    def text_without_comments(self):
        """Lines without comments, literals as they stand."""
        kept = []
        for line, code in zip(self.lines, self.code):
            kept.append(line[:len(code.rstrip())])
        return kept

    def comment_lines(self):
        """Numbers of the lines that hold a comment and nothing else."""
        return [n for n in self.comments if n <= len(self.code) and not self.code[n - 1].strip()]

    def functions(self):
        return list(_functions(self))


def _without_directives(text):
    """Preprocessor lines emptied: their brackets need not match."""
    out, inside = [], False
    for line in text.split("\n"):
        directive = inside or line.lstrip().startswith("#")
        inside = directive and line.rstrip().endswith("\\")
        out.append(" " * len(line) if directive else line)
    return "\n".join(out)


def _functions(source):
    text = _without_directives(source.code_text)
    starts = [0]
    for match in re.finditer("\n", text):
        starts.append(match.end())
    pieces = [(m.group(), m.start()) for m in PIECE.finditer(text)]
    line_of = lambda place: bisect.bisect_right(starts, place)
    scopes = []      # (kind, name)
    head = []        # pieces since the last statement ended
    i, n = 0, len(pieces)

    def skip(index):
        """Behind the bracket that closes the one at index."""
        depth = 0
        while index < n:
            word = pieces[index][0]
            if word in "{([":
                depth += 1
            elif word in "})]":
                depth -= 1
                if depth == 0:
                    return index + 1
            index += 1
        return n

    while i < n:
        word, place = pieces[i]
        if word == "(" or word == "[":
            after = skip(i)
            head += pieces[i:after]
            i = after
        elif word == ";":
            head, i = [], i + 1
        elif word == "}":
            if scopes:
                scopes.pop()
            head, i = [], i + 1
        elif word == ":" and [w for w, _ in head] in (["public"], ["private"], ["protected"]):
            head, i = [], i + 1
        elif word == "{":
            kind, name = _meaning(head)
            if kind == "function":
                after = skip(i)
                prefix = [s for k, s in scopes if s]
                cls = [s for k, s in scopes if k == "class"]
                parts = name.split("::")
                owner = "::".join(prefix + parts[:-1]) if cls or len(parts) > 1 else ""
                yield Function(name, owner, source.path, line_of(head[0][1]), line_of(pieces[after - 1][1]))
                head, i = [], after
            elif kind in ("namespace", "class"):
                scopes.append((kind, name))
                head, i = [], i + 1
            else:      # a value, an initialiser, an enumeration: belongs to the statement
                after = skip(i)
                head += pieces[i:after]
                i = after
                if kind == "enum":
                    head = []
        else:
            head.append(pieces[i])
            i += 1


def _meaning(head):
    """What the bracket behind these pieces opens: (kind, name)."""
    words = [w for w, _ in head]
    while words[:1] == ["template"]:
        depth, k = 0, 1
        while k < len(words):
            depth += (words[k] == "<") - (words[k] == ">")
            k += 1
            if depth <= 0:
                break
        words = words[k:]
        if words[:1] == ["requires"]:
            words = words[1:]
    if not words:
        return "value", ""
    if words[0] == "inline" and "namespace" in words[:2]:
        words = words[1:]
    if words[0] == "namespace":
        return "namespace", "".join(words[1:])
    if words[0] == "extern" and len(words) <= 4 and "(" not in words:
        return "namespace", ""
    if "enum" in words[:3] and "(" not in words:
        return "enum", ""
    top, depth, angles = [], 0, 0     # pieces outside all brackets
    for k, w in enumerate(words):
        if w in "([{":
            if depth == 0:
                top.append((w, k))
            depth += 1
        elif w in ")]}":
            depth -= 1
            if depth == 0:
                top.append((w, k))
        elif depth == 0:
            top.append((w, k))
    plain = [w for w, _ in top]
    kinds = [w for w in plain if w in ("class", "struct", "union")]
    if kinds and not _call_at(plain):
        at = plain.index(kinds[0])
        names = [w for w in plain[at + 1:] if w not in ("final",)]
        if ":" in names:
            names = names[:names.index(":")]
        name = ""
        for w in names:
            if w in ("(", ")", "[", "]"):
                continue
            if w == "<":
                break
            if re.match(r"[A-Za-z_]\w*$", w):
                name = name + w if name.endswith("::") else w
            elif w == "::":
                name += w
        return "class", name
    call = _call_at(plain)
    if call is None:
        return "value", ""
    name_at, open_at = call
    tail = plain[open_at + 2:]
    if "=" in plain[:open_at] and "operator" not in plain[:open_at]:
        return "value", ""       # a lambda or a value in a definition
    if tail and tail[0] == ":" and tail[-1] not in (")", "}"):
        return "value", ""       # in the list of a constructor: member{…}
    if not tail or tail[0] == ":" or tail[0] in TAIL or tail[0] in ("->", "requires", "&&") or tail[0] == "[":
        return "function", _name(plain, name_at)
    return "value", ""


def _call_at(plain):
    """Places of the function's name and of the bracket of its parameters."""
    if "operator" in plain:
        at = plain.index("operator")
        for k in range(at + 1, len(plain)):
            if plain[k] == "(" and not (k == at + 1 and plain[k + 1:k + 3] == [")", "("]):
                return at, k
        return None
    for k, w in enumerate(plain):
        if w == "(" and k and re.match(r"[A-Za-z_]\w*$", plain[k - 1]) and plain[k - 1] not in ("alignas", "__attribute__", "noexcept", "decltype", "explicit", "requires"):
            return None if plain[k - 1] in NO_FUNCTION else (k - 1, k)
    return None


def _name(plain, at):
    name = plain[at]
    k = at
    if k and plain[k - 1] == "~":
        name, k = "~" + name, k - 1
    while k >= 2 and plain[k - 1] == "::":
        k -= 2
        if plain[k] == ">":
            while k and plain[k] != "<":
                k -= 1
            k -= 1
        name = plain[k] + "::" + name
    return name
