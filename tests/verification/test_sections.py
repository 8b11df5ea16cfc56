"""Circular and faceted sections, pressures on all walls, tapers: each against another method."""

import numpy as np
import pytest
from scipy.integrate import quad

import chutecalc
from chutecalc.physics.pressure import pressure_ratio
from chutecalc.physics.section import Circle, Polygon
from chutecalc.physics.wetting import area_at_depth, wetting
from tests.conftest import chute

OPEN = np.array([np.inf])


def polygon(base, *sides):
    """Return a section of facets, each with its length and its inclination in degrees."""
    lengths, angles = zip(*sides, strict=True) if sides else ((), ())
    return Polygon(
        base=np.array([base]),
        lengths=tuple(np.array([length]) for length in lengths),
        inclinations=tuple(np.radians([angle]) for angle in angles),
        wall_height=OPEN,
    )


def pipe(radius):
    return Circle(radius=np.array([radius]), wall_height=OPEN)


def wet(section, ratio, depth):
    area = area_at_depth(section, np.array([depth]))
    return area, wetting(section, np.array([ratio]), area)


def ring(radius, sides):
    """Return a polygon around the lower half circle, drawn through points at equal angles."""
    angles = np.linspace(0.0, np.pi / 2, sides + 1)
    slopes = 0.5 * (angles[1:] + angles[:-1])
    length = 2.0 * radius * np.sin(0.25 * np.pi / sides)
    return Polygon(
        base=np.zeros(1),
        lengths=(np.array([length]),) * sides,
        inclinations=tuple(np.array([slope]) for slope in slopes),
        wall_height=OPEN,
    )


@pytest.mark.parametrize("depth", [0.02, 0.2, 0.4, 0.7])
def test_a_circle_is_the_limit_of_polygons(depth):
    errors = []
    for sides in (40, 80):
        area, circle = wet(pipe(0.4), 0.25, depth)
        close, many = wet(ring(0.4, sides), 0.25, depth)
        errors.append(
            [
                abs(close[0] / area[0] - 1),
                abs(many.excess[0] / circle.excess[0] - 1),
                abs(many.chamfer[0] / circle.chamfer[0] - 1),
            ]
        )
    coarse, fine = np.array(errors)
    assert (fine < 0.5 * coarse).all() or (fine < 1e-3).all()  # second order where the depth meets a corner
    assert (fine < (0.02 if depth < 0.1 else 2e-3)).all()


def test_a_liquid_in_a_half_pipe_and_above_it():
    # K = 1: χ = (1/A) ∫ (1 - cos ψ) ζ dl; half full it is 4/π - 1
    area, found = wet(pipe(0.5), 1.0, 0.5)
    below = wetting(pipe(0.5), np.ones(1), area * (1 - 1e-15))
    for one in (found, below):
        assert one.excess[0] == pytest.approx(4 / np.pi - 1, rel=1e-14)
    # h above it: walls add h² and every element of the arc h more
    h = 0.3
    area, found = wet(pipe(0.5), 1.0, 0.5 + h)
    half = 0.5 * np.pi * 0.25
    exact = ((4 / np.pi - 1) * half + 2 * h * 0.5 * (np.pi / 2 - 1) + h * h) / (half + h)
    assert area[0] == pytest.approx(half + h, rel=1e-14)
    assert found.excess[0] == pytest.approx(exact, rel=1e-13)


@pytest.mark.parametrize("depth", [1e-6, 0.01, 0.15, 0.299, 0.3, 0.31, 0.9])
def test_a_circle_by_integration(depth):
    radius, ratio = 0.3, 0.22
    area, found = wet(pipe(radius), ratio, depth)
    top = min(depth, radius)
    angle = 2 * np.arcsin(np.sqrt(0.5 * top / radius))
    above = depth - top

    def zeta(psi):
        return 2 * radius * np.sin(0.5 * (angle + psi)) * np.sin(0.5 * (angle - psi)) + above

    def load(weight):
        return 2 * radius * quad(lambda psi: pressure_ratio(psi, ratio) * weight(psi) * zeta(psi), 0, angle)[0]

    drawn = radius**2 * 2 * quad(lambda psi: np.sin(psi) ** 2, 0, angle)[0] + 2 * radius * above
    excess = load(lambda psi: 2 * np.sin(psi / 2) ** 2) + ratio * above**2
    carried = load(np.cos)
    # quad gives 1e-14 of what it integrates
    assert area[0] == pytest.approx(drawn, rel=1e-11)
    assert found.depth[0] == pytest.approx(depth, rel=1e-12)
    assert found.chamfer[0] == pytest.approx(radius * angle, rel=1e-12)
    assert found.width[0] == pytest.approx(2 * radius * np.sin(angle), rel=1e-11)
    assert found.excess[0] == pytest.approx(excess / drawn, rel=1e-10)
    assert found.missing_load[0] == pytest.approx(1 - carried / drawn, abs=1e-11)


