#!/usr/bin/env bash
# The overview of the catalogue in a browser: it shows the numbers of losses.csv at the floor, place and velocity that
# are chosen, the chances of an item, and the sum over a ward.
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
# Of a ward of one kind the sum is that many times its loss.
ask 'const count = row("icu_bed").querySelector("input"); count.value = 10; count.dispatchEvent(new Event("input"));
  const shown = element("sums").textContent.match(/[\d.]+/g).map(Number);
  const of = rowOf(data.items.find((each) => each.item === "icu_bed"), chosen()).days.map(([mean]) => mean);
  return shown.every((sum, i) => Math.abs(sum - 10 * (i < 3 ? of[i] : Math.min(...of))) <= 0.5) && shown.length;' '4'
# Every choice can be shown.
ask 'for (const floor of element("floor").options) for (const place of element("place").options)
    for (let speed = 0; speed < data.speeds.length; ++speed)
      for (const quantity of element("quantity").options) {
        element("floor").value = floor.value; element("place").value = place.value; element("speed").value = speed;
        choose("quantity", quantity.value);
        if (/NaN|undefined|null/.test(document.body.innerText)) return [floor.value, place.value, speed, quantity.value];
      }
  return "all";' '"all"'
exit $((failures > 0))
