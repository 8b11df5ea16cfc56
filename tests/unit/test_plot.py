"""Pictures hold what the solution says: their lines, labels and numbers, not their pixels."""

import io
import itertools
import re
import tomllib

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patches import ArrowStyle
from matplotlib.text import Text

import chutecalc
from chutecalc.output.outcome import outcome
from chutecalc.output.plots.flights import STATIONS
from chutecalc.output.plots.layout import PANELS
from chutecalc.output.plots.notes import MOST_TOLD, by_weight
from chutecalc.output.plots.run import draw_run
from chutecalc.output.plots.save import PICTURE_FORMATS, save
from chutecalc.output.plots.style import colours
from chutecalc.results.columns import COLUMNS
from chutecalc.results.finding import Severity
from chutecalc.studies.friction.plot import draw_study
from chutecalc.studies.friction.study import FrictionStudy
from tests.conftest import ROOT, chute, spec

STEEP_FLOOR = [{"kind": "straight", "slope_deg": 60.0, "length_m": 5.0}]
CREST = {"kind": "curve", "name": "crest", "radius_m": 1.0, "to_slope_deg": 70.0}


def drawn(*chutes, units="metric"):
    states = [chutecalc.solve_cases(one) for one in chutes]
    figure = draw_run(states, units)
    return figure, {axes.get_label(): axes for axes in figure.axes}, [each["design"] for each in states]


def by_name(axes, gid):
    return [artist for artist in (*axes.lines, *axes.collections) if artist.get_gid() == gid]


def explained(axes):
    return {text.get_text() for text in axes["key"].get_legend().get_texts()}


def written(axes):
    return {text.get_text() for text in axes.texts}


def load(name):
    return chutecalc.load(ROOT / "specs" / f"{name}.toml")


FAILING = {
    "stall": chute(
        inlet={"velocity_m_s": 3.0, "slope_deg": 8.0},
        segments=[{"kind": "straight", "slope_deg": 8.0, "length_m": 9.0}],
    ),
    "contact_lost": chute(inlet={"velocity_m_s": 5.0, "slope_deg": 20.0}, segments=[CREST]),
    "missed": chute(
        inlet={"velocity_m_s": 2.0, "slope_deg": 0.0},
        segments=[
            {"kind": "fall", "onto_next": True},
            {"kind": "straight", "slope_deg": 40.0, "length_m": 1.0, "start_m": [9.0, -1.0]},
        ],
    ),
    "choke": chute(
        sections={"body": {"shape": "rectangular", "width_m": 0.5, "wall_height_m": 0.4}},
        inlet={"velocity_m_s": 3.0, "slope_deg": 5.0},
        segments=[{"kind": "straight", "slope_deg": 5.0, "length_m": 9.0}],
    ),
}


@pytest.mark.parametrize("units", ["metric", "us"])
@pytest.mark.parametrize("name", ["coal_hood_spoon", "ore_pass", "tapered_spoon"])
def test_panels_show_the_solutions_numbers_in_their_units(name, units):
    _, axes, (solution,) = drawn(load(name), units=units)
    stations = solution.stations(points=STATIONS)
    own = stations["segment"][0] != "receiver:flight"  # behind them comes the flight to the belt
    for column in PANELS:
        (line,) = by_name(axes[column], column)
        x, y = (COLUMNS[key].converted(stations[key][0, own], units) for key in ("s_m", column))
        assert np.array_equal(line.get_xdata()[: len(x)], x)
        assert np.array_equal(line.get_ydata()[: len(y)], y, equal_nan=True)
        unit = COLUMNS[column].unit_text(units)
        name = f"{COLUMNS[column].heading} {COLUMNS[column].symbol}".strip()
        assert axes[column].get_ylabel() == f"{name}, {unit}"
    long = "ft" if units == "us" else "m"
    assert axes["wear_w_m2"].get_xlabel().endswith(f"s, {long}")
    assert axes["side"].get_xlabel().endswith(f"x, {long}")
    assert axes["side"].get_ylabel() == f"height z, {long}"


