"""Forward and reverse differentiation of a `Program`, row by row.

The derivatives of elementary functions come from SymPy, which differentiates each function's one short line once.
Tangents and adjoints are new rows of the same program, so that whatever they have in common with it, or with
each other, is computed once.
"""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from functools import cache
from heapq import heapify, heappop, heappush

import sympy as sp

from flexel.derive.declare.functions import FUNCTIONS
from flexel.derive.program.graph import CONDITIONS, LEAVES
from flexel.derive.program.lower import ProgramLowering
from flexel.derive.program.straight_line import Program

_Y, _Z = sp.symbols("y z", real=True)
_BY_NAME = {name: function for function, name in FUNCTIONS.items()}


@cache
def _derivatives(op: str) -> tuple[sp.Expr, ...]:
    """Return the partial derivatives of an elementary function of y (and z)."""
    if op == "sqrt":
        return (sp.diff(sp.sqrt(_Y), _Y),)
    if op == "atan2":
        return sp.diff(sp.atan2(_Y, _Z), _Y), sp.diff(sp.atan2(_Y, _Z), _Z)
    return (sp.diff(_BY_NAME[op](_Y), _Y),)


def partials(program: Program, number: int) -> list[tuple[int, int]]:
    """Return the arguments of a row, and the partial derivatives of the row with respect to them.

    Returns
    -------
    list of (argument, partial)
        Both are rows. An argument may occur twice; constants are left out.
    """
    p = program
    op, args, _ = p.rows[number]
    minus = p.const(-1)
    if op == "add":
        pairs = [(args[0], p.one), (args[1], p.one)]
    elif op == "sub":
        pairs = [(args[0], p.one), (args[1], minus)]
    elif op == "neg":
        pairs = [(args[0], minus)]
    elif op == "mul":
        pairs = [(args[0], args[1]), (args[1], args[0])]
    elif op == "inv":
        pairs = [(args[0], p.neg(p.mul(number, number)))]
    elif op == "select":
        condition, yes, no = args
        pairs = [(yes, p.select(condition, p.one, p.zero)), (no, p.select(condition, p.zero, p.one))]
    elif op in ("min", "max"):
        first = p.compare("le", *args) if op == "min" else p.compare("le", args[1], args[0])
        pairs = [(args[0], p.select(first, p.one, p.zero)), (args[1], p.select(first, p.zero, p.one))]
    elif op == "abs":
        pairs = [(args[0], p.select(p.compare("lt", args[0], p.zero), minus, p.one))]
    elif op == "pow":
        pairs = _power(p, number)
    else:
        lowering = ProgramLowering(p, dict(zip((_Y, _Z), args, strict=False)))
        pairs = [(arg, lowering.lower(d)) for arg, d in zip(args, _derivatives(op), strict=True)]
    return [(arg, partial) for arg, partial in pairs if p.constant(arg) is None]


def _power(p: Program, number: int) -> list[tuple[int, int]]:
    """Return the partials of y**z; z y**(z-1), unlike y**z z/y, is right at y = 0."""
    base, exponent = p.rows[number].args
    lower = p.call("pow", base, p.sub(exponent, p.one))
    pairs = [(base, p.mul(exponent, lower))]
    if p.constant(exponent) is None:
        pairs.append((exponent, p.mul(number, p.call("log", base))))
    return pairs


def forward(
    program: Program, outputs: Sequence[int], seeds: Mapping[int, int], inputs: Sequence[int] = ()
) -> list[int]:
    """Compute directional derivatives of the outputs.

    Parameters
    ----------
    program : Program
    outputs : sequence of int
        Rows to differentiate.
    seeds : mapping of int to int
        Tangents of inputs; all others are zero.
    inputs : sequence of int
        Rows that count as inputs, although they may depend on others: their tangents are the seeds.

    Returns
    -------
    list of int
        Their tangents; zero is the row ``program.zero``.
    """
    p = program
    tangents = {row: tangent for row, tangent in seeds.items() if tangent != p.zero}
    given = set(seeds).union(inputs)
    for number in p.reachable(outputs):
        op, args, _ = p.rows[number]
        if op in LEAVES or op in CONDITIONS or number in given:
            continue
        if not any(arg in tangents for arg in args):
            continue
        if op == "select":
            condition, yes, no = args
            tangent = p.select(condition, tangents.get(yes, p.zero), tangents.get(no, p.zero))
        elif op == "mul" and args[0] == args[1]:
            tangent = p.scale(Fraction(2), p.mul(args[0], tangents[args[0]]))
        else:
            tangent = p.sum(p.mul(d, tangents[a]) for a, d in partials(p, number) if a in tangents)
        if tangent != p.zero:
            tangents[number] = tangent
    return [tangents.get(number, p.zero) for number in outputs]


