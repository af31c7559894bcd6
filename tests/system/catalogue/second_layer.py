"""The layer above the curves: halves of the motions, variance components, other suites, losses, advice. Checks the
functions on made-up numbers, what the methods say of the losses, and that the advice is true of the shipped ones.

usage: second_layer.py SOURCE_DIR
"""

import csv
import importlib.util
import math
import os
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True
source = sys.argv[1]
sys.path.insert(0, os.path.join(source, "studies", "catalogue"))
import halves  # noqa: E402
import suites  # noqa: E402

data = os.path.join(source, "docs", "catalogue", "data")
with open(os.path.join(source, "docs", "catalogue", "methods.md")) as file:
    methods = " ".join(file.read().split())


def read(name):
    with open(os.path.join(data, name), newline="") as file:
        return list(csv.DictReader(file))


def states(words):
    assert words in methods, f"the methods do not state: {words}"


def curve(theta, low, high):
    return {"curve": {"theta": theta}, "theta_interval": [low, high]}


def check_halves():
    key = ("moved 1 m", "any")
    one, other = {key: curve(1, 0.5, 2)}, {key: curve(3, 0.9, None)}
    found = halves.count(one, other)["moved 1 m"]  # 1 is within (0.9, inf); 3 is not within (0.5, 2)
    assert found == {"medians": 2, "within": 1, "bounded": 1, "within_bounded": 0, "no_curve": 0}, found
    none = {key: {"curve": None}}
    assert halves.count(one, none)["moved 1 m"]["no_curve"] == 2
    for division in halves.divisions().values():
        first, second = map(set, division)
        assert len(first) == len(second) == len(halves.motion_rows()) // 2 and not first & second, division


def check_suites():
    base = dict.fromkeys(suites.KEY, "x") | {"theta": "1", "theta_low": "0.5", "theta_high": "inf"}
    [row] = suites.pairs({("x",) * 5: base}, {("x",) * 5: base | {"theta": "2"}})
    assert float(row["ratio"]) == 2 and row["within"] == "yes", row
    [row] = suites.summary([row, row | {"ratio": "0.5", "within": "no"}])
    assert (row["ratio"], row["lowest"], row["within"]) == ("1.00", "0.50", 1), row


