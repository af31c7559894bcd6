"use strict";
(() => {
  // What is missing stands last, whichever way it is sorted.
  const compare = (a, b, down) => {
    const missing = (v) => v === null || v === "" || v === "\u2013";
    if (missing(a) || missing(b)) return missing(a) - missing(b);
    const order = typeof a === "number" && typeof b === "number"
      ? a - b : String(a).localeCompare(String(b), "en", { numeric: true });
    return down ? -order : order;
  };
  const mark = (th) => {
    const down = th.getAttribute("aria-sort") === "ascending";
    for (const each of th.parentNode.cells) each.setAttribute("aria-sort", "none");
    th.setAttribute("aria-sort", down ? "descending" : "ascending");
    return down;
  };
  const value = (row, column) => {
    const cell = row.cells[column], number = cell.dataset.value;
    return number === undefined ? cell.textContent : Number(number);
  };
  const sort = (table, th) => {
    const down = mark(th), column = th.cellIndex, body = table.tBodies[0];
    const rows = [...body.rows].map((row) => [value(row, column), row]);
    rows.sort((a, b) => compare(a[0], b[0], down));
    body.append(...rows.map((pair) => pair[1]));
  };
  const save = (link) => {
    const svg = link.closest("figure").querySelector("svg");
    const text = new XMLSerializer().serializeToString(svg);
    link.href = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };
  document.addEventListener("click", (event) => {
    const link = event.target.closest("a.save");
    if (link) save(link);
    const button = event.target.closest("th > button");
    const table = button && button.closest("table");
    if (table && table.id !== "cases-all") sort(table, button.parentNode);
  });

  const source = document.getElementById("cases-data");
  if (!source) return;
  const { columns, replay } = JSON.parse(source.textContent);
  const count = columns[0].values.length, perPage = 25;
  for (const column of columns)
    column.long = Boolean(column.texts) && column.texts.some((t) => t.length > 30);
  const text = (column, i) => {
    const v = column.values[i];
    if (v === null) return "\u2013";
    if (column.texts) return column.texts[v];
    return column.whole ? String(v) : String(Number((v / column.in_si).toPrecision(4)));
  };
  let order = Array.from({ length: count }, (_, i) => i), shown = order, page = 0;
  const $ = (id) => document.getElementById(id);
  const table = $("cases-all"), body = table.tBodies[0];
  const draw = () => {
    const pages = Math.max(1, Math.ceil(shown.length / perPage));
    page = Math.min(Math.max(page, 0), pages - 1);
    body.replaceChildren(...shown.slice(page * perPage, (page + 1) * perPage).map((i) => {
      const row = document.createElement("tr");
      columns.forEach((column, k) => {
        const cell = document.createElement(k ? "td" : "th");
        if (!k) cell.scope = "row";
        cell.className = column.texts ? (column.long ? "long" : "short") : "number";
        if (!column.texts && column.values[i] !== null) cell.dataset.value = column.values[i];
        if (k) cell.textContent = text(column, i);
        else {
          const button = document.createElement("button");
          button.type = "button";
          button.textContent = text(column, i);
          cell.append(button);
        }
        row.append(cell);
      });
      return row;
    }));
    $("cases-page").textContent = shown.length === 0 ? "no run" :
      `runs ${page * perPage + 1} to ${Math.min((page + 1) * perPage, shown.length)} of ${shown.length}`;
    $("cases-back").disabled = page === 0;
    $("cases-on").disabled = page === pages - 1;
  };
  const filter = () => {
    const words = $("cases-filter").value.toLowerCase().split(/\s+/).filter(Boolean);
    const named = columns.filter((column) => column.texts);
    const fits = named.map((column) => column.texts.map((each) => each.toLowerCase()));
    shown = words.length === 0 ? order : order.filter((i) => words.every((word) =>
      String(columns[0].values[i]) === word ||
      named.some((column, k) => column.values[i] !== null && fits[k][column.values[i]].includes(word))));
    page = 0;
    draw();
  };
  table.tHead.addEventListener("click", (event) => {
    const th = event.target.closest("th");
    if (!th) return;
    const down = mark(th), column = columns[th.cellIndex];
    const of = (i) => {
      const v = column.values[i];
      return v !== null && column.texts ? column.texts[v] : v;
    };
    if (column.texts) {  // few texts: their ranks once, not each pair of them
      const ranks = new Map([...column.texts].sort((a, b) => compare(a, b, false)).map((t, i) => [t, i]));
      const rank = (i) => (of(i) === null ? null : ranks.get(of(i)));
      order.sort((a, b) => compare(rank(a), rank(b), down));
    } else {
      order.sort((a, b) => compare(of(a), of(b), down));
    }
    filter();
  });
  body.addEventListener("click", (event) => {
    const row = event.target.closest("button") && event.target.closest("tr");
    if (row)
      $("cases-command").textContent = replay ? `${replay} ${row.cells[0].textContent}` : "can be repeated once the study is complete";
  });
  $("cases-back").addEventListener("click", () => { page -= 1; draw(); });
  $("cases-on").addEventListener("click", () => { page += 1; draw(); });
  $("cases-filter").addEventListener("input", filter);
  $("cases-table").hidden = false;
  draw();
})();
