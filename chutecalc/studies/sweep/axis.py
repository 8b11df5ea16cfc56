"""The parameter along an axis of a picture or a chart, and where its values stand there."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from chutecalc.studies.sweep.parameters import AnyParameter, Parameter
from chutecalc.studies.sweep.text_parameter import TextParameter


def along(varied: Sequence[AnyParameter], parallel: bool) -> AnyParameter:
    """Return the parameter that lines are drawn over: of several the one of numbers, or of most values.

    Args:
        varied: the parameters of several values.
        parallel: whether their lists run side by side.
    """
    if parallel:
        return next((each for each in varied if isinstance(each, Parameter)), varied[0])
    return max(varied, key=lambda each: (isinstance(each, Parameter), len(each.values)))


def different(parameter: AnyParameter) -> list[Any]:
    """Return the values of a parameter, each once: names in their order, numbers from the smallest on.

    Args:
        parameter: the parameter.

    >>> different(Parameter("rate_t_h", (), np.array([2.0, 1.0, 2.0])))
    [1.0, 2.0]
    """
    values = list(dict.fromkeys(parameter.values.tolist()))
    return values if isinstance(parameter, TextParameter) else sorted(values)


def places(parameter: AnyParameter, values: Any) -> Any:
    """Return where values stand on an axis: names side by side in their order.

    Args:
        parameter: the parameter.
        values: names, or numbers in the parameter's unit.
    """
    if isinstance(parameter, Parameter):
        return values
    places = {name: place for place, name in enumerate(different(parameter))}
    return np.array([places[name] for name in values.tolist()])
