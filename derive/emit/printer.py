"""A kernel's rows as C statements.

Rows that are used once become part of the expression that uses them, as long as it stays short; the others become
constants with the author's name, or t0, t1, ... in order of use. Calls that gcc does not vectorize (atan2, sin, ...)
go into separate loops, so that the arithmetic around them is vectorized.
"""

from collections import Counter
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial

from flexel.derive.declare.checks import ARRAYS, TAKEN
from flexel.derive.program.graph import CONDITIONS, LEAVES
from flexel.derive.program.kernel_outputs import Derived, Kernel
from flexel.derive.program.straight_line import Program

BLOCK = 8  # elements in a block, see kernels.h
_INLINE = 56  # longest expression, in characters, that is written inside another one
_SUM, _PRODUCT, _SIGN, _ATOM = 1, 2, 3, 4  # how tightly an expression binds
_VECTORIZED = frozenset({"sqrt", "abs", "min", "max"})
_ARITHMETIC = frozenset({"add", "sub", "neg", "mul", "inv", "select"})


def literal(value: Fraction) -> str:
    """Write the double nearest to an exact number, in the shortest form that reads back the same."""
    return repr(float(value))


@dataclass
class Loop:
    """A loop over the elements of a block: its statements, and whether it is to be vectorized."""

    vectorized: bool
    lines: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class FunctionBody:
    """The contents of the loop over blocks: arrays that pass values between loops, and the loops."""

    arrays: tuple[str, ...]
    loops: tuple[Loop, ...]


def _c_name(name: str, used: set[str]) -> str:
    """Return the name itself, or with underscores behind it where it would clash; functions in C begin with real_."""
    temporary = name[:1] == "t" and name[1:].isdigit()
    if name.startswith("real_"):
        name = f"its_{name}"
    while name in used or name in ARRAYS or name in TAKEN or temporary:
        name, temporary = name + "_", False
    used.add(name)
    return name