def check_losses():
    import losses
    # The worst counts: 30 days in 10 %, 0.1 days in the 20 % that move 1 m without a fall.
    values = {"overturned": 30, "moved 1 m": 0.1, "moved 0.1 m": 0}
    chances = {"overturned": 0.1, "moved 1 m": 0.3, "moved 0.1 m": 0.9}
    assert math.isclose(losses.expected(values, chances), 30 * 0.1 + 0.1 * 0.2), losses.expected(values, chances)
    # A rarer milder state adds nothing.
    assert losses.expected(values, chances | {"moved 1 m": 0.05}) == 3
    one = {"exceed": "64", "theta": "0.8", "theta_low": "0.4", "theta_high": "1.6", "beta": "0.5", "beta_low": "", "beta_high": "inf"}
    assert losses.probability(one, 0.8, 0) == 0.5
    # At the score of its upper end the median is 0.4: ln 2 / 0.5 deviations below.
    upper = statistics.NormalDist().cdf(math.log(2) / 0.5)
    assert math.isclose(losses.probability(one, 0.8, losses.Z95), upper), losses.probability(one, 0.8, losses.Z95)
    assert math.isclose(losses.probability(one | {"theta_high": "inf"}, 0.8, -losses.Z95), 1 - upper)
    # A curve of few outcomes is bounded by the motions just above: none of 32, 16 of 32. The medians of Beta(1/2, 65/2)
    # (that of a chi-squared of one degree over 2 x 32, to 2 %) and Beta(33/2, 33/2); a median of 999 samples scatters by
    # 1 / (2 density sqrt(999)), and five times that is allowed.
    few = one | {"exceed": "2", "above": {0.8: "0/32"}}

    def scatter(a, b, at):
        density = math.gamma(a + b) / math.gamma(a) / math.gamma(b) * at ** (a - 1) * (1 - at) ** (b - 1)
        return 1 / (2 * density * math.sqrt(999))

    low = 0.45494 / 64
    assert abs(losses.probability(few, 0.8, 0) - low) < 5 * scatter(0.5, 32.5, low) + 0.02 * low
    half = losses.probability(few | {"theta": "0.1", "above": {0.8: "16/32"}}, 0.8, 0)
    assert abs(half - 0.5) < 5 * scatter(16.5, 16.5, 0.5), half
    assert losses.probability(few | {"exceed": "64"}, 0.8, 0) == 0.5
    assert losses.probability(few | {"theta": "80"}, 0.8, 0) < 1e-12  # the curve is below the bound
    # Median of Beta(1/2, n + 1/2) near 0: that of a chi-squared of one degree over 2 n.
    assert math.isclose(losses.probability({"theta": "", "runs": "128", "exceed": "0"}, 0.8, 0), 0.45494 / 256,
                        rel_tol=1e-4)
    # Outcomes that no curve fits are those of the runs just above: the median of Beta(3.5, 29.5) is 0.098.
    found = losses.probability({"theta": "", "runs": "128", "exceed": "3", "above": {0.8: "3/32"}}, 0.8, 0)
    assert abs(found - 0.098) < 0.004, found  # of 999 samples of a deviation of 0.053: 0.053 * 1.25 / sqrt(999), twice
    assert losses.within((0, 0.1, 1), 0.5) == 0.1 and losses.within((0, 0.1, 1), 1) == 1
    # Brakes off moves 1 m always, on falls in 1 %: 0.1 against 0.3 days, so off, until a metre costs the most it may.
    always, never = one | {"theta": "1e-9"}, one | {"theta": "1e9"}
    rarely = one | {"theta": str(0.8 * math.exp(0.5 * 2.3263479))}
    falls = {"moved 1 m": never, "overturned": rarely}
    curves = {"off": {"moved 1 m": always, "overturned": never}, "on": falls, "locked": falls}
    states_of = {"moved 1 m": (0.02, 0.1, 1), "overturned": (29, 30, 31)}
    assert list(losses.depends_on(curves, states_of, 0.8)) == ["moved 1 m"]

    shipped = {(row["item"], row["floor"], row["place"], row["pfv"]): row for row in read("losses.csv")}
    again = list(losses.rows(data, only=lambda item, floor, *_: (item, floor) == ("icu_bed", "flexible building")))
    assert len(again) == 2 * len(losses.SPEEDS)
    for row in again:
        old = shipped[row["item"], row["floor"], row["place"], str(row["pfv"])]
        assert old == {key: str(value) for key, value in row.items()}, (old, row)
    states(f"{losses.SAMPLES} samples")
    # A tie counts for each; the best by the stated values need not be the likeliest.
    samples = [({"off": 1, "on": 2}, {"off": 2, "on": 1}), ({"off": 1, "on": 1}, {"off": 1, "on": 1})]
    assert losses.best_of(samples) == "off"
    assert [losses.share_of(samples, s) for s in ("off", "on")] == ["0.50", "1.00"]
    for row in shipped.values():
        assert sum(float(row[f"share_{s}"]) for s in losses.SETTINGS) > 1 - 3 * 0.005, row  # each rounded; ties count twice
    states(f"less than {100 * losses.SETTLED:.0f} % of the samples")