def test_the_stream_stands_on_its_surface_at_its_depth_and_hangs_below_a_hood():
    _, axes, (solution,) = drawn(load("coal_hood_spoon"))
    stations = {name: values[0].reshape(-1, STATIONS) for name, values in solution.stations(points=STATIONS).items()}
    for band, part, side in zip(by_name(axes["side"], "stream"), (0, 2), (-1.0, 1.0), strict=True):
        at = {name: values[part] for name, values in stations.items()}
        corners = np.array([path.vertices[:4] for path in band.get_paths()])
        foot, top = corners[:, 0], corners[:, 3]
        assert np.allclose(foot, np.stack([at["x_m"], at["z_m"]], axis=1)[:-1], rtol=0, atol=1e-12)
        assert np.allclose(np.hypot(*(top - foot).T), at["depth_m"][:-1], rtol=1e-12)
        flow = np.diff(np.stack([at["x_m"], at["z_m"]], axis=1), axis=0)
        across = (top - foot) / at["depth_m"][:-1, None]
        # normal to the stream, but for the half station that a chord turns by
        assert np.abs((across * flow).sum(axis=1)).max() < 0.02 * np.hypot(*flow.T).max()
        assert (np.sign(across[:, 1]) == side).all()
        assert np.allclose(band.get_array(), 0.5 * (at["velocity_m_s"][1:] + at["velocity_m_s"][:-1]), rtol=1e-14)


def test_a_flight_off_a_surface_is_a_band_that_keeps_its_width():
    _, axes, (solution,) = drawn(load("coal_hood_spoon"))
    (flight,) = by_name(axes["side"], "flight")
    at = {name: values[0].reshape(-1, STATIONS) for name, values in solution.stations(points=STATIONS).items()}
    corners = np.array([path.vertices[:4] for path in flight.get_paths()])
    assert np.allclose(corners[:, 0], np.stack([at["x_m"][1], at["z_m"][1]], axis=1)[:-1], rtol=0, atol=1e-12)
    slope = np.radians(at["slope_deg"][0, -1])
    off = -at["depth_m"][0, -1] * np.array([np.sin(slope), np.cos(slope)])  # the hood's stream hangs below it
    assert np.allclose(corners[0, 3] - corners[0, 0], off, rtol=0, atol=1e-12)
    assert len(by_name(axes["side"], "edge")) == 2
    assert explained(axes) >= {"surface", "stream", "in flight", "impact and its incidence"}
    assert "in flight, path only" not in explained(axes)


def test_a_fall_from_the_inlet_is_its_path():
    _, axes, (solution,) = drawn(load("decline_belt"))
    (flight,) = by_name(axes["side"], "flight")
    stations = solution.stations(points=STATIONS)
    falls = stations["kind"][0] == "fall"
    path = np.stack([stations["x_m"][0], stations["z_m"][0]], axis=1)[falls]
    assert np.allclose([segment[0] for segment in flight.get_segments()], path[:-1], rtol=0, atol=1e-12)
    assert "in flight, path only" in explained(axes)


def test_the_receiving_belt_is_an_arrow_through_the_end_of_the_chute():
    _, axes, (solution,) = drawn(load("decline_belt"))
    (arrow,) = [patch for patch in axes["side"].patches if patch.get_gid() == "receiver"]
    (x0, z0), (x1, z1) = arrow._posA_posB
    assert np.degrees(np.arctan2(z0 - z1, x1 - x0)) == pytest.approx(18.0, rel=1e-12)
    x, z = solution.exit["x_m"][0], solution.exit["z_m"][0]
    assert x0 < x < x1
    assert (z - z0) / (x - x0) == pytest.approx((z1 - z0) / (x1 - x0), rel=1e-9)
    assert "belt, 4 m/s" in written(axes["side"])
    assert not [patch for patch in drawn(FAILING["stall"])[1]["side"].patches if patch.get_gid() == "receiver"]