def test_facets_are_chamfer_vee_and_rectangle():
    common = {"inlet": {"velocity_m_s": 2.0, "slope_deg": 50.0}, "segments": [STRAIGHT]}
    pairs = [
        (
            {"shape": "chamfered", "base_m": 0.5, "chamfer_deg": 40.0, "chamfer_m": 0.1},
            [{"length_m": 0.25, "slope_deg": 0.0}, {"length_m": 0.1, "slope_deg": 40.0}],
        ),
        ({"shape": "vee", "chamfer_deg": 40.0, "chamfer_m": 0.2}, [{"length_m": 0.2, "slope_deg": 40.0}]),
        (
            {"shape": "rectangular", "width_m": 0.5},
            [{"length_m": 0.25, "slope_deg": 0.0}, {"length_m": 0.1, "slope_deg": 90.0}],
        ),
    ]
    for section, sides in pairs:
        one = chutecalc.solve(chute(sections={"body": section}, **common))
        same = chutecalc.solve(chute(sections={"body": {"shape": "facets", "facets": sides}}, **common))
        assert same.exit_velocity[0] == pytest.approx(one.exit_velocity[0], rel=1e-13)
        assert same.exit_depth[0] == pytest.approx(one.exit_depth[0], rel=1e-12)


STRAIGHT = {"kind": "straight", "slope_deg": 50.0, "length_m": 6.0}


def test_a_facet_cut_in_two_changes_nothing():
    whole = [{"length_m": 0.2, "slope_deg": 0.0}, {"length_m": 0.3, "slope_deg": 35.0}]
    cut = [whole[0], {"length_m": 0.04, "slope_deg": 35.0}, {"length_m": 0.26, "slope_deg": 35.0}]
    inlet = {"velocity_m_s": 1.0, "slope_deg": 50.0}
    plain, divided = (
        chutecalc.solve(
            chute(sections={"body": {"shape": "facets", "facets": sides}}, inlet=inlet, segments=[STRAIGHT])
        )
        for sides in (whole, cut)
    )
    assert plain.exit_velocity[0] == pytest.approx(divided.exit_velocity[0], rel=2e-12)  # cut where no kink is


SECTIONS = {
    "rectangle": polygon(0.5),
    "chamfer": polygon(0.5, (0.15, 45.0)),
    "steep": polygon(0.3, (0.2, 89.0)),
    "facets": polygon(0.2, (0.1, 20.0), (0.1, 60.0)),
    "vee": polygon(0.0, (0.3, 50.0)),
    "circle": pipe(0.3),
}


def elements(section, depth):
    """Yield the wetted walls of one side: width, inclination, ζ at their feet and tops, or the half-angle of an arc."""
    foot = 0.0
    sides = [(9.0, np.pi / 2)]
    if isinstance(section, Polygon):
        sides = [(float(one[0]), float(psi[0])) for one, psi in zip(section.lengths, section.inclinations, strict=True)]
        sides.append((9.0, np.pi / 2))
    else:
        foot = float(section.radius[0])
    for length, psi in sides:
        top = min(foot + length * np.sin(psi), depth)
        if top > foot:
            yield psi, depth - foot, depth - top
        foot += length * np.sin(psi)