class _Printer:
    def __init__(self, derived: Derived, kernel: Kernel) -> None:
        self.program: Program = derived.program
        self.kernel = kernel
        self.stores: dict[int, list[str]] = {}
        self.entries: dict[int, list[str]] = {}  # rows and columns of the entries of matrices
        outputs: list[int] = []
        for output in kernel.outputs:
            for i, row in enumerate(output.rows):
                self.stores.setdefault(row, []).append(f"{output.name}[{i} * {BLOCK} + j]")
                if len(output.shape) == 2:
                    r, c = divmod(output.nonzeros[i], output.shape[1])
                    self.entries.setdefault(row, []).append(f"{output.name}({r},{c})")
                outputs.append(row)
        self.order = self.program.in_order(outputs)
        self.uses = Counter(arg for row in self.order for arg in set(self.program.rows[row].args))
        self.loads = {
            row: f"{array}[{i} * {BLOCK} + j]"
            for array in kernel.inputs
            for i, row in enumerate(derived.inputs[array])
        }
        self.level = self._levels()
        self.across = self._across()
        self.names = self._names()
        self.text: dict[int, tuple[str, int]] = {}
        self.inlined_call_argument: set[int] = set()
        self.temporaries = 0
        self.arrays: list[str] = []

    def _levels(self) -> dict[int, int]:
        """Return the number of the loop of every row: even ones are vectorized, odd ones hold calls."""
        level: dict[int, int] = {}
        for row in self.order:
            op, args, _ = self.program.rows[row]
            needed = max((level[arg] for arg in args), default=0)
            call = op not in _ARITHMETIC | _VECTORIZED | CONDITIONS | LEAVES
            level[row] = needed if op in LEAVES or needed % 2 == call else needed + 1
        return level

    def _operands(self, row: int) -> list[int]:
        """Return rows whose values a row needs where it is written; conditions are written out where they are used."""
        found: list[int] = []
        for arg in self.program.rows[row].args:
            found += self._operands(arg) if self.program.rows[arg].op in CONDITIONS else [arg]
        return found

    def _across(self) -> set[int]:
        """Return the rows that are used in a later loop than where they are computed."""
        return {
            arg
            for row in self.order
            if self.program.rows[row].op not in CONDITIONS
            for arg in self._operands(row)
            if self.level[arg] != self.level[row] and self.program.rows[arg].op not in LEAVES
        }

    def _names(self) -> dict[int, str]:
        used = {output.name for output in self.kernel.outputs}
        return {
            row: _c_name(self.program.names[row], used)
            for row in sorted(self.order)
            if row in self.program.names
        }

    def body(self) -> FunctionBody:
        loops = [Loop(level % 2 == 0) for level in range(max(self.level.values(), default=0) + 1)]
        loaded: set[tuple[int, int]] = set()
        for row in self.order:
            loop = loops[self.level[row]]
            if self.program.rows[row].op in CONDITIONS:
                self._row(row, loop)
                continue
            for arg in (*self._operands(row), *([row] if row in self.stores else [])):
                if self.program.rows[arg].op == "input" and (self.level[row], arg) not in loaded:
                    loaded.add((self.level[row], arg))
                    loop.lines.append(f"const real {self.names[arg]} = {self.loads[arg]};")
            self._row(row, loop)
        return FunctionBody(tuple(self.arrays), tuple(loop for loop in loops if loop.lines))

    def _row(self, row: int, loop: Loop) -> None:
        op = self.program.rows[row].op
        text, binding = self._expression(row)
        stores = self.stores.get(row, [])
        once = self.uses[row] + bool(stores) <= 1
        if op in LEAVES or op in CONDITIONS:
            self.text[row] = text, binding
        elif row in self.across:
            name = self._claim(row)
            self.arrays.append(name)
            loop.lines.append(f"{name}[j] = {text};")
            self.text[row] = f"{name}[j]", _ATOM
        elif once and row not in self.program.names and (stores or len(text) <= _INLINE):
            self.text[row] = text, binding
        else:
            name = self._claim(row)
            loop.lines.append(f"const real {name} = {text};")
            self.text[row] = name, _ATOM
        if stores:
            beside = f" /* {' '.join(self.entries[row])} */" if row in self.entries else ""
            loop.lines.append(f"{' = '.join(stores)} = {self.text[row][0]};{beside}")

    def _claim(self, row: int) -> str:
        if row in self.names:
            return self.names[row]
        self.temporaries += 1
        return f"t{self.temporaries - 1}"

    def _expression(self, row: int) -> tuple[str, int]:
        """Write a row in terms of the texts of its arguments; return how tightly it binds, too."""
        op, args, value = self.program.rows[row]
        if isinstance(value, Fraction):
            return literal(value), _SIGN if value < 0 else _ATOM
        if op == "input":
            return self.names[row], _ATOM
        wrap = partial(self._wrapped, args)
        if op in ("add", "sub", "mul"):
            sign = {"add": "+", "sub": "-", "mul": "*"}[op]
            binding = _PRODUCT if op == "mul" else _SUM
            if op != "sub" and self._compound(args, binding):
                return f"{wrap(1, binding)} {sign} {wrap(0, binding + 1)}", binding
            exact = op == "mul" and self._power_of_two(args[0])  # so that the grouping makes no difference
            return f"{wrap(0, binding)} {sign} {wrap(1, binding + (not exact))}", binding
        if op == "inv":
            return f"1.0 / {wrap(0, _SIGN)}", _PRODUCT
        if op == "neg":
            return f"-{wrap(0, _SIGN)}", _SIGN
        if op == "select":
            return f"{wrap(0, _ATOM)} ? {wrap(1, _SUM)} : {wrap(2, _SUM)}", 0
        if op == "not":
            return f"!{wrap(0, _ATOM)}", _SIGN
        if op in ("and", "or"):
            return f"({wrap(0, _ATOM)} {'&&' if op == 'and' else '||'} {wrap(1, _ATOM)})", _ATOM
        return f"real_{op}({', '.join(self.text[arg][0] for arg in args)})", _ATOM

    def _compound(self, args: tuple[int, ...], binding: int) -> bool:
        """Whether a sum or product reads better with its second argument, itself such a one, in front."""
        constant = self.program.constant(args[0]) is not None
        return self.text[args[1]][1] == binding != self.text[args[0]][1] and not constant

    def _power_of_two(self, row: int) -> bool:
        value = self.program.constant(row)
        return (
            value is not None
            and value > 0
            and value.numerator * value.denominator & (value.numerator * value.denominator - 1) == 0
        )

    def _wrapped(self, args: tuple[int, ...], which: int, binding: int) -> str:
        text, own = self.text[args[which]]
        return text if own >= binding else f"({text})"


def print_kernel(derived: Derived, kernel: Kernel) -> FunctionBody:
    """Write the statements of a kernel.

    Parameters
    ----------
    derived : Derived
    kernel : Kernel
        One of its kernels.

    Returns
    -------
    FunctionBody
        Loops over j, the element's place in its block.
    """
    return _Printer(derived, kernel).body()