def with_belt_at(**receiver):
    data = tomllib.loads((ROOT / "specs" / "belt_hood_spoon.toml").read_text(encoding="utf-8"))
    return chutecalc.parse(data | {"receiver": data["receiver"] | receiver})


@pytest.mark.parametrize(("plan", "heading"), [(0.0, 1.0), (120.0, -1.0)])
def test_a_stream_flies_on_to_a_belt_that_has_a_place(plan, heading):
    _, axes, (solution,) = drawn(with_belt_at(at_m=[3.0, -3.6], slope_deg=0.0, plan_angle_deg=plan))
    landing = [solution.receiver[f"landing_{name}_m"][0] for name in "xz"]
    *_, last = by_name(axes["side"], "flight")
    corners = np.array([path.vertices[:4] for path in last.get_paths()])
    assert np.allclose(corners[0, 0], [solution.exit["x_m"][0], solution.exit["z_m"][0]], rtol=0, atol=1e-12)
    assert np.allclose(corners[-1, 1], landing, rtol=0, atol=1e-9)
    assert corners[-1, 2, 1] == pytest.approx(-3.6, abs=1e-3)  # the other edge lands there too
    (arrow,) = [patch for patch in axes["side"].patches if patch.get_gid() == "receiver"]
    (x0, z0), (x1, z1) = arrow._posA_posB
    assert np.sign(x1 - x0) == heading
    assert (z0, z1) == pytest.approx((-3.6, -3.6), abs=1e-9)
    assert any(text.endswith("° in plan") for text in written(axes["side"])) == (plan != 0.0)


def test_a_belt_that_nothing_meets_is_drawn_where_it_is():
    _, axes, (solution,) = drawn(with_belt_at(at_m=[3.0, -2.6]))
    assert solution.status[0] == "missed"
    assert [patch for patch in axes["side"].patches if patch.get_gid() == "receiver"]
    assert len(by_name(axes["side"], "missed")) == 2


@pytest.mark.parametrize(("name", "gid", "height"), [("clinker_box", "roof", 0.3), ("fails/choke", "walls", 0.35)])
def test_roofs_and_tops_of_walls_are_parallel_to_the_floor(name, gid, height):
    _, axes, _ = drawn(load(name))
    floor, top = by_name(axes["side"], "surface")[0], by_name(axes["side"], gid)[0]
    off = np.stack([top.get_xdata() - floor.get_xdata(), top.get_ydata() - floor.get_ydata()])
    assert np.allclose(np.hypot(*off), height, rtol=1e-12)
    assert (off[1] > 0.0).all()
    assert explained(axes) & {"roof", "top of the walls"} == {{"roof": "roof", "walls": "top of the walls"}[gid]}


def test_impacts_are_marked_with_their_incidence():
    _, axes, (solution,) = drawn(load("impact_plate"))
    (marks,) = by_name(axes["side"], "impact")
    struck = [result for result in solution.segments if result.impact]
    assert [result.name for result in struck] == ["plate", "spoon"]
    assert np.array_equal(marks.get_xdata(), [result.entry["x_m"][0] for result in struck])
    assert {f"{result.impact['incidence_deg'][0]:.3g}°" for result in struck} <= written(axes["side"])
    assert len(by_name(axes["side"], "surface")) == 2  # the plate is drawn


def test_a_plate_is_a_point_in_the_panels():
    _, axes, (solution,) = drawn(load("impact_plate"))
    (point,) = by_name(axes["pressure_kpa"], "impact")
    assert point.get_ydata()[0] == pytest.approx(solution.segments["plate"].impact["pressure_kpa"][0], rel=1e-12)


def test_flights_are_shaded_in_every_panel_and_said_where_nothing_else_is():
    _, axes, (solution,) = drawn(load("belt_hood_spoon"))
    for name in PANELS:
        spans = [patch for patch in axes[name].patches if patch.get_gid() == "in flight"]
        flown = [solution.segments[each] for each in ("throw", "drop")]
        for span, flight in zip(spans, flown, strict=True):
            ends = span.get_path().get_extents(span.get_patch_transform()).intervalx  # a polygon in Matplotlib 3.8
            assert ends == pytest.approx([flight.entry["s_m"][0], flight.exit["s_m"][0]], abs=1e-12)
        assert ("in flight" in written(axes[name])) == (name != "velocity_m_s")


