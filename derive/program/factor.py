"""Fewer multiplications: common factors are taken out of sums, a b + a c = a (b + c).

Done for each kernel at the end, and only where the products are used nowhere else, so that nothing which is shared
gets lost.
"""

from collections import Counter
from collections.abc import Sequence

from flexel.derive.program.straight_line import Program

_SUMS = frozenset({"add", "sub", "neg"})

Term = tuple[bool, tuple[int, ...]]  # whether it is subtracted, and its factors


class _Factoring:
    def __init__(self, program: Program, outputs: Sequence[int]) -> None:
        self.program = program
        self.order = program.reachable(outputs)
        self.uses = Counter(arg for row in self.order for arg in program.rows[row].args)
        self.uses.update(outputs)
        self.new: dict[int, int] = {}

    def rebuild(self) -> None:
        """Find the new row of every row, arguments first."""
        inner = self._inner_rows()
        for row in self.order:
            if row in inner:
                continue
            op, args, value = self.program.rows[row]
            if op in _SUMS:
                self.new[row] = self._sum(self._terms(row))
            elif op == "mul":
                self.new[row] = self._product(self._factors(row))
            else:
                self.new[row] = self._plain(row, op, args)

    def _inner_rows(self) -> set[int]:
        """Find sums inside a sum and products inside a sum or product that are used only there."""
        inner: set[int] = set()
        for row in self.order:
            op, args, _ = self.program.rows[row]
            for arg in args:
                own = self.program.rows[arg].op
                absorbed = (own in _SUMS or own == "mul") if op in _SUMS else own == op == "mul"
                if absorbed and self.uses[arg] == 1 and arg not in self.program.names:
                    inner.add(arg)
        self.inner = inner
        return inner

    def _plain(self, row: int, op: str, args: tuple[int, ...]) -> int:
        p = self.program
        moved = tuple(self.new[arg] for arg in args)
        if moved == args:
            return row
        if op == "inv":
            return p.inv(*moved)
        if op == "select":
            return p.select(*moved)
        if op in ("lt", "le", "eq"):
            return p.compare(op, *moved)
        return p.logic(op, *moved) if op in ("and", "or", "not") else p.call(op, *moved)

    def _terms(self, row: int) -> list[Term]:
        """Return the terms of a sum, from left to right, down to terms that are used elsewhere or are not sums."""
        terms: list[Term] = []
        stack = [(row, False)]
        while stack:
            here, minus = stack.pop()
            op, args, _ = self.program.rows[here]
            if op in _SUMS and (here == row or here in self.inner):
                signs = [minus != (op == "neg"), minus != (op == "sub")]
                stack.extend(reversed(list(zip(args, signs, strict=False))))
            else:
                terms.append((minus, tuple(self._factors(here)) if here in self.inner else (self.new[here],)))
        return terms

    def _factors(self, row: int) -> list[int]:
        """Add rows of the factors of a product."""
        factors: list[int] = []
        stack = [row]
        while stack:
            here = stack.pop()
            op, args, _ = self.program.rows[here]
            if op == "mul" and (here == row or here in self.inner):
                stack.extend(reversed(args))
            else:
                factors.append(self.new[here])
        return factors

    def _product(self, factors: Sequence[int]) -> int:
        result = self.program.one
        for factor in factors:
            result = self.program.mul(result, factor)
        return result

    def _sum(self, terms: list[Term]) -> int:
        """Add up terms: the factor that most of them share is taken out, and so on with both parts."""
        p = self.program
        done: list[int] = []
        pending = [terms]
        while pending:
            terms = pending.pop()
            counts = Counter(factor for _, factors in terms for factor in dict.fromkeys(factors))
            factor, count = max(counts.items(), key=lambda item: (item[1], -item[0]), default=(p.zero, 0))
            if count < 2 or all(len(factors) == 1 for _, factors in terms):
                done += [p.neg(self._product(f)) if minus else self._product(f) for minus, f in terms]
                continue
            with_factor = [(minus, _without(f, factor)) for minus, f in terms if factor in f]
            flip = all(minus for minus, _ in with_factor)
            inside = self._sum([(minus != flip, f) for minus, f in with_factor])
            whole = p.mul(factor, inside)
            done.append(p.neg(whole) if flip else whole)
            pending.append([(minus, f) for minus, f in terms if factor not in f])
        return p.sum(done)


def _without(factors: tuple[int, ...], factor: int) -> tuple[int, ...]:
    """Return the factors without one of them."""
    where = factors.index(factor)
    return factors[:where] + factors[where + 1 :]


def factored(program: Program, outputs: Sequence[int]) -> list[int]:
    """Return rows that are equal to the outputs and take fewer operations, if there are such.

    Names are carried over to the new rows.
    """
    best = list(outputs)
    for _ in range(3):
        factoring = _Factoring(program, best)
        factoring.rebuild()
        tried = [factoring.new[row] for row in best]
        if program.operations(tried) >= program.operations(best):
            break
        for old, new in factoring.new.items():
            if old in program.names and program.rows[new].op not in ("const", "input", "neg"):
                program.names.setdefault(new, program.names[old])
        best = tried
    return best
