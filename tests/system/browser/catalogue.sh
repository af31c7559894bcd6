#!/usr/bin/env bash
# The overview of the catalogue in a browser: it shows the numbers of losses.csv at the floor, place and velocity that
# are chosen, the chances of an item, an advice that is true of them, and the sum over a ward, each item where it
# stands.
# usage: catalogue.sh GURNEY SOURCE_FOLDER
set -uo pipefail
data=$2/docs/catalogue/data
. "$2/tests/system/cli/expect.sh"
. "$2/tests/system/browser/chromium.sh"
cp "$2/docs/catalogue/overview.html" overview.html

# ask SCRIPT EXPECTED: in a copy of the page
ask() {
  printf '%s\n' "$shared" "$1" > script.js
  with_script overview.html script.js copy.html
  dom copy.html | found > stdout
  quiet copy.html
  [ "$(cat stdout)" = "$2" ] || complain "expected $2 of: $1"
}

read -r -d '' shared << 'JS'
const row = (item) => document.querySelector(`[data-item="${item}"]`);
const choose = (id, value) => { element(id).value = value; element(id).dispatchEvent(new Event("input")); };
const count = (item, many) => {
  const it = row(item).querySelector("input");
  it.value = many;
  it.dispatchEvent(new Event("input"));
};
const put = (item, key, value) => {
  const it = row(item).querySelector(`[data-own="${key}"]`);
  it.value = value;
  it.dispatchEvent(new Event("input"));
};
const numbers = (id) => element(id).textContent.match(/[\d.]+/g).map(Number);
const days = (item) => [...row(item).querySelectorAll("title")].map((title) => title.textContent);
JS

# losses ITEM FLOOR PLACE PFV: the titles of the three settings
losses() {
  awk -F, -v item="$1" -v floor="$2" -v place="$3" -v pfv="$4" '
    function two(v) {v = sprintf("%.2g", v) + 0; return v < 10 ? sprintf("%.2f", v) : sprintf("%.0f", v)}
    NR == 1 {for (i = 1; i <= NF; i++) column[$i] = i}
    $1 == item && $2 == floor && $3 == place && $4 == pfv {
      split("off on locked", settings, " ")
      for (i = 1; i <= 3; i++) {
        name = "days_" settings[i]
        printf "%s\"%s: %s (%s to %s)\"", (i > 1 ? "," : "["), settings[i], two($column[name]), two($column[name "_low"]),
          two($column[name "_high"])
      }
      print "]"
    }' "$data/losses.csv"
}

# chance COLUMN: of the ventilator in the bay of the flexible building at 0.8 m/s [%]
chance() {
  awk -F, -v name="$1" '
    NR == 1 {for (i = 1; i <= NF; i++) column[$i] = i}
    $1 == "icu_ventilator" && $2 == "flexible building" && $3 == "bay" && $4 == "0.8" {
      printf "%.0f", 100 * $column[name]
    }' "$data/losses.csv"
}

ask 'return document.querySelectorAll("#items tr").length;' "$(($(wc -l < "$2/studies/catalogue/items.csv") - 1))"
ask 'return days("icu_ventilator");' "$(losses icu_ventilator 'flexible building' open 0.8)"
ask 'choose("floor", "ground"); choose("place", "bay"); choose("speed", "2"); return days("icu_bed");' \
  "$(losses icu_bed ground bay 0.4)"
# What is opened has the chances of both places; 1 m is passed no more often than 0.3 m.
ask 'row("infusion_pole").querySelector("button").click();
  const [open, bay] = document.querySelectorAll(".more table");
  const chances = [...open.rows].map((each) => parseFloat(each.cells[1].textContent.replace("<", "")));
  return [open.rows.length === bay.rows.length, open.rows[2].cells[0].textContent, chances[3] <= chances[2],
    row("infusion_pole").querySelector("button").getAttribute("aria-expanded")];' '[true,"moved 0.3 m",true,"true"]'
# The chances in the row of an item, in percent as they are shown there: with the likeliest setting, and the least.
ask 'choose("place", "bay"); const cells = row("icu_ventilator").cells;
  return [cells[1].querySelector(".chip").textContent, cells[1].querySelector("small").textContent,
    cells[3].innerText.replace(/\s+/g, " ").replace(/ hurts.*/, "")];' \
  "[\"off: fewest days; on: keeps it in service\",\"off $(chance share_off) %\",\"off $(chance lost_off) % least: on $(
    chance lost_on) %\"]"
# What life support takes is said in its row, and only there; who may be hurt is who stands beside what overturns.
ask 'choose("place", "bay"); row("icu_ventilator").querySelector("button").click();
  const bay = document.querySelectorAll(".more table")[1];
  const of = (words) => [...bay.rows].find((each) => each.cells[0].textContent === words);
  const cells = (words) => [...of(words).cells].slice(1).map((each) => each.textContent);
  const number = (text) => (text.startsWith("<") ? 0 : parseFloat(text));
  const worst = ["moved 1 m", "hit at 0.4 m/s", "hit at 0.8 m/s", "overturned"].map(cells);
  return [[...document.querySelectorAll(".advice strong")].filter((each) => each.textContent.startsWith("life"))
      .map((each) => each.closest("tr").dataset.item).join(),
    row("icu_ventilator").querySelector(".advice strong").textContent, String(cells("may hurt seriously")) === String(cells("overturned")),
    cells("may hurt somebody").every((each, i) => number(each) === Math.max(...worst.map((of) => number(of[i])))),
    row("icu_ventilator").cells[3].innerText.includes(`hurts: off ${cells("overturned")[0]}, on ${cells("overturned")[1]}`)];' \
  '["icu_ventilator,infusion_pole,neonatal_incubator,transport_incubator","life support: brakes on",true,true,true]'