@pytest.mark.parametrize("status", ["missed", "contact_lost"])
def test_a_stream_that_nothing_catches_is_followed_in_the_side_view_and_in_the_velocity(status):
    _, axes, (solution,) = drawn(FAILING[status])
    (line,) = by_name(axes["velocity_m_s"], "missed")
    begin = solution.stations(points=STATIONS)
    last = np.flatnonzero(np.isfinite(begin["s_m"][0]))
    velocity = begin["velocity_m_s"][0, last[-1]] if last.size else solution.inlet["velocity_m_s"][0]
    level = begin["z_m"][0, last[-1]] if last.size else solution.inlet["z_m"][0]
    path = by_name(axes["side"], "missed")[0]
    fallen = level - path.get_ydata()
    assert line.get_ydata()[0] == pytest.approx(velocity, rel=1e-12)
    assert np.allclose(line.get_ydata() ** 2, velocity**2 + 2 * 9.80665 * fallen, rtol=1e-12)  # energy
    assert path.get_ydata()[-1] < min(surface.get_ydata().min() for surface in by_name(axes["side"], "surface"))


def test_one_scale_both_ways_and_one_scale_of_colour():
    figure, axes, _ = drawn(load("belt_hood_spoon"))
    figure.canvas.draw()
    assert axes["side"].get_aspect() == 1.0
    shades = {(artist.norm.vmin, artist.norm.vmax) for artist in axes["side"].collections}
    assert len(shades) == 1
    assert any(other.get_title() == "v, m/s" for other in figure.axes)
    assert by_name(axes["side"], "belt")


def test_surfaces_are_drawn_whole_where_the_stream_is_not():
    _, axes, _ = drawn(FAILING["stall"])
    (surface,) = by_name(axes["side"], "surface")
    x, z = surface.get_xdata(), surface.get_ydata()
    assert np.hypot(x[-1] - x[0], z[-1] - z[0]) == pytest.approx(9.0, rel=1e-12)


@pytest.mark.parametrize("status", FAILING)
def test_a_failing_chute_shows_where_it_ends(status):
    figure, axes, (solution,) = drawn(FAILING[status])
    assert solution.status[0] == status
    (end,) = by_name(axes["side"], "end")
    reached = solution.stations(points=STATIONS)
    last = np.flatnonzero(np.isfinite(reached["s_m"][0]))
    at = (end.get_xdata()[0], end.get_ydata()[0])
    if status == "missed":  # where it passes what it misses: on its way down, to the left of a start 9 m away
        path = by_name(axes["side"], "missed")[0].get_xydata()
        away = np.hypot(*(path - [9.0, -1.0]).T)
        assert at == tuple(path[away.argmin()])
    else:
        assert at == (reached["x_m"][0][last[-1]], reached["z_m"][0][last[-1]])
    notes = axes["notes"].texts[0].get_text()
    assert notes.startswith(f"status {status}\n1  failure {status}")
    assert bool(by_name(axes["side"], "missed")) == (status in ("missed", "contact_lost"))
    save(figure, io.BytesIO(), "svg")


def test_a_stream_at_a_crawl_neither_flattens_the_rest_nor_fills_the_picture():
    _, axes, (solution,) = drawn(chute(inlet={"velocity_m_s": 0.02, "slope_deg": 60.0}, segments=STEEP_FLOOR))
    depth = solution.stations(points=STATIONS)["depth_m"][0]
    assert axes["depth_m"].get_ylim()[1] < 0.5 * depth.max()
    assert axes["depth_m"].get_ylim()[1] > 6 * np.median(depth)
    (band,) = by_name(axes["side"], "stream")
    corners = np.array([path.vertices[:4] for path in band.get_paths()])
    heights = np.hypot(*(corners[:, 3] - corners[:, 0]).T)
    assert heights.max() < 0.3 * 5.0 < depth.max()
    assert heights[-1] == pytest.approx(depth[-2], rel=1e-12)
    assert "the stream is drawn to a depth of" in axes["notes"].texts[0].get_text()


