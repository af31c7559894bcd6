// What would have prevented it: the changes that the engine proposes, each run, best first.

const kReplicas = 5;
const kAsItWas = 'as it was';

/// The text of a job with a change of alternatives_answer().
function withChange(text, tree, subject, { item, append, floor }) {
  for (const { key, value } of item) text = withKey(text, itemsOf(tree)[subject], key, value);
  for (const table of append) text = `${text.trimEnd()}\n\n${table}`;
  if (floor === null) return text;
  const table = within(tree, 'floor');
  return table ? withKey(text, table, 'covering', floor) : withTable(text, 'floor', `covering = ${floor}`);
}

const middle = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

class Prevented {
  /// @param taken  (text): called with the job that somebody chooses
  constructor(engines, taken) {
    this.engines = engines;
    this.taken = taken;
    this.clear();
  }

  clear() {
    this.series = (this.series || 0) + 1;
    element('prevented').replaceChildren();
  }

  async ask(text, tree) {
    this.clear();
    const { series } = this;
    const say = (words) => element('prevented').replaceChildren(made('p', words, { role: 'status' }));
    say('Looking for what might have prevented it…');
    const found = await this.engines.ask('alternatives', text);
    if (series !== this.series) return;
    if (found.error) return void say(found.error);
    const rows = [{ name: kAsItWas, text }, ...found.alternatives.map((each) => ({ name: each.name, text: withChange(text, tree, found.subject, each) }))];
    this.found = { ...found, rows };
    this.show();
    const runs = found.chaotic ? kReplicas : 1;
    await Promise.all(
      rows.map(async (row) => {
        const outcomes = await Promise.all(Array.from({ length: runs }, (_, i) => this.engines.ask('outcome', String(i), row.text)));
        if (series !== this.series) return;
        this.sumUp(row, outcomes);
        this.show();
      }),
    );
    if (series !== this.series) return;
    rows.sort((a, b) => !!a.error - !!b.error || a.count - b.count || a.peak - b.peak);
    this.show();
    window.lastPrevented = rows;
  }

  sumUp(row, outcomes) {
    const good = outcomes.filter((outcome) => !outcome.error);
    row.error = good.length ? '' : outcomes[0].error.replace(/^.*job\.toml:\d+:\d+: /, '').split('\n')[0];
    if (row.error) return;
    row.count = 0;
    row.states = good[0].limit_states.flatMap(({ name }, i) => {
      const times = good.filter((outcome) => outcome.limit_states[i].exceeded).length;
      row.count += times;
      return times ? [good.length > 1 ? `${name} in ${times} of ${good.length}` : name] : [];
    });
    row.peak = middle(good.map((outcome) => outcome.peak_displacement[this.found.subject]));
  }

  show() {
    const { rows, subject_name: name, chaotic } = this.found;
    const table = made('table');
    const head = table.createTHead().insertRow();
    for (const words of ['change', 'still', `${name} moves by at most`, '']) head.append(made('th', words, { scope: 'col' }));
    const body = table.createTBody();
    for (const row of rows) {
      const line = body.insertRow();
      if (row.name === kAsItWas) line.className = 'now';
      line.append(made('th', row.name, { scope: 'row' }));
      if (row.error) line.append(made('td', row.error, { colspan: 2, class: 'hint' }));
      else if (!row.states) line.append(made('td', '…'), made('td', ''));
      else line.append(made('td', row.states.join(', ') || 'nothing', row.states.length ? {} : { class: 'none' }), made('td', `${Math.round(1000 * row.peak)} mm`));
      const last = line.insertCell();
      if (row.name === kAsItWas || row.error) continue;
      const take = made('button', 'Take over', { type: 'button', 'aria-label': `Take over: ${row.name}` });
      take.addEventListener('click', () => this.taken(row.text));
      last.append(take);
    }
    const about = `Changes of ${name}, one at a time. ${chaotic ? `The run is chaotic: each stands for ${kReplicas} runs with masses that nobody could tell apart; the distance is their median.` : 'One run of each.'}`;
    element('prevented').replaceChildren(made('p', about, { class: 'hint' }), table);
  }
}