def check_advice():
    import advice
    import losses
    from overview import untrue
    settings = losses.SETTINGS

    def row(lost, share, best="off", by_cost=None):
        """A row of losses.csv with what is lost, and the shares, in percent."""
        return ({f"lost_{s}": str(value / 100) for s, value in zip(settings, lost)} | {"best": best, "best_by_cost":
                by_cost or best} | {f"share_{s}": str(value / 100) for s, value in zip(settings, share)})

    says = lambda *of, **more: [do(row(*of, **more)) for do in (advice.action, advice.says, advice.shares, advice.mark)]
    hold, conflict = "Brakes do not keep it in service", "off: fewest days; on: keeps it in service"
    assert says((42, 4, 5), (97, 1, 2)) == ["conflict", conflict, "off 97 %", "off/on"]  # a ventilator in a bay
    assert says((90, 17, 7.5), (97, 1, 2))[1] == "off: fewest days; locked: keeps it in service"
    assert says((42, 11, 12), (97, 1, 2)) == ["hold", hold, "off 97 %", "off+"]
    assert says((42, 10.4, 12), (97, 1, 2))[0] == "conflict"  # shown as 10 %
    assert says((5, 11, 12), (97, 1, 2)) == ["off", "Leave the brakes off", "off 97 %", "off"]
    # Not settled: the likeliest first, whatever the means say; named alone in no column where it has less than half.
    assert says((5, 4, 5), (28, 45, 27), by_cost="on") == ["open", "Not settled", "on 45 %, off 28 %", "?"]
    assert says((5, 4, 5), (28, 60, 12))[2:] == ["on 60 %, off 28 %; least cost off", "on?"]
    assert says((5, 4, 5), (95, 3, 2), by_cost="on")[2:] == ["off 95 %; least cost on", "off?"]
    # A likely one that keeps it in service goes before the one that loses it least.
    kept = "Not settled; on: keeps it in service"
    assert says((20, 9, 1), (60, 30, 10))[1:] == [kept, "off 60 %, on 30 %", "off?/on"]
    assert says((20, 9, 1), (30, 60, 10))[1::2] == [kept, "on?"]
    assert says((20, 19, 1), (60, 30, 10))[3] == "off?/locked"
    assert says((20, 19, 18), (60, 30, 10))[:2] == ["hold", hold]
    # Where the likely ones all keep it and another does not, whoever keeps it is named.
    both = "Not settled; on or locked: keeps it in service"
    assert says((17, 1, 1), (1, 1, 98), best="locked", by_cost="on")[1] == both
    assert says((17, 1, 1), (2, 40, 58), best="locked")[1] == both

    for of in read("losses.csv"):
        lost = {s: round(100 * float(of[f"lost_{s}"])) for s in settings}
        limit, action = 100 * advice.MOST_LOST, advice.action(of)
        assert (action == "hold") == (min(lost.values()) > limit) == (advice.mark(of).endswith("+")), of
        if action == "conflict":
            assert lost[of["best"]] > limit >= lost[advice.keeper(of)], of
        if action in settings:
            assert lost[action] <= limit and float(of[f"share_{action}"]) >= losses.SETTLED, of

    # The page, and a page that says it again where a setting keeps the item in service.
    path = os.path.join(source, "docs", "catalogue", "overview.html")
    assert list(untrue(data, path)) == []
    with open(path, encoding="utf-8") as file:
        page = file.read()
    for old, new in ((conflict, hold), (hold, "Set the brakes"), ('"named":"off"', '"named":"on"'),
                     ('"kept":"on"', '"kept":"off"')):
        with tempfile.NamedTemporaryFile("w", suffix=".html", encoding="utf-8") as file:
            file.write(page.replace(old, new))
            file.flush()
            assert next(untrue(data, file.name), None), (old, new)
    states(f"with a chance of more than {100 * advice.MOST_LOST:.0f} %")
    states(advice.LIFE_SUPPORT)
    text = " ".join(page.split())
    for words in (advice.LIFE_SUPPORT, f"with a chance of at most {100 * advice.MOST_LOST:.0f} %",
                  f"the share is below {100 * losses.SETTLED:.0f} %", "beds in a row hit each other"):
        assert words in text, words


def check_dispersion():
    import dispersion
    row = {"theta": "0.8", "beta": "0.3", "beta_low": "", "beta_high": "inf", "runs": "128"}
    assert dispersion.widened(row, 0.4) == row | {"beta": "0.5"}, dispersion.widened(row, 0.4)
    assert dispersion.widened(row, 0) == row