def test_findings_have_numbers_at_their_places():
    _, axes, (solution,) = drawn(load("coal_hood_spoon"))
    findings = solution.findings()
    notes = axes["notes"].texts[0].get_text()
    numbers = [text for text in axes["side"].texts if text.get_text().isdigit()]
    assert [text.get_text() for text in numbers] == ["1", "2", "3"]
    for number, (mark, finding) in enumerate(zip(numbers, findings, strict=True), 1):
        assert f"{number}  {finding.severity} {finding.code}: {finding.segment}" in notes
        stations = solution.stations(points=STATIONS)
        nearest = np.nanargmin(np.abs(stations["s_m"][0] - finding.s_m[0]))
        assert mark.xy == (stations["x_m"][0][nearest], stations["z_m"][0][nearest])


def ramps(count):
    """Return a chute of straights that flatten, with many findings of few kinds."""
    straights = [
        {"kind": "straight", "slope_deg": float(a), "length_m": 0.1, "name": f"s{k}"}
        for k, a in enumerate(np.linspace(75.0, 15.0, count))
    ]
    return chute(inlet={"velocity_m_s": 5.0, "slope_deg": 76.0}, segments=straights)


def test_many_segments_are_not_named_and_what_is_not_told_is_counted():
    _, axes, (solution,) = drawn(ramps(61))
    assert len(solution.findings()) > MOST_TOLD
    assert not axes["velocity_m_s"].texts
    told = axes["notes"].texts[0].get_text().split("\n")
    entries = [line for line in told if re.search(r" (warning|note) \w+: ", line)]
    assert len(entries) == MOST_TOLD
    rest = next(re.match(r"and (\d+) more .*: see the report", line) for line in told if line.startswith("and "))
    assert int(rest[1]) == len(solution.findings()) - MOST_TOLD


def test_the_worst_of_each_kind_comes_first_and_one_place_has_one_number():
    _, axes, (solution,) = drawn(ramps(61))
    found = by_weight(solution.findings())
    order = list(Severity)
    assert [order.index(each.severity) for each in found] == sorted(order.index(each.severity) for each in found)
    for severity in order:
        own = [each for each in found if each.severity == severity]
        kinds = list(dict.fromkeys(each.code for each in own))
        for first, code in zip(own, kinds, strict=False):
            assert first.code == code
            assert first.badness[0] == max(each.badness[0] for each in own if each.code == code)
    told = found[:MOST_TOLD]
    numbers = [int(each) for text in axes["side"].texts for each in re.findall(r"\d+", text.get_text())]
    assert sorted(numbers) == list(range(1, len({round(each.s_m[0], 6) for each in told}) + 1))


def test_findings_of_one_place_share_its_number():
    _, axes, (solution,) = drawn(load("impact_plate"))
    notes = axes["notes"].texts[0].get_text()
    last = [each for each in solution.findings() if each.s_m[0] == solution.findings()[-1].s_m[0]]
    assert len(last) == 2
    assert f"3  warning {last[0].code}: " in notes
    assert f"\n    warning {last[1].code}: " in notes
    assert [text.get_text() for text in axes["side"].texts if text.get_text().isdigit()] == ["1", "2", "3"]