def pressures(name, ratio, area, equilibrium):
    """On floor, chamfers and side walls at ρ n = 1, as a solved chute shows them where a stream of an area enters."""
    section = SECTIONS[name]
    drawn = {"shape": "rectangular", "width_m": 0.5}
    if isinstance(section, Circle):
        drawn = {"shape": "circular", "radius_m": float(section.radius[0])}
    elif section.lengths:
        sides = zip(section.lengths, np.degrees(section.inclinations), strict=True)
        facets = [{"length_m": float(length[0]), "slope_deg": float(slope[0])} for length, slope in sides]
        level = [{"length_m": 0.5 * float(section.base[0]), "slope_deg": 0.0}] if section.base[0] else []
        drawn = {"shape": "facets", "facets": level + facets}
    solution = chutecalc.solve(
        chute(
            flow={"rate_t_h": 3.6 * 1000.0 * area * 2.0},
            material={"density_kg_m3": 1000.0, "pressure_ratio": ratio},
            model={"friction_law": "equilibrium" if equilibrium else "paper"},
            sections={"body": drawn},
            inlet={"velocity_m_s": 2.0, "slope_deg": 50.0},
            segments=[STRAIGHT],
        )
    )
    entry = solution.segments[0].entry
    names = ("pressure_kpa", "chamfer_pressure_kpa", "side_pressure_kpa")
    return [entry[name][0] / entry["normal_acceleration_m_s2"][0] for name in names]


@pytest.mark.parametrize("equilibrium", [False, True])
@pytest.mark.parametrize("depth", [0.01, 0.1, 0.5])
@pytest.mark.parametrize("name", SECTIONS)
def test_the_books_close(name, depth, equilibrium):
    """∫ μ p v dl over the wetted walls is μ_e ρ n A v, with pressures that fall from those at the walls' feet."""
    section, ratio = SECTIONS[name], 0.3
    area, _ = wet(section, ratio, depth)
    excess = wetting(section, np.array([ratio]), area, equilibrium).excess
    floor, chamfer, side = pressures(name, ratio, float(area[0]), equilibrium)
    feet = [(chamfer if psi < np.pi / 2 else side, psi, below, above) for psi, below, above in elements(section, depth)]
    for drawn, pressure in ((True, chamfer), (False, side)):
        feet_of_kind = [pressure_ratio(psi, ratio) * below for _, psi, below, _ in feet if (psi < np.pi / 2) == drawn]
        if feet_of_kind:  # the reported pressure is the greatest of its kind
            scale = pressure / max(feet_of_kind)
    if isinstance(section, Circle):
        radius = float(section.radius[0])
        angle, dry = np.arccos(1 - min(depth / radius, 1.0)), max(depth - radius, 0.0)
        scale = floor / depth
        borne = 2 * radius * quad(
            lambda psi: scale * pressure_ratio(psi, ratio) * (radius * (np.cos(psi) - np.cos(angle)) + dry), 0, angle
        )[0]  # fmt: skip
    else:
        borne = float(section.base[0]) * floor
    for _, psi, below, above in feet:
        borne += 2 * scale * pressure_ratio(psi, ratio) * (below**2 - above**2) / 2 / np.sin(psi)
    assert borne == pytest.approx((1 + excess[0]) * area[0], rel=1e-10)


def test_friction_on_the_walls_as_shown_is_what_slows_the_stream():
    """In a solved chute, from its columns alone: the force of friction a metre is μ_e ρ n A."""
    angle, base = np.radians(45.0), 0.05
    chamfers = {"body": {"shape": "chamfered", "base_m": base, "chamfer_deg": 45.0}}
    at = chutecalc.solve(chute(sections=chamfers, inlet={"velocity_m_s": 3.0, "slope_deg": 50.0}, segments=[STRAIGHT]))
    at = {name: values[0] for name, values in at.stations(points=5).items() if name not in ("segment", "kind")}
    wetted = at["depth_m"] / np.sin(angle)
    force = np.tan(np.radians(25.0)) * (base * at["pressure_kpa"] + 2 * wetted * at["chamfer_pressure_kpa"] / 2)
    weight = 0.8 * at["normal_acceleration_m_s2"] * at["area_m2"]
    assert np.allclose(force, at["equivalent_friction"] * weight, rtol=1e-13)