def check_judgements():
    import judgements
    published, in_part, judged = {"value": 1, "source": "a"}, {"value": 1, "source": "a", "assumption": "b"}, {
        "value": 1, "assumption": "b", "distribution": {"value": 2, "assumption": "of the distribution"}}
    file = {"mass": published, "shape": [{"size": in_part, "kind": "box"}], "variant": {"arm": {"mass": judged}},
            "deep": {"deeper": judged}, "name": "x"}
    assert [judgements.kind(each) for each in judgements.quantities(file)] == list(judgements.KINDS)
    # A caster's file counts once, however many casters there are.
    assert judgements.caster_types({"caster": [{"type": "b"}, {"type": {"value": "a"}}, {"type": "b"}]}) == ["a", "b"]


    # A judged value whose distribution is published, as the slope of a floor.
    assert judgements.kind(judged | {"distribution": {"sd": 1, "source": "a"}}) == judgements.KINDS[1]


def check_published():
    """What is published of the constants: the steps that values rest on, and where the files are."""
    import published
    # A tread sinks by d where (4/3) sqrt(2 R) d^1.5 w E' / t carries the load: E = 9.35 MPa of 80 Shore A by Gent, by hand
    # 0.0981 * 665.8688 / (0.137505 * 50.8) = 9.3513; E' = E / 0.75.
    sinks = published.LOAD / published.tread_stiffness(80)
    carries = 4 / 3 * math.sqrt(2 * published.RADIUS) * sinks ** 1.5 * published.WIDTH * 9.3513e6 / 0.75 / published.THICKNESS
    assert math.isclose(carries, published.LOAD, rel_tol=1e-4), carries
    # Slopes of 1 % and -1 % over one interval, none over two but for 0.5 mm in 200.
    survey = {"spacing_mm": 100, "heights_mm": [[0, 1, 0, 1.5]]}
    assert math.isclose(published.slope_deviation(survey, 1), statistics.stdev([1, -1, 1.5]))
    assert math.isclose(published.slope_deviation(survey, 2), statistics.stdev([0, 0.25]))
    # In, below and above the ranges of files; a caster that is not named is not compared.
    of = {"a": (1, 2, 3), "b": (4, 5, 6), "c": (0.1, 0.1, 0.2)}
    assert published.place({"value": 3}, of) == "in 1 of 3; below it: c; above it: b"
    assert published.place({"low": 3, "high": 4, "at": ["a", "b", "d"]}, of) == "in 2 of 2"
    assert published.place({"value": 9}, of) == "all below it" and published.place({"value": 0.01}, of) == "all above it"
    assert published.place({"value": 9, "at": []}, of) == ""
    # Two values of a kind make a distribution; bounds, starts and other kinds do not.
    value = lambda middle, kind="measured", **more: {"value": middle, "kind": kind} | more
    constant = {"quantity": "x", "values": [value(1), value(math.exp(2), "derived"), value(50, "required"),
                                            value(9, start=True), value(7, group="other")]}
    median, beta = published.distributions(constant)[""]
    assert math.isclose(median, math.e) and math.isclose(beta, math.sqrt(2)) and len(published.distributions(constant)) == 1

    constants = published.constants()
    shown, _ = published.analyses(data)
    ranked = [name for constant in constants for name in constant["ranked"]]
    assert set(shown) <= set(ranked) and len(ranked) == len(set(ranked)), set(shown) - set(ranked)
    for constant in constants:
        for each in constant["values"]:
            assert each["kind"] in published.KINDS and each["by"] and each["of"], each
            assert set(each.get("at", [])) <= {name.removesuffix(".toml") for name in os.listdir(
                os.path.join(source, "equipment", "casters"))}, each
    # What the words of a derived value say gives it: 2.2 and 2.4 mm over 63 / 39; forces of beds over their weight, times R.
    rolling = {constant["name"]: constant["values"] for constant in constants}["rolling resistance Cr"]
    for start, steady in zip(rolling[:2], rolling[2:4]):
        assert abs(start["value"] * 39 / 63 - steady["value"]) <= 0.005, steady
    low, high = published.ends(rolling[4])
    assert abs(49.6 / 350 / 9.81 * 75 - low) <= 0.005 and abs(92.4 / 200 / 9.81 * 75 - high) <= 0.05


