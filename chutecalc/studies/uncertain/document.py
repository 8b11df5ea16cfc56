"""An uncertain chute as a document, and its samples as rows."""

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from chutecalc.output.dataset import Block, Dataset, number, numbers
from chutecalc.studies.uncertain.outcome import Outcome
from chutecalc.studies.uncertain.quantiles import quantiles_of
from chutecalc.studies.uncertain.sampling import REPLICATES
from chutecalc.studies.uncertain.statistics import SHARES, STATUSES, Chance

ROWS = 1 << 16
"""Rows of a block of samples in files."""


def uncertainty_dataset(result: Outcome) -> Dataset:
    """Return the samples as rows, and what they say as a document.

    Args:
        result: the study.
    """
    columns = dict.fromkeys(result.keys.paths, float) | {"status": str} | dict.fromkeys(result.columns, float)

    def blocks() -> Iterator[Block]:
        for first in range(0, result.count, ROWS):
            block = slice(first, first + ROWS)
            status = np.array(STATUSES)[result.ends[block]]
            given = {name: values[block] for name, values in (result.values | result.columns).items()}
            yield {name: status if name == "status" else given[name] for name in columns}

    asked = {"source": result.chute.source, "spec": result.chute.data, "case": result.case, "tolerance": result.rtol}
    asked |= {"samples": result.count, "replicates": REPLICATES, "seed": result.seed}
    return Dataset("uncertain", columns, blocks(), asked, lambda: asked | uncertainty_document(result))


def uncertainty_document(result: Outcome) -> dict[str, Any]:
    """Return what a study says, as the entries of its document after what was asked.

    Args:
        result: the study.
    """
    alone = result.tornado
    return {
        "keys": [
            {
                "path": key.path,
                "value": number(key.parameter.value_in_unit),
                "distribution": key.scatter.kind,
                "numbers": list(key.scatter.numbers),
                "cut_off": quantiles_of(key).outside,
                "quantiles": numbers(np.quantile(result.values[key.path], SHARES)),
            }
            for key in result.keys.keys
        ],
        "correlation": result.keys.correlation.tolist(),
        "shares": list(SHARES),
        "columns": {
            name: {
                "mean": number(own.mean),
                "mean_error": number(own.error),
                "standard_deviation": number(own.deviation),
                "quantiles": numbers(own.quantiles),
                "quantile_errors": numbers(own.quantile_errors),
                "spec": number(alone.spec[name]),
                "alone": [numbers(ends) for ends in alone.columns[name]],
            }
            for name, own in result.summaries.items()
        },
        "chances": _chances(result.chances),
        "exceeded": _chances(result.exceeded),
        "warnings": None if result.warned is None else _chances(result.warned),
        "indices": {
            name: {key: numbers(values) for key, values in own._asdict().items()}
            for name, own in result.indices.items()
        },
        "no_indices": result.no_indices or None,
    }


def _chances(chances: Mapping[str, Chance]) -> dict[str, Any]:
    """Return chances by what they are of."""
    return {
        name: {"share": number(own.share), "error": number(own.error), "at_most": own.at_most}
        for name, own in chances.items()
    }