# Carts whose drawers decide say so, and only they.
ask 'return [...document.querySelectorAll(".advice strong")].filter((each) => each.textContent.includes("drawers"))
    .map((each) => each.closest("tr").dataset.item);' '["crash_cart","medication_cart"]'
# Straps are those of tethers.csv.
strapped=$(awk -F, 'function two(v) {v = sprintf("%.2g", v) + 0; return v < 10 ? sprintf("%.2f", v) : sprintf("%.0f", v)}
  NR == 1 {for (i = 1; i <= NF; i++) column[$i] = i}
  /^icu_ventilator,.*strap/ {gsub(/"one strap, brakes"/, "both")
    printf "%s\"%s (%s to %s)\"", (n++ ? "," : "["), two($column["days"]), two($column["days_low"]), two($column["days_high"])}
  END {print "]"}' "$data/tethers.csv")
ask 'row("icu_ventilator").querySelector("button").click();
  return [...document.querySelectorAll(".more table")[2].tBodies[0].rows].map((each) => each.cells[1].textContent);' "$strapped"
# Of a ward of one kind the sum is that many times its loss.
ask 'count("icu_bed", 10);
  const shown = numbers("sums");
  const of = rowOf(data.items.find((each) => each.item === "icu_bed"), chosen()).days.map(([mean]) => mean);
  return shown.every((sum, i) => Math.abs(sum - 10 * (i < 3 ? of[i] : Math.min(...of))) <= 0.5) && shown.length;' '4'
# Ventilators near walls, poles in the open and beds on the ground: each adds what it loses there, days and service.
ask 'count("icu_ventilator", 12); count("infusion_pole", 24); count("icu_bed", 6);
  put("icu_ventilator", "place", "bay"); put("icu_bed", "floor", "ground");
  const at = [["icu_ventilator", 12, "flexible building", "bay"], ["infusion_pole", 24, "flexible building", "open"],
    ["icu_bed", 6, "ground", "open"]];
  const means = (name, floor, place, quantity) =>
    data.items.find((each) => each.item === name).rows[floor][place][5][quantity].map(([mean]) => mean);
  const sum = (quantity, of) => at.reduce((all, [name, many, floor, place]) =>
    all + many * of(means(name, floor, place, quantity)), 0);
  const wrong = [["days", "sums"], ["lost", "lost-sums"]].filter(([quantity, id]) => numbers(id).some((shown, i) =>
    Math.abs(shown - sum(quantity, (each) => (i < 3 ? each[i] : Math.min(...each)))) > 0.5));
  const before = element("sums").textContent;
  choose("place", "bay");
  const moved = element("sums").textContent !== before;
  put("icu_ventilator", "place", ""); put("icu_bed", "floor", ""); choose("place", "open");
  return [wrong, moved, element("sums").textContent !== before, row("icu_bed").querySelector("input").value];' \
  '[[],true,true,"6"]'
# What is next to look at, the rule and what is not in the model are beside the page, in the site and in the sources.
links='return [...document.querySelectorAll("a")].map((link) => link.getAttribute("href"));'
beside='"tethers.md","methods.md#what-to-do","methods.md#what-it-must-not-be-used-for","contents.md"'
ask "$links" "[${beside//.md/.html}]"
mkdir -p docs/catalogue
cp overview.html docs/catalogue
(cd docs/catalogue && ask "$links" "[$beside]" && exit "$failures") || failures=$((failures + 1))
for anchor in $(grep -o 'methods\.html#[a-z-]*' overview.html | sort -u); do
  sed -n 's/^#* *//p' "$2/docs/catalogue/methods.md" | tr 'A-Z ' 'a-z-' | grep -x "${anchor#*#}" > found ||
    complain "no $anchor"
done
# Every choice can be shown, and says that brakes do not keep an item in service, or do, where its chances say so.
ask 'for (const floor of element("floor").options) for (const place of element("place").options)
    for (let speed = 0; speed < data.speeds.length; ++speed)
      for (const quantity of element("quantity").options) {
        element("floor").value = floor.value; element("place").value = place.value; element("speed").value = speed;
        choose("quantity", quantity.value);
        if (/NaN|undefined|null/.test(document.body.innerText)) return [floor.value, place.value, speed, quantity.value];
        for (const item of data.items) {
          const chip = row(item.item).querySelector(".chip").textContent;
          const lost = item.rows[floor.value][place.value][speed].lost.map(([mean]) => mean);
          const kept = chip.match(/(\w+): keeps it in service/), advised = {"Set the brakes": "on",
            "Set the brakes, lock the swivels": "locked", "Leave the brakes off": "off"}[chip] ?? kept?.[1];
          if ((chip === "Brakes do not keep it in service") !== (Math.min(...lost) > 0.1) ||
              (advised && lost[data.settings.indexOf(advised)] > 0.1))
            return [item.item, floor.value, place.value, speed, chip, lost];
        }
      }
  return "all";' '"all"'
exit $((failures > 0))