def check_contents():
    """Items with parts: what is lost contains the falls, and the rigid item beside them is that of the catalogue."""
    import contents
    from pages import parts_line
    text = contents.states_file("neonatal_incubator")
    assert text.count("any_of = [") == 5 and 'any_of = ["something fell", "overturned"]' in text, text
    assert 'item = "neonatal_incubator/mattress tray"\npoint = "infant"\n' in text, text
    rows = read("contents.csv")
    of = {(row["item"], row["brakes"], row["limit_state"]): row for row in rows}
    rigid = {(row["item"], row["brakes"], row["limit_state"]): row
             for row in read("fragility.csv") + read("more_states.csv")
             if (row["measure"], row["floor"], row["place"]) == ("pfv", *contents.WHERE.split(","))}
    for (item, brakes, state), row in of.items():
        assert row["runs"] == "128" and row["failed"] == "0" and row["variant"] == contents.VARIANTS[item][0], row
        if state in contents.SHARED:
            falls = int(of[item, brakes, "overturned"]["exceed"])
            assert state != contents.SHAKEN or int(row["exceed"]) >= falls, row
            assert (row["rigid_exceed"], row["rigid_theta"]) == (rigid[item, brakes, state]["exceed"],
                                                                 rigid[item, brakes, state]["theta"]), row
        else:
            assert int(row["exceed"]) >= int(of[item, brakes, "overturned"]["exceed"]) and not row["rigid_exceed"], row
    assert {brakes for _, brakes, _ in of} == set(contents.SETTINGS)
    assert parts_line(rows, "linen_cart") == [] and "crash_cart" in {row["item"] for row in rows}


def check_changes():
    """Equipment with a constant changed: that number and no other, and the shipped medians beside the new ones."""
    import changes
    text = 'name = "a"\n\n[brake_torque_n_m]\nvalue = 5\n[brake_torque_n_m.distribution]\nmedian = 10\nlow = 2.5\n\n[tread]\nlow = 1\n'
    assert changes.numbers(text, "brake_torque_n_m.distribution") == {"median": 10, "low": 2.5}
    assert changes.holding(text) == text.replace("low = 2.5", "low = 10")
    try:
        changes.changed(text, "brake_torque_n_m", {"high": 1})
        raise AssertionError("a number that is not there was changed")
    except ValueError:
        pass
    for _, change, _ in changes.CHANGES.values():
        for path in ("casters/R100.toml", "casters/drive_250.toml", "levelness.toml"):
            if (path == "levelness.toml") == (change is changes.sloping):
                with open(os.path.join(source, "equipment", path)) as file:
                    old = file.read()
                new = change(old)
                assert len(old.splitlines()) == len(new.splitlines())
                assert (new == old) == (change is changes.rolling and "drive" in path), (path, change)
    of = {tuple(row[k] for k in suites.KEY): row for row in read("fragility.csv") if row["measure"] == "pfv"}
    rows = read("changes.csv")
    assert {row["change"] for row in rows} == set(changes.CHANGES)
    assert all(row["theta"] == of[tuple(row[k] for k in suites.KEY)]["theta"] for row in rows)


def check_injuries():
    import losses
    of = losses.consequences()
    hurts = lambda injury: losses.injuring(lambda quantity: of("icu_ventilator", quantity), injury)
    assert hurts("serious") == {"overturned", "fell"} and hurts("minor") > hurts("serious") and hurts("none") > hurts("minor")
    sure = {"exceed": "64", "theta": "0.8", "theta_low": "0.8", "theta_high": "0.8", "beta": "0.5", "beta_low": "0.5",
            "beta_high": "0.5"}
    curves = {"off": {"overturned": sure, "moved 1 m": sure | {"theta": "0.4", "theta_low": "0.4", "theta_high": "0.4"}}}
    assert losses.reached(curves, {"overturned", "fell"}, 0.8, "x") == {"off": (0.5, 0.5, 0.5)}
    chance = statistics.NormalDist().cdf(math.log(2) / 0.5)  # of the likelier of the two
    assert all(math.isclose(each, chance) for each in losses.reached(curves, {"overturned", "moved 1 m"}, 0.8, "x")["off"])


