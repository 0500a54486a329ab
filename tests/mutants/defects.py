"""Finds the places of C++ sources where a defect can be planted, and the defects there.

The sources are split into tokens, but not parsed. clang-format puts a blank on both sides of a
binary operator, but not of a template bracket, a pointer or a reference. A defect that does not
compile costs a compilation; the caller discards the defect.
"""

import re
from typing import NamedTuple

TOKEN = re.compile(r"""
    (?P<blank>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.)*)
  | (?P<string>(?:u8|[uUL])?R"(?P<end>[^(]*)\(.*?\)(?P=end)"|(?:u8|[uUL])?"(?:\\.|[^"\\])*")
  | (?P<char>'(?:\\.|[^'\\])+')
  | (?P<number>\.?\d(?:'?[\w.]|(?<=[eEpP])[+-])*)
  | (?P<name>[A-Za-z_]\w*)
  | (?P<symbol><=>|\.\.\.|<<=?|::|->|\+\+|--|&&|\|\||[-+*/%&|^!=<>]=|.)
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

KEYWORDS = set("""alignas alignof asm auto break case catch class const consteval constexpr
    constinit continue decltype default delete do else enum explicit extern for friend goto if
    inline mutable namespace new noexcept operator private protected public register requires
    return sizeof static
    static_assert struct switch template this thread_local throw try typedef typename union using
    virtual volatile while""".split())
ASSIGNMENTS = {"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<="}
# These tokens end a term of a sum: assignments, operators that bind less than + and -, and others.
ENDS_TERM = ASSIGNMENTS | set("< > <= >= == != <=> << && || & | ^ ? : , ; return".split())

REPLACEMENTS = {  # text of a token -> (kind, new texts)
    "+": ("sign", ["-"]), "-": ("sign", ["+"]), "+=": ("sign", ["-="]), "-=": ("sign", ["+="]),
    "*": ("operator", ["/"]), "/": ("operator", ["*"]),
    "*=": ("operator", ["/="]), "/=": ("operator", ["*="]),
    "<": ("comparison", ["<=", ">"]), "<=": ("comparison", ["<", ">="]),
    ">": ("comparison", [">=", "<"]), ">=": ("comparison", [">", "<="]),
    "==": ("comparison", ["!="]), "!=": ("comparison", ["=="]),
    "&&": ("logic", ["||"]), "||": ("logic", ["&&"]),
    "++": ("increment", ["--"]), "--": ("increment", ["++"]),
    "true": ("truth", ["false"]), "false": ("truth", ["true"])}
SYMMETRIC = {"min", "max", "minmax", "swap", "hypot", "dot"}  # exchanged arguments change nothing
FUNCTIONS = {}  # function -> function that replaces it
for pair in ("min max", "fmin fmax", "min_element max_element", "minCoeff maxCoeff",
             "cwiseMin cwiseMax", "sin cos", "real imag"):
    one, other = pair.split()
    FUNCTIONS.update({one: other, other: one})


class Defect(NamedTuple):
    kind: str
    start: int  # of the characters that the defect replaces
    end: int
    new: str

    def planted(self, source):
        return source[:self.start] + self.new + source[self.end:]


class Token(NamedTuple):
    kind: str
    text: str
    start: int
    end: int
    spaced: bool  # blanks on both sides


def tokens_of(source):
    tokens = []
    for found in TOKEN.finditer(source):
        if found.lastgroup != "blank":
            around = source[found.start() - 1:found.start()] + source[found.end():found.end() + 1]
            tokens.append(Token(found.lastgroup, found[0], *found.span(),
                                len(around) == 2 and around.isspace()))
    return tokens


class Source:
    """The tokens of one file with what surrounds each of them."""

    def __init__(self, text):
        self.text = text
        self.tokens = tokens_of(text)
        self.partner = {}  # opening bracket <-> closing bracket; < > only in templates
        self.parent = []   # innermost open bracket around each token, or None
        self.blocks = set()  # opening braces of statements, not of lists or declarations
        self.excluded = set()
        self._match_brackets()
        self._exclude()

    def at(self, i):
        return self.tokens[i].text if 0 <= i < len(self.tokens) else ""

    def kind(self, i):
        return self.tokens[i].kind if 0 <= i < len(self.tokens) else ""

    def is_operand(self, i):
        """Returns whether an operator after this token is binary, and a bracket a call or index."""
        return (self.kind(i) in ("number", "string", "char")
                or self.at(i) in (")", "]", "}", "this")
                or self.kind(i) == "name" and self.at(i) not in KEYWORDS
                or self.at(i) == ">" and i in self.partner)

    def is_binary(self, i):
        return self.tokens[i].spaced and self.is_operand(i - 1)

    def _match_brackets(self):
        open_brackets = []
        for i, token in enumerate(self.tokens):
            text = token.text
            if text in (")", "]", "}"):
                while self.at(open_brackets[-1]) == "<":  # this < is not a template bracket
                    open_brackets.pop()
                self.partner[i] = open_brackets.pop()
                self.partner[self.partner[i]] = i
            elif text == ">" and not token.spaced and open_brackets and self.at(
                    open_brackets[-1]) == "<":
                self.partner[i] = open_brackets.pop()
                self.partner[self.partner[i]] = i
            self.parent.append(open_brackets[-1] if open_brackets else None)
            if text in ("(", "[", "{") or text == "<" and not token.spaced:
                if text == "{" and self._opens_block(i):
                    self.blocks.add(i)
                open_brackets.append(i)

    def _opens_block(self, i):
        j = i - 1  # goes back to the start of the statement of the brace
        while j >= 0 and self.at(j) not in (";", "{", "}", "(", "[", ","):
            if self.at(j) in ("class", "struct", "union", "enum", "namespace", "="):
                return False
            if self.at(j) == "->" and self.at(j - 1) == ")":
                return True  # the return type of a lambda
            j = self.partner.get(j, j) - 1
        before = self.at(i - 1)
        if before == "{":
            return self.parent[i] in self.blocks
        return before in (")", "]", "}", ";", ":", "else", "do", "try", "const", "noexcept",
                          "override", "final", "mutable")

    def _exclude(self):
        """Excludes messages of exceptions, compile-time checks, and arguments of templates."""
        for i, token in enumerate(self.tokens):
            if token.text == "throw" and self.at(i + 1) != ";":
                self.excluded.update(range(i, self._statement_end(i)))
            elif token.text in ("static_assert", "alignas") and self.at(i + 1) == "(":
                self.excluded.update(range(i, self.partner[i + 1]))
            elif token.text == "using":
                self.excluded.update(range(i, self._statement_end(i)))
            elif token.text == "operator":
                self.excluded.update((i + 1, i + 2))
            elif token.text == "<" and i in self.partner:
                self.excluded.update(range(i, self.partner[i] + 1))

    def _statement_end(self, i):
        while i < len(self.tokens) and self.at(i) not in (";", ")", "]", "}"):
            i = max(i, self.partner.get(i, i)) + 1
        return i

    def in_code(self, i):
        """Returns whether the token is part of a statement within a function."""
        i = self.parent[i]
        while i is not None and (self.at(i) != "{" or self._is_list(i)):
            i = self.parent[i]
        return i in self.blocks

    def _is_list(self, i):
        """Returns whether a brace opens a list of values."""
        return i not in self.blocks and (
            self.at(i - 1) in ("=", "(", ",", "{", "return", ":", "?", ">", "]")
            or self.parent[i] is not None and self.at(self.parent[i]) != "{"
            or self.kind(i - 1) == "name" and not self._opens_declarations(i))

    def _opens_declarations(self, i):
        while i > 0 and self.at(i - 1) not in (";", "{", "}", ")", "="):
            i = self.partner.get(i - 1, i - 1)
            if self.at(i) in ("class", "struct", "union", "enum", "namespace"):
                return True
        return False

    def defects(self):
        """Returns all defects, in the order of their places."""
        found = []
        for i, token in enumerate(self.tokens):
            if i not in self.excluded:
                for make in (self._replaced, self._factors, self._indices, self._dropped_terms,
                             self._dropped_statement, self._exchanged):
                    found.extend(make(i, token))
        return found

    def _replaced(self, i, token):
        if token.text == "!" and self.at(i + 1) != "=":
            yield Defect("logic", token.start, token.end, "")
        elif token.text == "-" and not self.is_operand(i - 1):
            yield Defect("sign", token.start, token.end, "")
        elif (token.text in FUNCTIONS and self.at(i - 1) in ("::", ".", "->")
              and "(" in (self.at(i + 1), self.at(self.partner.get(i + 1, i) + 1))):
            yield Defect("function", token.start, token.end, FUNCTIONS[token.text])
        elif token.text in REPLACEMENTS and (
                token.kind == "name" or token.text in ("++", "--") or self.is_binary(i)):
            if "string" not in (self.kind(i - 1), self.kind(i + 1)):
                kind, texts = REPLACEMENTS[token.text]
                for new in texts:
                    yield Defect(kind, token.start, token.end, new)

    def _factors(self, i, token):
        if token.kind != "number" or self.at(i - 1) == "=" and self.at(i - 2) in (
                ")", "const", "noexcept", "override"):  # a function without a body
            return
        digits = re.fullmatch(r"(0[xX][\da-fA-F']+|0[bB][01']+|[\d.']+(?:[eE][+-]?\d+)?)([uUlLfFzZ]*)", token.text)
        if digits is None:
            return
        try:
            value = int(digits[1].replace("'", ""), 0)
            news = [2 * value, value // 2] if value else [1]
        except ValueError:
            value = float(digits[1].replace("'", ""))
            news = [2 * value, value / 2] if value else [1.0]
        if value == 1:
            news = [type(value)(2), type(value)(0)]
        for new in news:
            yield Defect("factor", token.start, token.end, f"{new!r}{digits[2]}")

    def _indices(self, i, token):
        declared = self.kind(i - 1) == self.kind(i - 2) == "name" and self.at(i - 2) != "return"
        subscript = token.text == "[" and self.is_operand(i - 1) and not declared  # not double x[4]
        column = (token.text == "(" and self.at(i - 1) in ("col", "row", "at")
                  and self.at(i - 2) in (".", "->"))
        if not subscript and not column:
            return
        last = self.partner[i] - 1
        inside = self.text[token.end:self.tokens[last].end]
        if last > i and self.kind(i + 1) != "string" and len(self._arguments(i)) == 1:
            for change in ("+ 1", "- 1"):
                yield Defect("index", token.end, self.tokens[last].end, f"({inside}) {change}")

    def _dropped_terms(self, i, token):
        if token.text not in ("+", "-") or not self.is_binary(i):
            return
        if "string" in (self.kind(i - 1), self.kind(i + 1)):
            return
        end = i + 1
        while not self._ends_term(end):
            end = self.partner.get(end, end) + 1
        yield self._dropped("term", token.start, self.tokens[end - 1].end)
        start = i - 1
        while start >= 0 and not self._ends_term(start, backwards=True):
            start = self.partner.get(start, start) - 1
        if self.at(start) not in ("+", "-"):
            yield self._dropped("term", self.tokens[start + 1].start,
                                token.end if token.text == "+" else token.start)

    def _ends_term(self, i, backwards=False):
        text = self.at(i)
        if text in ("<", ">") and i in self.partner:
            return False
        if text in ("&", "|", "^"):
            return self.is_binary(i)
        return (text in ("([{" if backwards else ")]}") or text in ENDS_TERM
                or text in ("+", "-") and self.is_binary(i))

    def _dropped(self, kind, start, end, instead=""):
        """Drops text, but keeps its line breaks: assertions contain line numbers."""
        return Defect(kind, start, end, instead + "\n" * self.text.count("\n", start, end))

    def _dropped_statement(self, i, token):
        if self.parent[i] not in self.blocks or not self._starts_statement(i):
            return
        end = self._statement_end(i)
        k = i
        while self.at(k) in ("*", "++", "--"):
            k += 1
        if self.at(end) != ";" or self.kind(k) != "name" or self.at(k) in KEYWORDS - {"this"}:
            return
        k += 1
        while k < end:  # skips the name of the variable or function
            if self.at(k) in ("(", "[") or self.at(k) == "<" and k in self.partner:
                k = self.partner[k] + 1
            elif self.at(k) in ("::", ".", "->"):
                k += 2
            elif self.at(k) in ("++", "--"):
                k += 1
            else:
                break
        if k < end and self.at(k) not in ASSIGNMENTS | {"<<"}:
            return  # a declaration
        yield self._dropped("statement", token.start, self.tokens[end].end, "{}")

    def _starts_statement(self, i):
        before = self.at(i - 1)
        if before == ")":
            control = self.partner[i - 1] - 1
            return self.at(control) in ("if", "for", "while") or self.at(control) == "constexpr"
        if before == ":":
            return self.at(i - 3) in ("case", "::") or self.at(i - 2) == "default"
        return before in (";", "{", "}", "else", "do")

    def _exchanged(self, i, token):
        called = token.text == "(" and self.is_operand(i - 1) and (
            self.kind(i - 1) == "name" or self.at(i - 1) == ">")
        listed = token.text == "{" and i not in self.blocks and self.at(i + 1) != "."
        if not (called or listed) or not self.in_code(i) or self.at(i - 1) in SYMMETRIC:
            return
        arguments = self._arguments(i)
        for (first, end_first), (second, end_second) in zip(arguments, arguments[1:]):
            one, other = self.tokens[first].start, self.tokens[end_first - 1].end
            start, end = self.tokens[second].start, self.tokens[end_second - 1].end
            a, between, b = self.text[one:other], self.text[other:start], self.text[start:end]
            are_strings = self.kind(first) == self.kind(second) == "string"
            are_named = self._is_named(first) and self._is_named(second)
            if a != b and not are_strings and not are_named:
                yield Defect("arguments", one, end, b + between + a)

    def _is_named(self, i):
        """Returns whether {"name", value} begins here: in documents, names come in any order."""
        return self.at(i) == "{" and self.kind(i + 1) == "string"

    def _arguments(self, i):
        """Returns the first token of each argument in a bracket, and the token after its last."""
        arguments, first, k = [], i + 1, i + 1
        while k <= self.partner[i]:
            if k == self.partner[i] or self.at(k) == ",":
                if k > first:
                    arguments.append((first, k))
                first = k + 1
            k = max(k, self.partner.get(k, k)) + 1 if k < self.partner[i] else k + 1
        return arguments