def gradient(program: Program, output: int, inputs: Sequence[int]) -> list[int]:
    """Compute the gradient of one row, in one reverse sweep.

    Parameters
    ----------
    program : Program
    output : int
        Row to differentiate.
    inputs : sequence of int
        Rows to differentiate by; they count as inputs, although they may depend on others.

    Returns
    -------
    list of int
        One row for each input.
    """
    p = program
    order = p.reachable([output])
    given, active = set(inputs), set(inputs)
    for number in order:
        if (
            number not in given
            and p.rows[number].op not in CONDITIONS
            and any(arg in active for arg in p.rows[number].args)
        ):
            active.add(number)
    adjoints = {output: p.one} if output in active else {}
    for number in reversed(order):
        adjoint = adjoints.get(number, p.zero)
        if adjoint == p.zero or number in given or p.rows[number].op in LEAVES:
            continue
        for arg, partial in partials(p, number):
            if arg in active:
                adjoints[arg] = p.add(adjoints.get(arg, p.zero), p.mul(adjoint, partial))
    return [adjoints.get(number, p.zero) for number in inputs]


class _Edges:
    """The graph of local partial derivatives between inputs and outputs, while vertices are eliminated from it."""

    def __init__(self, program: Program, outputs: Sequence[int], inputs: Sequence[int]) -> None:
        self.program = program
        self.into: dict[int, dict[int, int]] = {row: {} for row in inputs}  # vertex to {argument: partial}
        self.out: dict[int, set[int]] = {row: set() for row in inputs}  # vertex to its users
        for number in program.reachable(outputs):
            row = program.rows[number]
            if number in self.into or row.op in CONDITIONS or not any(arg in self.into for arg in row.args):
                continue
            self.into[number], self.out[number] = {}, set()
            for arg, partial in partials(program, number):
                if arg in self.into:
                    self.add(arg, number, partial)
        self.inner = [number for number in self.into if number not in set(inputs)]
        for i, number in enumerate(outputs):  # outputs are vertices of their own, numbered -1, -2, ...
            self.into[-1 - i] = {}
            if number in self.into:
                self.add(number, -1 - i, program.one)

    def add(self, start: int, end: int, partial: int) -> None:
        """Add to the partial derivative of a vertex by another."""
        total = self.program.add(self.into[end].get(start, self.program.zero), partial)
        if total == self.program.zero:
            self.into[end].pop(start, None)
            self.out[start].discard(end)
        else:
            self.into[end][start] = total
            self.out[start].add(end)

    def cost(self, vertex: int) -> int:
        """Count the multiplications and additions that it takes to eliminate a vertex."""
        into = self.into[vertex]
        constant = self.program.constant
        wide = sum(constant(partial) is None for partial in into.values())
        total = 0
        for user in self.out[vertex]:
            total += wide if constant(self.into[user][vertex]) is None else 0
            total += sum(argument in self.into[user] for argument in into)
        return total

    def eliminate(self, vertex: int) -> None:
        """Connect the users of a vertex with its arguments; the chain rule."""
        into = self.into.pop(vertex)
        for user in sorted(self.out.pop(vertex)):
            outer = self.into[user].pop(vertex)
            for argument, inner in into.items():
                self.add(argument, user, self.program.mul(outer, inner))
        for argument in into:
            self.out[argument].discard(vertex)


def elimination(program: Program, outputs: Sequence[int], inputs: Sequence[int]) -> list[list[int]]:
    """Compute derivatives of outputs by inputs, by eliminating intermediate rows in the order of their cost.

    The chain rule may be applied in any order; forward and reverse sweeps are two of them. Here the row that is
    cheapest to remove goes first (Griewank and Walther 2008, Evaluating Derivatives, ch. 9: Markowitz rule).
    """
    edges = _Edges(program, outputs, inputs)
    heap = [(edges.cost(vertex), vertex) for vertex in edges.inner]
    heapify(heap)
    while heap:
        cost, vertex = heappop(heap)
        if vertex not in edges.out:
            continue
        now = edges.cost(vertex)
        if heap and (now, vertex) > heap[0]:
            heappush(heap, (now, vertex))
            continue
        edges.eliminate(vertex)
    return [[edges.into[-1 - i].get(number, program.zero) for number in inputs] for i in range(len(outputs))]