def check_reasons():
    """Why a curve is missing says what the runs have: at a level of 32 motions the median is below it, or above, where
    half of them is outside of the interval (Clopper & Pearson) of the share that exceeds."""
    from catalogue import LEVELS_OF_CURVES as levels
    motions = 32
    at_most = lambda k: sum(math.comb(motions, i) for i in range(k + 1)) / 2 ** motions
    checked = 0
    for row in read("fragility.csv"):
        reason, exceed = row["reason"], int(row["exceed"])
        assert bool(reason) != bool(row["theta"]) and "about" not in reason, row
        if exceed == 0:
            assert reason.startswith("no run exceeds up to "), row
        if row["measure"] == "pfv" or not reason or exceed == 0:
            continue
        # One level has both outcomes: none exceeds below, all above.
        above, mixed = divmod(exceed, motions)
        at = len(levels) - 1 - above
        low = levels[at] if at_most(mixed) < 0.025 else levels[at - 1] if at else 0
        high = levels[at] if 1 - at_most(mixed - 1) < 0.025 else levels[at + 1] if above else math.inf
        words = (f"median below {high:g} m/s" if not low else f"median above {low:g} m/s" if math.isinf(high)
                 else f"median between {low:g} and {high:g} m/s")
        if "quasi-complete" in reason:
            assert reason.endswith(f": outcomes change at {levels[at]:g} m/s: {words}"), (row, words)
            checked += 1
    assert checked > 600, checked


def check_tethers():
    import tethers
    # A strap is slack by 50 mm at the start: 0.1 m behind the back of an item of 0.6 m.
    text = tethers.held((0.6, 0.5, 1.0))["one strap"]
    assert "point_m = [-0.300, 0.000, 0.700], anchor_m = [-0.400, 0.000, 0.700], slack_length_m = 0.150" in text, text
    text = tethers.held((0.6, 0.5, 1.0))["two straps"]
    assert f"[-0.400, -0.450, 0.700], slack_length_m = {math.hypot(0.1, 0.2) + 0.05:.3f}" in text, text
    items = {row["item"] for row in read("tethers.csv")}
    for row in read("tethers.csv"):
        assert row["failed"] == "0" and row["runs"] == "128", row
        assert ("strap" in row["held"]) == bool(row["tension_n_p95"]), row
    assert all(sum(row["item"] == item for row in read("tethers.csv")) == 5 for item in items)


def check_widths():
    import widths
    assert [(size, sets) for size, sets in widths.parts(list("abcdefgh"))] == [
        (2, [["a", "e"], ["b", "f"], ["c", "g"], ["d", "h"]]), (4, [list("aceg"), list("bdfh")]), (8, [list("abcdefgh")])]
    assert widths.width([1, 4]) == 4 and math.isinf(widths.width([None, 4])) and math.isinf(widths.width([1, None]))


def check_variance():
    import numpy
    import variance
    random = numpy.random.default_rng(1)
    records, draws, replicas = 400, 4, 2
    deviations = numpy.array([2.0, 1.0, 0.5])
    values = (deviations[0] * random.standard_normal((records, 1, 1)) +
              deviations[1] * random.standard_normal((records, draws, 1)) +
              deviations[2] * random.standard_normal((records, draws, replicas)))
    # The scatter of a mean square of n degrees of freedom is sqrt(2 / n) of it; five times that of the three
    # mean squares (n = 399, 1200, 1600), divided as the components are.
    squares = numpy.array([0.25 + 2 * 1 + 8 * 4, 0.25 + 2 * 1, 0.25])
    scatter = 5 * squares * numpy.sqrt(2 / numpy.array([399, 1200, 1600]))
    most = [(scatter[0] + scatter[1]) / 8, (scatter[1] + scatter[2]) / 2, scatter[2]]
    found = variance.components(values)
    assert (abs(numpy.array(found) - deviations ** 2) <= most).all(), (found, most)
    only_records = numpy.broadcast_to(random.standard_normal((5, 1, 1)), (5, 3, 2))
    assert numpy.allclose(variance.shares(only_records), [1, 0, 0])

    # A constant that alone decides has rank correlation 1, whatever the records add to the response.
    constant = random.standard_normal((16, 4))
    assert variance.rank_correlation(constant, constant) > 1 - 1e-12
    assert variance.p_value(constant, constant) == 1 / (variance.PERMUTATIONS + 1)
    assert variance.holm([0.01, 0.04, 0.03]).tolist() == [0.03, 0.06, 0.06]

    for row in read("variance.csv"):
        total = sum(float(row[part]) for part in ("record", "parameters", "chaos"))
        assert abs(total - 1) < 0.016, row  # three roundings to 0.01


