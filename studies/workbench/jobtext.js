// Changes of a job or an item in its text, at the places that the engine's reader gives: what somebody wrote stays.

const asText = (value) => JSON.stringify(value);

/// The elements of a table by keys, as `excitation.record`.
function within(tree, ...path) {
  return path.reduce((node, key) => node && node.keys && node.keys[key], tree);
}

function itemsOf(tree) {
  const items = within(tree, 'item');
  if (!items) return [];
  return items.list || [items];
}

const isHeader = (line) => /^\s*\[/.test(line);

/// One past the last line of a table that begins at a line; its own tables are part of it.
function endOf(lines, first, name) {
  let end = first;
  const own = new RegExp(`^\\s*\\[\\[?\\s*${name.replaceAll('.', '\\.')}\\.`);
  while (end < lines.length && (!isHeader(lines[end]) || own.test(lines[end]))) ++end;
  return end;
}

/// What stands below the header of a table.
function bodyOf(text, name) {
  const lines = text.split('\n');
  const first = lines.findIndex((line) => line.replace(/\s/g, '').startsWith(`[${name}]`)) + 1;
  return lines.slice(first, endOf(lines, first, name)).join('\n').trim();
}

/// Sets a key of a table with a header of its own. Lines are counted from 1.
function withKey(text, table, key, value) {
  const lines = text.split('\n');
  const known = table.keys[key];
  if (value === null) {
    if (known) lines.splice(known.key_line - 1, 1);
  } else if (known) {
    lines[known.key_line - 1] = `${key} = ${value}`;
  } else {
    const places = Object.values(table.keys).map((each) => each.key_line);
    const after = places.length ? Math.min(...places) : table.line + 1;
    lines.splice(after - 1 + (places.length ? 1 : 0), 0, `${key} = ${value}`);
  }
  return lines.join('\n');
}

/// Without the table of this name and its own tables.
function withoutTable(text, name) {
  const lines = text.split('\n');
  const header = new RegExp(`^\\s*\\[\\[?\\s*${name.replaceAll('.', '\\.')}(\\.[^\\]]*)?\\s*\\]\\]?`);
  for (let i = 0; i < lines.length; ) {
    if (header.test(lines[i])) lines.splice(i, endOf(lines, i + 1, name) - i);
    else ++i;
  }
  return lines.join('\n').replace(/\n{3,}/g, '\n\n');
}

/// Without the tethers of an item.
function withoutTethers(text, tree, item) {
  const tethers = tree.keys.tether?.list || [];
  const its = tethers.filter(({ keys }) => (keys.item?.value ?? item) === item);
  return its.reduceRight((shorter, table) => withoutElement(shorter, table, 'tether'), text).replace(/\n{3,}/g, '\n\n');
}

const withTable = (text, name, body) => `${withoutTable(text, name).trimEnd()}\n\n[${name}]\n${body}\n`;

const kItemHeader = /^\s*\[\[?\s*item\s*\]\]?/;

function itemLines(lines) {
  return lines.flatMap((line, i) => (kItemHeader.test(line) ? [i] : []));
}

function withItem(text, equipment, name, at) {
  const lines = text.split('\n').map((line) => line.replace(/^\s*\[\s*item\s*\]/, '[[item]]'));
  const body = ['[[item]]', `equipment = ${asText(equipment)}`, `name = ${asText(name)}`, `position_m = [${at.join(', ')}]`, ''];
  const last = itemLines(lines).pop();
  const place = last === undefined ? lines.length : endOf(lines, last + 1, 'item');
  lines.splice(place, 0, ...body);
  return lines.join('\n');
}

function withoutItem(text, index) {
  const lines = text.split('\n');
  const first = itemLines(lines)[index];
  lines.splice(first, endOf(lines, first + 1, 'item') - first);
  return lines.join('\n').replace(/\n{3,}/g, '\n\n');
}

// Values at their places, as an item's numbers with all that is said of them.

const offsetOf = (text, { line, column }) => text.split('\n').slice(0, line - 1).join('\n').length + (line > 1 ? 1 : 0) + column - 1;

function endOfString(text, start) {
  const quote = text.slice(start).match(/^("""|'''|"|')/)[0];
  let i = start + quote.length;
  while (i < text.length && !text.startsWith(quote, i)) i += quote[0] === '"' && text[i] === '\\' ? 2 : 1;
  return i + quote.length;
}

/// One past the end of the value that begins here.
function endOfValue(text, start) {
  let depth = 0;
  for (let i = start; i < text.length; ++i) {
    const c = text[i];
    if (c === '"' || c === "'") i = endOfString(text, i) - 1;
    else if (c === '#') i = Math.max(i, text.indexOf('\n', i));
    else if (c === '[' || c === '{') ++depth;
    else if (c === ']' || c === '}') --depth;
    else if (depth === 0 && /[\s,]/.test(c)) return i;
    if (depth < 0) return i;
    if (depth === 0 && /["'\]}]/.test(text[i])) return i + 1;
  }
  return text.length;
}

function withValue(text, node, value) {
  const start = offsetOf(text, node);
  return text.slice(0, start) + value + text.slice(endOfValue(text, start));
}

/// What a quantity says, with or without its provenance: a number, a text, or numbers.
function valueOf(node) {
  const stated = node?.keys ? node.keys.value : node;
  return stated?.list ? stated.list.map(({ value }) => value) : stated?.value;
}

/// Sets a quantity of a table. Its source, range and distribution stay, unless it is to be bare: then the
/// number stands alone, since what was said of it does not hold.
function withQuantity(text, table, key, value, bare) {
  const known = table.keys[key];
  if (!known) return withKey(text, table, key, value);
  if (!known.keys) return withValue(text, known, value);
  if (!bare) return withValue(text, known.keys.value, value);
  if (text[offsetOf(text, known)] === '{') return withValue(text, known, value);
  const lines = text.split('\n');
  const name = lines[known.line - 1].match(/\[\s*([^\]]*?)\s*\]/)[1];
  let end = endOf(lines, known.line, name);
  while (end > known.line && /^\s*(#.*)?$/.test(lines[end - 1])) --end;
  lines.splice(known.line - 1, end - known.line + 1);
  lines.splice(table.line, 0, `${key} = ${value}`);
  return lines.join('\n');
}

/// Without one table of an array of tables, as `[[shape]]`.
function withoutElement(text, table, name) {
  const lines = text.split('\n');
  lines.splice(table.line - 1, endOf(lines, table.line, name) - table.line + 1);
  return lines.join('\n');
}
