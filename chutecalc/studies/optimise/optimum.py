"""The best design of a problem, or the front of two objectives, and what is said of it."""

from dataclasses import dataclass
from typing import Any

from chutecalc.output.dataset import number, numbers
from chutecalc.studies.found import Found
from chutecalc.studies.limit import Limit
from chutecalc.studies.optimise.answer import KeyAnswer
from chutecalc.studies.optimise.binding import Binding
from chutecalc.studies.optimise.objective import NO_FAILURE, NO_WARNINGS, Objective
from chutecalc.studies.optimise.violation import Violation


@dataclass(frozen=True, repr=False, eq=False)
class Optimum(Found):
    """The best design, or the designs of a front of two objectives."""

    objectives: tuple[Objective, ...]
    """What is minimised or maximised: one, or two of a front."""
    limits: tuple[Limit, ...]
    """What it is subject to, in each state."""
    no_warnings: bool
    """Whether it is subject to having no warnings either."""
    worst: dict[str, Any]
    """Each objective in the worst state, an array of shape (designs,) by column."""
    binding: list[list[Binding]]
    """The limits that decide at each design; for a front in the problem of its first objective."""
    answers: dict[str, KeyAnswer]
    """What is said of each key; empty for a front."""
    violations: list[Violation]
    """What the design violates, worst first: where any, no design that was found keeps all limits; this is closest."""

    @property
    def feasible(self) -> bool:
        """Whether all limits hold in all states, and no state fails."""
        return not self.violations

    @property
    def subject(self) -> list[str]:
        """All that it is subject to, in each state."""
        return [*(limit.text for limit in self.limits), NO_FAILURE, *([NO_WARNINGS] if self.no_warnings else [])]

    def _described(self) -> str:
        """Return what was found, as text."""
        if not self.feasible:
            return f"Optimum of {self.objectives[0].column}: no feasible design"
        if len(self.objectives) > 1:
            return f"Front of {' and '.join(each.column for each in self.objectives)}: {self.count} designs"
        (name, value), *_ = self.worst.items()
        keys = ", ".join(
            f"{key} {answer.value:.6g}" if isinstance(answer.value, float) else f"{key} {answer.value}"
            for key, answer in self.answers.items()
        )
        return f"Optimum of {name}: {value[0]:.6g} at {keys}"

    def document(self) -> dict[str, Any]:
        """Return the problem, the best designs and their outcome, what decides, and what is said of the keys."""
        told = {
            "objectives": {each.column: "minimise" if each.sign > 0 else "maximise" for each in self.objectives},
            "subject": self.subject,
            "states": self.states,
            "feasible": self.feasible,
            "violations": [each.document() for each in self.violations],
        }
        answers = {
            name: {
                "on_bound": answer.bound or None,
                "change_per_unit": number(answer.change_per_unit),
                "within_1_per_cent": list(answer.range),
                "fails": [edge._asdict() for edge in answer.fails],
            }
            for name, answer in self.answers.items()
        }
        bound = [
            [
                each._asdict()
                | {"change_per_unit": number(each.change_per_unit), "edge": each.edge and each.edge._asdict()}
                for each in own
            ]
            for own in self.binding
        ]
        worst = {name: numbers(values) for name, values in self.worst.items()} if self.feasible else {}
        return told | super().document() | {"worst": worst, "binding": bound, "keys_at_optimum": answers}