def check_above():
    import above
    import numpy
    # Two motions at two levels each, and one that is nowhere above.
    motion, speeds = numpy.array([0, 1, 0, 1, 2]), numpy.array([0.5, 2.0, 1.5, 0.7, 0.1])
    assert above.nearest_above(motion, speeds, 0.6).tolist() == [2, 3]
    assert above.nearest_above(motion, speeds, 1).tolist() == [2, 1]
    assert above.nearest_above(motion, speeds, 1.8).tolist() == [1]
    # What is counted above the lowest velocity is no more than what the curve's table counts of all runs.
    key = ("item", "floor", "place", "brakes", "limit_state", "measure")
    curves = {tuple(row[k] for k in key): row for row in read("fragility.csv")}
    for row in read("above.csv"):
        of = curves[tuple(row[k] for k in key)]
        shares = [tuple(map(int, row[str(speed)].split("/"))) for speed in above.SPEEDS]
        assert all(k <= min(n, int(of["exceed"])) and n <= 32 for k, n in shares), row


def check_sufficiency():
    import numpy
    import sufficiency
    random = numpy.random.default_rng(1)
    motions, floors, levels = 32, 5, 4
    shape = (motions, floors, levels)
    motion, floor, _ = (index.ravel() for index in numpy.indices(shape))

    def outcomes(shifts):
        """Runs whose capacity is lognormal about 1 m/s, with a part that a motion has in common and one by floor."""
        measure = 0.8 * random.standard_normal(shape)
        common = 0.3 * random.standard_normal((motions, 1, 1))
        capacity = common + 0.4 * random.standard_normal(shape) + numpy.array(shifts)[:, None]
        return (measure > capacity).ravel().astype(float), measure.reshape(-1, 1)

    # Floors alike: p is below 0.05 in one of 20; of 200 at most 22 in all but one of 10,000 (binomial).
    alike = [sufficiency.sufficiency(*outcomes([0.5] * floors), floor, motion)[0] for _ in range(200)]
    assert sum(p < 0.05 for p in alike) <= 22, sum(p < 0.05 for p in alike)
    # One floor's median is 1.5 times that of the others; a median of 128 runs scatters by 0.06.
    found = [sufficiency.sufficiency(*outcomes([0, 0, 0, 0, math.log(1.5)]), floor, motion) for _ in range(40)]
    assert sum(p < 0.05 for p, _ in found) >= 36, found
    assert 1.4 < statistics.median(ratio for _, ratio in found) < 1.75, found  # of five, the smallest is below 1
    # A curve that is right on each floor is off by sampling alone, 0.5 / sqrt(128); one for two unlike floors by half
    # of what they differ.
    exceeds, measures = numpy.tile([1.0, 0, 0, 0], 10), numpy.zeros((40, 0))
    _, off = sufficiency.pooled(exceeds, measures, numpy.repeat([0, 1], 20), numpy.arange(40) % 10)
    assert abs(off) < 1e-9, off
    exceeds = numpy.concatenate([numpy.tile([1.0, 0, 0, 0], 5), numpy.tile([1.0, 1, 1, 0], 5)])
    coefficients, off = sufficiency.pooled(exceeds, measures, numpy.repeat([0, 1], 20), numpy.arange(40) % 10)
    assert abs(off - 0.25) < 1e-9 and abs(coefficients[0]) < 1e-9, (off, coefficients)


check_halves()
check_suites()
check_losses()
check_advice()
check_dispersion()
check_judgements()
check_published()
check_contents()
check_changes()
check_injuries()
check_reasons()
check_tethers()
check_widths()
if importlib.util.find_spec("h5py") and importlib.util.find_spec("numpy"):
    check_variance()
if importlib.util.find_spec("statsmodels"):
    check_above()
    check_sufficiency()
