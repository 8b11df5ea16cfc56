"""Pictures hold what the solution says: their lines, labels and numbers, not their pixels."""

import io
import re
import tomllib

import numpy as np
import pytest

import chutecalc
from chutecalc.output.plots.run import PANELS, draw_run
from chutecalc.output.plots.save import PICTURE_FORMATS, save
from chutecalc.output.plots.style import colours
from chutecalc.output.plots.traces import STATIONS
from chutecalc.results.columns import COLUMNS
from chutecalc.studies.friction.plot import draw_study
from chutecalc.studies.friction.study import FrictionStudy
from tests.conftest import ROOT, chute, spec

STEEP_FLOOR = [{"kind": "straight", "slope_deg": 60.0, "length_m": 5.0}]
CREST = {"kind": "curve", "name": "crest", "radius_m": 1.0, "to_slope_deg": 70.0}


def drawn(*chutes, units="metric"):
    solutions = [chutecalc.solve(one) for one in chutes]
    figure = draw_run(solutions, units)
    return figure, {axes.get_label(): axes for axes in figure.axes}, solutions


def by_name(axes, gid):
    return [artist for artist in (*axes.lines, *axes.collections) if artist.get_gid() == gid]


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
    for column in PANELS:
        (line,) = by_name(axes[column], column)
        x, y = (COLUMNS[key].converted(stations[key][0], units) for key in ("s_m", column))
        assert np.array_equal(line.get_xdata(), x)
        assert np.array_equal(line.get_ydata(), y, equal_nan=True)
        unit = COLUMNS[column].unit_text(units)
        assert axes[column].get_ylabel() == f"{COLUMNS[column].heading} {COLUMNS[column].symbol}, {unit}"
    long = "ft" if units == "us" else "m"
    assert axes["pressure_kpa"].get_xlabel().endswith(f"s, {long}")
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


def test_a_flight_is_a_path_and_no_band():
    _, axes, (solution,) = drawn(load("coal_hood_spoon"))
    (flight,) = by_name(axes["side"], "flight")
    middle = solution.stations(points=STATIONS)
    falls = middle["kind"][0] == "fall"
    path = np.stack([middle["x_m"][0], middle["z_m"][0]], axis=1)[falls]
    assert np.allclose([segment[0] for segment in flight.get_segments()], path[:-1], rtol=0, atol=1e-12)
    assert len(by_name(axes["side"], "stream")) == 2
    legend = [text.get_text() for text in axes["side"].get_legend().get_texts()]
    assert "in flight (path only)" in legend


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
    at = (reached["x_m"][0][last[-1]], reached["z_m"][0][last[-1]]) if last.size else (0.0, 0.0)
    assert (end.get_xdata()[0], end.get_ydata()[0]) == at
    notes = axes["notes"].texts[0].get_text()
    assert notes.startswith(f"status {status}\n1  failure {status}")
    assert bool(by_name(axes["side"], "missed")) == (status == "missed")
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
    assert [text.get_text() for text in numbers] == ["1", "2"]
    for number, (mark, finding) in enumerate(zip(numbers, findings, strict=True), 1):
        assert f"{number}  {finding.severity} {finding.code}: {finding.segment}" in notes
        stations = solution.stations(points=STATIONS)
        nearest = np.nanargmin(np.abs(stations["s_m"][0] - finding.s_m[0]))
        assert mark.xy == (stations["x_m"][0][nearest], stations["z_m"][0][nearest])


def test_many_segments_are_told_once_and_not_named():
    slopes = np.linspace(75.0, 15.0, 61)
    straights = [
        {"kind": "straight", "slope_deg": float(a), "length_m": 0.1, "name": f"s{k}"} for k, a in enumerate(slopes)
    ]
    _, axes, _ = drawn(chute(inlet={"velocity_m_s": 5.0, "slope_deg": 76.0}, segments=straights))
    assert [text.get_text() for text in axes["side"].texts] == ["1, 2"]  # where both findings have their first place
    assert not axes["velocity_m_s"].texts
    assert re.search(r"and \d+ more", axes["notes"].texts[0].get_text())


def test_a_wide_chute_has_its_panels_below():
    figure, axes, _ = drawn(FAILING["choke"])
    figure.canvas.draw()
    side, velocity, depth = (axes[name].get_position() for name in ("side", "velocity_m_s", "depth_m"))
    assert side.y0 > velocity.y1
    assert velocity.x1 < depth.x0


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

    assert file() == file()
    assert not re.search(rb"20\d\d-\d\d-\d\d|CreationDate", file())


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