@pytest.mark.parametrize("units", ["metric", "us"])
@pytest.mark.parametrize("name", ["transfer_90", "rock_box", "pipe_two_bends", "impact_plate"])
def test_impacts_are_marked_in_the_panels_with_their_values(name, units):
    """Each at its place; those beyond the axis at its edge, and either way with the number."""
    _, axes, (solution,) = drawn(load(name), units=units)
    struck = [each for each in solution.trajectory.results if each.impact]
    assert struck
    for column in ("pressure_kpa", "wear_w_m2"):
        panel, converted = axes[column], COLUMNS[column].converted
        top = panel.get_ylim()[1]
        expected = sorted(
            (
                float(COLUMNS["s_m"].converted(each.entry["s_m"][0], units)),
                min(float(converted(each.impact[column][0], units)), top),
            )
            for each in struck
        )
        marks = [line.get_xydata() for line in (*by_name(panel, "impact"), *by_name(panel, "impact beyond"))]
        assert np.allclose(sorted(map(tuple, np.concatenate(marks))), expected, rtol=1e-12)
        for each in struck:
            value = float(each.impact[column][0])
            shown = COLUMNS[column].shown(value, units)
            assert shown + (" ↑" if converted(value, units) > top else "") in written(panel)
        (line,) = by_name(panel, column)
        assert np.nanmax(line.get_ydata()) > 0.2 * top  # an impact does not squash the rest


def test_an_impact_of_a_case_is_marked_too():
    _, axes, _ = drawn(load("transfer_90"))
    cases = chutecalc.solve_cases(load("transfer_90"))
    wet = cases["wet"].segments["spoon"]
    marks = np.concatenate([line.get_xydata() for line in by_name(axes["wear_w_m2"], "case impact")])
    assert np.isclose(marks, [wet.entry["s_m"][0], wet.impact["wear_w_m2"][0]], rtol=1e-12).all(axis=1).any()
    assert axes["wear_w_m2"].get_ylim()[1] > wet.impact["wear_w_m2"][0]


def test_every_segment_has_its_name_above_the_panels_and_names_keep_apart():
    figure, axes, _ = drawn(ramps(18))
    panel = axes["velocity_m_s"]
    assert [text.get_text() for text in panel.texts] == [f"s{k}" for k in range(18)]
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    boxes = [Text.get_window_extent(text, renderer) for text in panel.texts]
    for one, other in itertools.pairwise(boxes):
        assert one.x1 <= other.x0 + 1.0
    assert all(box.y0 >= panel.get_window_extent().y1 for box in boxes)


def test_a_name_without_room_stands_upright_at_its_segment():
    _, axes, _ = drawn(load("impact_plate"))
    turned = {text.get_text(): text.get_rotation() for text in axes["velocity_m_s"].texts}
    assert turned == {"throw": 0.0, "plate": 90.0, "drop": 0.0, "spoon": 0.0}


@pytest.mark.parametrize(("plan", "text"), [(90.0, "at 90° in plan, seen end on"), (60.0, "at 60° in plan"), (0.0, "")])
def test_the_receiving_belt_says_how_it_turns_in_plan(plan, text):
    _, axes, _ = drawn(with_belt_at(plan_angle_deg=plan))
    assert ", ".join(filter(None, ["belt, 5 m/s", text])) in written(axes["side"])
    (belt,) = [patch for patch in axes["side"].patches if patch.get_gid() == "receiver"]
    head = belt.get_arrowstyle()
    assert isinstance(head, ArrowStyle.BarAB) == (plan == 90.0)


@pytest.mark.parametrize(("error", "told"), [(1e-15, False), (1e-2, True)])
def test_a_picture_tells_only_an_error_that_it_could_show(error, told, monkeypatch):
    states = chutecalc.solve_cases(load("transfer_90"))
    for solution in states.solutions.values():
        monkeypatch.setattr(solution, "error_estimate", np.array([error]))
    axes = {each.get_label(): each for each in draw_run([states]).axes}
    assert ("error estimate" in axes["notes"].texts[0].get_text()) == told
    assert "error estimate" in outcome(states["design"], "metric")


@pytest.mark.parametrize(
    ("length", "slope", "where"), [(3.0, 85.0, "beside"), (3.0, 40.0, "around"), (6.0, 12.0, "below")]
)
def test_the_panels_stand_where_the_chute_leaves_room(length, slope, where):
    straight = {"kind": "straight", "slope_deg": slope, "length_m": length}
    inlet = {"velocity_m_s": 5.0, "slope_deg": slope}
    figure, axes, _ = drawn(chute(inlet=inlet, segments=[straight]))
    figure.canvas.draw()
    side, *panels = (axes[name].get_position() for name in ("side", *PANELS))
    beside = "".join("B" if panel.x0 > side.x1 else "." for panel in panels)
    under = "".join("U" if panel.y1 < side.y0 else "." for panel in panels)
    assert (beside, under) == {"beside": ("BBBB", "...."), "around": ("BB.B", "..UU"), "below": ("....", "UUUU")}[where]