@pytest.mark.parametrize("law", ["paper", "equilibrium"])
def test_pressures_stay_finite_as_the_floor_vanishes(law):
    """The flank of a floor of 10 mm, of 1 mm and of none: one pressure to the first order in the width."""
    found = []
    for base in (1e-2, 1e-3, 0.0):
        body = {"shape": "chamfered", "base_m": base, "chamfer_deg": 45.0}
        inlet = {"velocity_m_s": 4.0, "slope_deg": 50.0}
        solution = chutecalc.solve(
            chute(sections={"body": body}, model={"friction_law": law}, inlet=inlet, segments=[STRAIGHT])
        )
        found.append({name: float(values[0]) for name, values in solution.segments[0].entry.items()})
    _, narrow_floor, no_floor = found
    wide, narrow, none = (entry["chamfer_pressure_kpa"] for entry in found)
    assert abs(wide / none - 1) < 1e-1
    assert abs(narrow / none - 1) < 1e-2
    ratio = pressure_ratio(np.radians(45.0), (1 - np.sin(np.radians(50.0))) / (1 + np.sin(np.radians(50.0))))
    assert narrow_floor["pressure_kpa"] == pytest.approx(narrow / ratio, rel=1e-12)
    depth, normal = no_floor["depth_m"], no_floor["normal_acceleration_m_s2"]
    missing = 1 - ratio  # of a vee; both laws carry (1 + χ) N by 1/(1 - m) or (1 + χ)/(1 + χ - m)
    excess = ratio * (1 / np.cos(np.radians(45.0)) - 1)
    factor = 1 / (1 - missing) if law == "equilibrium" else (1 + excess) / (1 + excess - missing)
    assert none == pytest.approx(factor * ratio * 0.8 * normal * depth, rel=1e-12)
    assert no_floor["pressure_kpa"] == none


def test_equilibrium_in_a_vee_is_one_over_cosine():
    sections = {"body": {"shape": "vee", "chamfer_deg": 45.0}}
    inlet = {"velocity_m_s": 4.0, "slope_deg": 50.0}
    model = {"friction_law": "equilibrium"}
    solution = chutecalc.solve(chute(sections=sections, model=model, inlet=inlet, segments=[STRAIGHT]))
    exact = np.tan(np.radians(25.0)) / np.cos(np.radians(45.0))
    assert solution.exit["equivalent_friction"][0] == pytest.approx(exact, rel=1e-14)
    pull = 9.80665 * (np.sin(np.radians(50.0)) - exact * np.cos(np.radians(50.0)))
    assert solution.exit_velocity[0] == pytest.approx(np.sqrt(16.0 + 2 * pull * 6.0), rel=1e-13)


def tapered(pieces, **more):
    """Return a taper, or the same as constant sections each of its piece's middle."""
    wide = {"base_m": 0.8, "chamfer_deg": 40.0, "chamfer_m": 0.10}
    narrow = {"base_m": 0.3, "chamfer_deg": 60.0, "chamfer_m": 0.20}
    shape = {"shape": "chamfered"}
    inlet = {"velocity_m_s": 3.0, "slope_deg": 50.0}
    if not pieces:
        sections = {"wide": shape | wide, "narrow": shape | narrow}
        segments = [STRAIGHT | {"section": ["wide", "narrow"]}]
        return chute(sections=sections, inlet=inlet, segments=segments, **more)
    shares = (np.arange(pieces) + 0.5) / pieces
    sections = {
        f"s{k}": shape | {key: wide[key] + share * (narrow[key] - wide[key]) for key in wide}
        for k, share in enumerate(shares)
    }
    segments = [STRAIGHT | {"length_m": 6.0 / pieces, "section": name} for name in sections]
    return chute(sections=sections, inlet=inlet, segments=segments, **more)


@pytest.mark.parametrize("rate", [300.0, 3000.0])
def test_a_taper_is_the_limit_of_many_constant_pieces(rate):
    flow = {"rate_t_h": rate}
    taper = chutecalc.solve(tapered(0, flow=flow)).exit_velocity[0]
    errors = [abs(chutecalc.solve(tapered(n, flow=flow)).exit_velocity[0] / taper - 1) for n in (8, 16, 32)]
    assert errors[-1] < 2e-4
    # the midpoint rule is of second order, but for the pieces in which the depth passes a chamfer's top
    assert errors[0] / errors[-1] > 8.0
    extrapolated = (4 * errors[2] - errors[1]) / 3
    assert extrapolated < 1e-5


