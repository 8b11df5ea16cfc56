"""The band of a chute's own assumptions."""

from chutecalc.api.chute import Chute, check_chute
from chutecalc.api.solve import solve
from chutecalc.errors import UsageError
from chutecalc.results.band import Band, Variant, variants_of


def solve_band(chute: Chute, rtol: float = 1e-10) -> Band:
    """Solve a chute under the assumptions that its model leaves open, as one batch.

    Args:
        chute: one chute.
        rtol: relative error allowed to the velocity, as for :func:`chutecalc.solve`.

    Returns:
        Least and largest velocity and depth over momentum factors of 1, 1.25 and 1.33 and longitudinal pressure ratios
        of 0, K_v and 1, in all combinations. It is a band of assumptions, not a confidence interval.

    Raises:
        UsageError: the chute has several designs.
        SpecError: as for :func:`chutecalc.solve`.

    >>> import chutecalc
    >>> band = chutecalc.solve_band(chutecalc.parse(chutecalc.STARTER))
    >>> [round(number, 3) for number in band.exit["velocity_m_s"]]
    [5.734, 6.222]
    """
    check_chute(chute)
    if chute.count != 1:
        raise UsageError(f"a band is that of one design, and this chute has {chute.count}: take one with `chute.put`")
    design = chute.design
    given = Variant(float(design.momentum_factor[0]), float(design.longitudinal_ratio[0]))
    variants = variants_of(given, float(design.vertical_ratio[0]))
    factors, ratios = zip(*variants, strict=True)
    changes = {"model.momentum_factor": list(factors), "model.longitudinal_pressure_ratio": list(ratios)}
    return Band(solve(chute.vary(changes), rtol), variants)