def test_several_chutes_are_lines_to_compare():
    shapes = [load(f"paper/r{radius}_d30_{shape}") for radius in (1, 4) for shape in ("chamfered", "square")]
    figure, axes, solutions = drawn(*shapes)
    assert len({axes[column].get_xlim() for column in PANELS}) == 1
    assert figure.get_suptitle() == "Comparison: Paper, worked example, δ = 30°"
    for column in PANELS:
        for line, solution in zip(by_name(axes[column], column), solutions, strict=True):
            stations = solution.stations(points=STATIONS)
            assert np.array_equal(line.get_ydata(), stations[column][0], equal_nan=True)
    for line, solution in zip(by_name(axes["side"], "path"), solutions, strict=True):
        assert np.array_equal(line.get_xdata(), solution.stations(points=STATIONS)["x_m"][0])
    legend = [text.get_text() for text in figure.legends[0].get_texts()]
    assert legend == [f"R = {r} m, {s}" for r in (1, 4) for s in ("45° chamfers", "square corners")]
    lines = by_name(axes["velocity_m_s"], "velocity_m_s")
    looks = {(line.get_color(), line.get_linestyle(), line.get_marker()) for line in lines}
    assert len(looks) == 4
    assert [line.get_linestyle() for line in lines] == ["-", "--", "-", "--"]  # the shape, whatever the radius


def test_a_comparison_follows_what_misses_and_marks_where():
    _, axes, _ = drawn(load("fails/missed_spoon"), load("vee"))
    for name in ("side", "velocity_m_s"):
        (path,), (end,) = by_name(axes[name], "missed"), by_name(axes[name], "end")
        assert (end.get_xydata()[0] == path.get_xydata()).all(axis=1).any()
        assert end.get_color() == path.get_color()