def test_a_taper_between_equal_sections_is_no_taper():
    same = {"shape": "circular", "radius_m": 0.4}
    segments = [STRAIGHT | {"section": ["one", "two"]}]
    taper = chutecalc.solve(chute(sections={"one": same, "two": dict(same)}, segments=segments))
    plain = chutecalc.solve(chute(sections={"one": same}, segments=[STRAIGHT]))
    assert taper.exit_velocity[0] == pytest.approx(plain.exit_velocity[0], rel=1e-13)


def test_the_depth_along_a_taper_is_that_of_the_section_there():
    solution = chutecalc.solve(tapered(0))
    for share, depth in zip(np.linspace(0, 1, 5), solution.stations(points=5)["depth_m"][0], strict=True):
        area = solution.stations(points=5)["area_m2"][0][round(share * 4)]
        base, slope, length = 0.8 - 0.5 * share, np.radians(40.0 + 20.0 * share), 0.1 + 0.1 * share
        section = Polygon(
            base=np.array([base]),
            lengths=(np.array([length]),),
            inclinations=(np.array([slope]),),
            wall_height=OPEN,
        )
        assert area_at_depth(section, np.array([depth]))[0] == pytest.approx(area, rel=1e-12)


def test_a_taper_chokes_where_its_falling_wall_is_passed():
    sections = {
        "high": {"shape": "rectangular", "width_m": 0.5, "wall_height_m": 0.5},
        "low": {"shape": "rectangular", "width_m": 0.5, "wall_height_m": 0.1},
    }
    # a vee-free case with constant friction: no wall friction at all, v² = v0² + 2 g sin a s
    solution = chutecalc.solve(
        chute(
            sections=sections,
            liners={"wall": {"friction_deg": 0.0}},
            inlet={"velocity_m_s": 3.0, "slope_deg": 5.0},
            segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 4.0, "section": ["high", "low"]}],
        )
    )
    s = solution.findings()[0].s_m[0]
    flow = 1000 / 3.6 / 800
    velocity = np.sqrt(9 + 2 * 9.80665 * np.sin(np.radians(5.0)) * s)
    assert solution.status[0] == "choke"
    assert flow / velocity / 0.5 == pytest.approx(0.5 - 0.4 * s / 4.0, rel=1e-9)


def test_a_level_facet_is_the_centre_section_also_beside_one_that_is_none():
    """In a batch and along a taper a facet may be level here and not there."""
    straight = {"kind": "straight", "slope_deg": 40.0, "length_m": 3.0}
    alike = {"shape": "chamfered", "base_m": 0.4, "chamfer_deg": 45.0, "chamfer_m": 0.3}

    def dish(slope):
        return {
            "shape": "facets",
            "facets": [{"length_m": 0.2, "slope_deg": slope}, {"length_m": 0.3, "slope_deg": 45.0}],
        }

    flat, dished = dish(0.0), dish(5.0)
    alone = chute(sections={"body": flat}, segments=[straight])
    chamfered = chutecalc.solve(chute(sections={"body": alike}, segments=[straight])).stations()
    both = chutecalc.solve(alone.vary({"sections.body.facets.1.slope_deg": [0.0, 5.0]})).stations()
    own = chutecalc.solve(alone).stations()
    tilted = chutecalc.solve(chute(sections={"body": dished}, segments=[straight])).stations()
    for name, values in own.items():
        if values.dtype.kind == "f":
            assert np.array_equal(both[name][0], values[0], equal_nan=True), name
            assert np.array_equal(both[name][1], tilted[name][0], equal_nan=True), name
            assert values[0] == pytest.approx(chamfered[name][0], rel=1e-12, nan_ok=True), name

    def end(*sections):
        names = dict(zip(("one", "other"), sections, strict=True))
        return chutecalc.solve(chute(sections=names, segments=[straight | {"section": list(names)}])).exit_velocity[0]

    # Along the line through slopes of 0.1° and 0.2°, whose squares are 1e-5: nothing less is a slope.
    nearly = [dish(0.1), dish(0.2)]
    for at_flat, (one, two) in (
        (end(flat, dished), [end(each, dished) for each in nearly]),
        (end(dished, flat), [end(dished, each) for each in nearly]),
    ):
        assert at_flat == pytest.approx(2 * one - two, rel=1e-5)
        assert at_flat != one
