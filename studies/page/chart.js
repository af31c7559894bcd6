// Values of a figure where one points, its parts enlarged, and the command of the run behind a mark.
(() => {
  const numbers = (text) => text.split(" ").map(Number);
  const tip = document.createElement("div"), ring = document.createElement("div");
  tip.id = "value";
  tip.setAttribute("role", "status");
  ring.id = "ring";
  tip.hidden = ring.hidden = true;
  document.body.append(tip, ring);

  const axesOf = (svg) => svg.axes ??= [...svg.querySelectorAll("g.axes")].map((group) => {
    const of = group.dataset, [left, top, width, height] = numbers(of.frame);
    const range = (text) => { const [low, high] = numbers(text); return { low, high }; };
    const names = [of.xName, of.yName], logs = numbers(of.log);
    const axes = { group, left, top, width, height, home: { x: range(of.x), y: range(of.y) },
      names, logs, fixed: of.fixed === "1" };
    axes.now = axes.home;
    return axes;
  });
  const middle = (mark) => {
    const box = mark.getBBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  };
  const seriesOf = (axes) => axes.series ??= [
    ...[...axes.group.querySelectorAll("g.marks")].map((group) => {
      const runs = group.dataset.runs ? numbers(group.dataset.runs) : [];
      const points = [...group.children].map((mark, i) => ({ at: middle(mark), run: runs[i], mark }));
      return { name: group.dataset.name, marks: true, points };
    }),
    ...[...axes.group.querySelectorAll("g.view polyline")].map((line) => ({
      name: line.parentNode.dataset.name ?? "", marks: false,
      points: line.getAttribute("points").trim().split(" ").map((pair) => ({ at: pair.split(",").map(Number) }))
    }))].filter((series) => series.points.length > 0);

  // Places [px of the picture] as they were drawn, and where they are now.
  const shift = (axes) => {
    const { home, now } = axes, a = (home.x.high - home.x.low) / (now.x.high - now.x.low);
    const b = (home.y.high - home.y.low) / (now.y.high - now.y.low);
    return [a, b, axes.left - axes.left * a - (now.x.low - home.x.low) / (now.x.high - now.x.low) * axes.width,
      axes.top - axes.top * b + (now.y.high - home.y.high) / (now.y.high - now.y.low) * axes.height];
  };
  const moved = (axes, [x, y]) => {
    const [a, b, c, d] = shift(axes);
    return [a * x + c, b * y + d];
  };
  const inside = (axes, [x, y], air = 0) => x >= axes.left - air && x <= axes.left + axes.width + air &&
    y >= axes.top - air && y <= axes.top + axes.height + air;
  const valueAt = (axes, [x, y]) => {
    const { x: along, y: up } = axes.home;
    const at = [along.low + (x - axes.left) / axes.width * (along.high - along.low),
      up.high - (y - axes.top) / axes.height * (up.high - up.low)];
    const spans = [along.high - along.low, up.high - up.low];  // pictures are drawn to a part of them
    return at.map((value, i) => Number((axes.logs[i] ? 10 ** value : Math.abs(value) < 1e-4 * spans[i] ? 0 : value).toPrecision(4)));
  };

  const ticks = (low, high, wanted) => {
    const rough = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 2.5, 5, 10].map((nice) => nice * power).find((each) => each >= rough * 0.999);
    const all = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) all.push(i * step);
    return all;
  };
  const make = (parent, tag, attributes, text = "") => {
    const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const name in attributes) node.setAttribute(name, attributes[name]);
    node.textContent = text;
    parent.append(node);
  };
  const drawTicks = (axes, k) => {
    const group = axes.group.querySelector(k ? "g.ticks-y" : "g.ticks-x"), range = k ? axes.now.y : axes.now.x;
    axes.drawn ??= {};
    axes.drawn[k] ??= [...group.childNodes];
    group.replaceChildren();
    if (range === (k ? axes.home.y : axes.home.x)) {
      group.append(...axes.drawn[k]);
      return;
    }
    const named = axes.drawn[k].some((node) => node.nodeName === "text"), log = axes.logs[k];
    const values = log ? ticks(10 ** range.low, 10 ** range.high, 5) : ticks(range.low, range.high, k ? axes.height / 45 : axes.width / 70);
    for (const value of values) {
      const part = ((log ? Math.log10(value) : value) - range.low) / (range.high - range.low);
      if (!(part >= 0 && part <= 1)) continue;
      const x = k ? axes.left : axes.left + part * axes.width;
      const y = k ? axes.top + (1 - part) * axes.height : axes.top + axes.height;
      make(group, "line", k ? { x1: x, y1: y, x2: x + axes.width, y2: y, stroke: "#e6e6e6", "stroke-width": 0.7 }
        : { x1: x, y1: axes.top, x2: x, y2: y, stroke: "#e6e6e6", "stroke-width": 0.7 });
      if (named)
        make(group, "text", { x: k ? x - 7 : x, y: k ? y + 3.5 : y + 15, "font-size": 10, "text-anchor": k ? "end" : "middle",
          fill: "#222222" }, String(Number(value.toPrecision(4))).replace("-", "\u2212"));
    }
  };
  const view = (axes, x, y) => {
    axes.now = { x, y };
    const away = x !== axes.home.x || y !== axes.home.y, [a, b, c, d] = shift(axes);
    axes.group.classList.toggle("zoomed", away);
    axes.group.querySelector("g.view").setAttribute("transform", away ? `matrix(${a} 0 0 ${b} ${c} ${d})` : "");
    for (const series of seriesOf(axes).filter((each) => each.marks))
      for (const point of series.points) {
        const to = moved(axes, point.at);
        point.mark.setAttribute("transform", away ? `translate(${to[0] - point.at[0]} ${to[1] - point.at[1]})` : "");
        point.mark.setAttribute("visibility", inside(axes, to, 1) ? "visible" : "hidden");
      }
    drawTicks(axes, 0);
    drawTicks(axes, 1);
  };
  // All axes of a figure that began with the same x keep the same.
  const zoom = (svg, axes, x, y) => {
    if (axes.fixed) return;
    for (const each of axesOf(svg)) {
      if (each === axes) view(each, x, y);
      else if (!each.fixed && each.group.dataset.x === axes.group.dataset.x)
        view(each, x === axes.home.x ? each.home.x : x, each.now.y);
    }
    hide();
    const button = svg.closest("figure").querySelector("button.whole");
    button.hidden = !axesOf(svg).some((each) => each.group.classList.contains("zoomed"));
  };
  const whole = (svg) => { for (const each of axesOf(svg)) zoom(svg, each, each.home.x, each.home.y); };
  const part = (range, from, to) => ({ low: range.low + from * (range.high - range.low), high: range.low + to * (range.high - range.low) });

  const picturePlace = (svg, event) => {
    const box = svg.getBoundingClientRect(), scale = svg.viewBox.baseVal.width / box.width;
    return [(event.clientX - box.left) * scale, (event.clientY - box.top) * scale];
  };
  const onSegment = ([x, y], [ax, ay], [bx, by]) => {
    const dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
    const t = length > 0 ? Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / length)) : 0;
    return [ax + t * dx, ay + t * dy];
  };
  const nearest = (svg, place) => {
    const axes = axesOf(svg).find((each) => inside(each, place, 4));
    if (!axes) return null;
    let best = null;
    const [a, b, c, d] = shift(axes), back = ([x, y]) => [(x - c) / a, (y - d) / b];
    const take = (series, point, at, reach) => {
      const to = moved(axes, at), far = Math.hypot(to[0] - place[0], to[1] - place[1]);
      if (far <= reach && inside(axes, to, 1) && (!best || far < best.far)) best = { axes, series, point, at, far };
    };
    for (const series of seriesOf(axes)) if (series.marks) for (const point of series.points) take(series, point, point.at, 10);
    if (best) return best;
    for (const series of seriesOf(axes)) if (!series.marks)
      series.points.forEach((point, i) => take(series, point, i ? onSegment(back(place), series.points[i - 1].at, point.at) : point.at, 40));
    return best;
  };

  const replay = () => {
    const source = document.getElementById("cases-data");
    return source ? JSON.parse(source.textContent).replay : "";
  };
  const hide = () => { tip.hidden = ring.hidden = true; tip.pinned = false; };
  const copy = async (text, button) => {
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      getSelection().selectAllChildren(tip.querySelector("code"));
      document.execCommand("copy");
    }
    button.textContent = "Copied";
  };
  const show = (svg, found, pinned) => {
    const { axes, series, point, at } = found, [x, y] = valueAt(axes, at), to = moved(axes, at);
    const line = (text) => { const each = document.createElement("div"); each.textContent = text; return each; };
    // Of axes below each other the last has the name of their x.
    const along = axes.names[0] || axesOf(svg).findLast((each) => each.names[0] && each.group.dataset.x === axes.group.dataset.x)?.names[0];
    const of = (name, value, other) => `${name || other}: ${value}`;
    tip.replaceChildren(...[series.name, of(along, x, "x"), of(axes.names[1], y, "value")].filter(Boolean).map(line));
    tip.pinned = pinned;
    if (point.run !== undefined) {
      const command = replay(), text = command ? `${command} ${point.run}` : "can be repeated once the study is complete";
      if (!pinned) tip.append(line(`run ${point.run}: click or Enter gives its command`));
      else {
        const code = document.createElement("code"), button = document.createElement("button");
        code.textContent = text;
        button.type = "button";
        button.textContent = "Copy";
        button.addEventListener("click", () => copy(text, button));
        tip.append(line(`run ${point.run}`), code, " ", ...(command ? [button] : []));
      }
    }
    const box = svg.getBoundingClientRect(), scale = box.width / svg.viewBox.baseVal.width;
    const left = box.left + scrollX + to[0] * scale, top = box.top + scrollY + to[1] * scale;
    tip.hidden = ring.hidden = false;
    ring.style.left = `${left}px`;
    ring.style.top = `${top}px`;
    const wide = document.documentElement.clientWidth;
    tip.style.left = `${Math.max(4, Math.min(left + 12, wide - tip.offsetWidth - 4))}px`;
    tip.style.top = `${top - scrollY + 14 + tip.offsetHeight > innerHeight ? top - tip.offsetHeight - 12 : top + 14}px`;
  };

  const prepare = (svg) => {
    const paper = svg.closest(".paper"), button = document.createElement("button"), drawn = document.createElement("div");
    let from = null, chosen = [0, 0, -1];
    button.className = "whole";
    button.type = "button";
    button.textContent = "Whole figure";
    button.hidden = true;
    button.addEventListener("click", () => whole(svg));
    paper.parentNode.querySelector("figcaption").append(" ", button);
    drawn.className = "drawn";
    drawn.hidden = true;
    document.body.append(drawn);
    paper.tabIndex = 0;
    paper.setAttribute("role", "group");
    paper.setAttribute("aria-label", "Figure: arrow keys read its values, + and - zoom, 0 shows all of it");
    svg.addEventListener("pointermove", (event) => {
      const place = picturePlace(svg, event);
      if (from && from.axes && Math.hypot(event.clientX - from.x, event.clientY - from.y) > 5) {
        hide();
        drawn.hidden = false;
        drawn.style.left = `${scrollX + Math.min(from.x, event.clientX)}px`;
        drawn.style.top = `${scrollY + Math.min(from.y, event.clientY)}px`;
        drawn.style.width = `${Math.abs(event.clientX - from.x)}px`;
        drawn.style.height = `${Math.abs(event.clientY - from.y)}px`;
      } else if (!tip.pinned) {
        const found = nearest(svg, place);
        if (found) show(svg, found, false);
        else hide();
      }
    });
    svg.addEventListener("pointerleave", () => { if (!tip.pinned) hide(); });
    svg.addEventListener("pointerdown", (event) => {
      const place = picturePlace(svg, event), axes = axesOf(svg).find((each) => !each.fixed && inside(each, place));
      if (event.button !== 0) return;
      from = { x: event.clientX, y: event.clientY, place, axes: event.pointerType === "touch" ? null : axes };
      if (from.axes) event.preventDefault();
      if (from.axes && event.isTrusted) svg.setPointerCapture(event.pointerId);
    });
    svg.addEventListener("pointerup", (event) => {
      if (!from) return;
      const to = picturePlace(svg, event), { axes, place } = from;
      const wide = Math.abs(to[0] - place[0]), high = Math.abs(to[1] - place[1]);
      from = null;
      drawn.hidden = true;
      if (!axes || Math.hypot(wide, high) < 8) {
        const found = nearest(svg, to);
        if (found) show(svg, found, true);
        else hide();
        return;
      }
      const share = (value, low, size) => Math.min(1, Math.max(0, (value - low) / size));
      const x = [place[0], to[0]].sort((p, q) => p - q).map((value) => share(value, axes.left, axes.width));
      const y = [place[1], to[1]].sort((p, q) => q - p).map((value) => 1 - share(value, axes.top, axes.height));
      const { now } = axes;  // a narrow stripe is of one axis
      zoom(svg, axes, wide < 8 ? now.x : part(now.x, ...x), high < 8 ? now.y : part(now.y, ...y));
    });
    svg.addEventListener("pointercancel", () => { from = null; drawn.hidden = true; });
    svg.addEventListener("dblclick", () => whole(svg));
    paper.addEventListener("keydown", (event) => {
      const all = axesOf(svg).flatMap((axes) => seriesOf(axes).map((series) => ({ axes, series })));
      const turn = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [1, 0], ArrowUp: [-1, 0] }[event.key];
      const zooms = { "+": 0.5, "=": 0.5, "-": 2 }[event.key];
      if (event.target !== paper || event.ctrlKey || event.metaKey || event.altKey || all.length === 0) return;
      chosen[1] = (chosen[1] + (turn ? turn[0] : 0) + all.length) % all.length;
      const { axes, series } = all[chosen[1]];
      series.sorted ??= [...series.points].sort((p, q) => p.at[0] - q.at[0]);
      const count = series.sorted.length;
      chosen[2] = Math.min(count - 1, Math.max(0, chosen[2] + (turn ? turn[1] : 0)));
      const point = series.sorted[chosen[2]], found = { axes, series, point, at: point.at };
      if (turn) show(svg, found, false);
      else if (event.key === "Enter") {
        show(svg, found, true);
        tip.querySelector("button")?.focus();
        tip.back = paper;
      } else if (zooms && !axes.fixed) {
        const around = (home, now, value) => {
          const half = zooms * (now.high - now.low) / 2, low = Math.max(home.low, value - half);
          const high = Math.min(home.high, value + half);
          return low === home.low && high === home.high ? home : { low, high };
        };
        const at = [axes.home.x.low + (point.at[0] - axes.left) / axes.width * (axes.home.x.high - axes.home.x.low),
          axes.home.y.high - (point.at[1] - axes.top) / axes.height * (axes.home.y.high - axes.home.y.low)];
        zoom(svg, axes, around(axes.home.x, axes.now.x, at[0]), around(axes.home.y, axes.now.y, at[1]));
        show(svg, found, false);
      } else if (event.key === "0") whole(svg);
      else if (event.key === "Escape") hide();
      else return;
      event.preventDefault();
    });
    paper.addEventListener("blur", () => { if (!tip.pinned) hide(); });
  };
  tip.addEventListener("keydown", (event) => {
    if (event.key !== "Escape") return;
    hide();
    tip.back?.focus();
  });
  document.addEventListener("pointerdown", (event) => {
    if (tip.pinned && !tip.contains(event.target)) hide();
  });
  for (const svg of document.querySelectorAll("figure svg")) if (svg.querySelector("g.axes")) prepare(svg);
})();