@pytest.mark.parametrize(("count", "length"), [(8, 60), (2, 300)])
def test_the_legend_of_long_titles_stays_on_the_page_and_leaves_the_panels_their_room(count, length):
    data = tomllib.loads(chutecalc.STARTER)
    titles = [f"{number} " + length // 6 * "spoon " for number in range(count)]
    long, short = (
        drawn(*(chutecalc.parse(data | {"title": title}) for title in each))[0] for each in (titles, ["a", "b"])
    )
    for figure in (long, short):
        save(figure, io.BytesIO(), "png")  # lays it out
    page, legend = long.bbox, long.legends[0].get_window_extent()
    assert page.x0 <= legend.x0
    assert legend.x1 <= page.x1
    assert page.y0 <= legend.y0
    assert legend.y1 <= min(axes.get_window_extent().y0 for axes in long.axes)
    for axes, of_short in zip(long.axes, short.axes, strict=True):
        (width, height), (usual_width, usual_height) = (each.get_window_extent().size for each in (axes, of_short))
        assert width == pytest.approx(usual_width, abs=1.0)  # a pixel
        assert height >= usual_height - 1.0


def test_chutes_without_titles_go_by_their_files():
    data = spec()
    first, second = (chutecalc.parse(data, f"{name}.toml") for name in "ab")
    figure, *_ = drawn(first, second)
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["a.toml", "b.toml"]


def test_chutes_of_one_title_go_by_their_files_too():
    text = chutecalc.STARTER
    first, second = (chutecalc.parse(tomllib.loads(text), f"{name}.toml") for name in "ab")
    figure, *_ = drawn(first, second)
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["a.toml", "b.toml"]


@pytest.mark.parametrize("ending", PICTURE_FORMATS)
def test_the_same_picture_is_the_same_file(ending):
    def file():
        stream = io.BytesIO()
        save(drawn(load("tapered_spoon"))[0], stream, ending)
        return stream.getvalue()

    first = file()
    assert first == file()
    assert not re.search(rb"20\d\d-\d\d-\d\d|CreationDate", first)


def test_the_last_digit_of_the_layout_does_not_show(monkeypatch):
    """Its solver adds in another order in another process, and an SVG names things by the digits of their place."""
    whole, plain, nudged = ConstrainedLayoutEngine.execute, io.BytesIO(), io.BytesIO()

    def nudge(self, fig):
        whole(self, fig)
        for axes in fig.axes:
            axes.set_position([share * (1 + 4e-16) for share in axes.get_position(original=True).bounds])
            axes.set_in_layout(True)

    save(drawn(load("vee"))[0], plain, "svg")
    monkeypatch.setattr(ConstrainedLayoutEngine, "execute", nudge)
    save(drawn(load("vee"))[0], nudged, "svg")
    assert nudged.getvalue() == plain.getvalue()


def test_settings_of_the_user_do_not_show(tmp_path):
    import matplotlib

    plain, changed = io.BytesIO(), io.BytesIO()
    save(drawn(load("vee"))[0], plain, "svg")
    with matplotlib.rc_context({"font.size": 30, "axes.facecolor": "red", "lines.linewidth": 9}):
        save(drawn(load("vee"))[0], changed, "svg")
    assert changed.getvalue() == plain.getvalue()


def test_colours_differ_in_lightness():
    from matplotlib.colors import to_rgb

    light = [np.dot(to_rgb(colour), (0.2126, 0.7152, 0.0722)) for colour in colours(6)]
    assert (np.diff(light) > 0.03).all()


@pytest.mark.parametrize("keep", ["base", "width", "depth"])
def test_the_friction_study_is_drawn_as_its_rows_say(keep):
    study = FrictionStudy(keep=keep)
    axes = {each.get_label(): each for each in draw_study(study).axes}
    lines = by_name(axes["friction"], "friction")
    for line, delta in zip(lines, study.internal_friction_deg, strict=True):
        rows = study.line(delta)
        assert np.array_equal(line.get_xdata(), rows["chamfer_deg"])
        assert np.array_equal(line.get_ydata(), rows["equivalent_friction"])
        assert line.get_label() == f"δ = {delta:g}°"
    assert len({(line.get_color(), line.get_linestyle(), line.get_marker()) for line in lines}) == 6
    inside = [(best.inside_deg, best.inside_friction) for best in study.best() if np.isfinite(best.inside_deg)]
    (stars,) = by_name(axes["friction"], "best")
    assert np.array_equal(np.transpose([stars.get_xdata(), stars.get_ydata()]), inside)
    assert axes["friction"].get_xlabel() == "chamfer angle β, °"
    assert axes["friction"].get_ylabel() == r"equivalent friction μ$_{\mathrm{e}}$"
    for line in by_name(axes["sections"], "section"):
        x, z = line.get_xdata(), line.get_ydata()
        area = 0.5 * (x[3] - x[0] + x[2] - x[1]) * (z[0] - z[1])
        assert area == pytest.approx(study.area_m2, rel=1e-12)


def test_a_study_of_nothing_possible_is_drawn_empty():
    study = FrictionStudy([10], [30], keep="width")
    figure = draw_study(study)
    save(figure, io.BytesIO(), "svg")
    axes = {each.get_label(): each for each in figure.axes}
    assert not axes["sections"].lines
    assert not axes["sections"].patches
    (line,) = by_name(axes["friction"], "friction")
    assert line.get_xdata().size == 0
    assert by_name(axes["friction"], "best") == []
    (wall,) = by_name(axes["friction"], "wall")
    assert wall.get_ydata() == pytest.approx([np.tan(np.radians(study.wall_friction_deg))] * 2)
    assert [text.get_text() for text in axes["friction"].get_legend().get_texts()] == ["δ = 30°", "tan φ"]
