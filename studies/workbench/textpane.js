// A text with its line numbers, and the errors that the engine has found in it.

class TextPane {
  /// @param file     how messages of the engine name the text
  /// @param fields   [key, control] of keys that have a control: it is marked where a message names its key
  /// @param changed  called a moment after the last change by hand
  constructor({ text, lines, errors, file, fields = [], changed }) {
    Object.assign(this, { text, lines, errors, file, fields });
    let later;
    text.addEventListener('input', () => {
      this.showErrors('');
      clearTimeout(later);
      later = setTimeout(changed, 300);
    });
    text.addEventListener('scroll', () => (lines.scrollTop = text.scrollTop));
  }

  get value() {
    return this.text.value;
  }

  set value(value) {
    const at = this.text.scrollTop;
    this.text.value = value;
    this.text.scrollTop = at;
    this.showErrors('');
  }

  /// One line for each error, which leads to its place in the text.
  showErrors(found) {
    const errors = found.split('\n').filter(Boolean).map((line) => line.replace(/^\/usr\/share\/gurney\/studies\/jobs\//, ''));
    const places = errors.map((line) => (line.startsWith(`${this.file}:`) ? line.slice(this.file.length).match(/^:(\d+):(\d+): /) : null));
    this.errors.replaceChildren(
      ...errors.map((line, i) => {
        const button = made('button', places[i] ? `line ${places[i][1]}: ${line.slice(this.file.length + places[i][0].length)}` : line, { type: 'button' });
        button.addEventListener('click', () => places[i] && this.goTo(+places[i][1], +places[i][2]));
        const row = made('li');
        row.append(button);
        return row;
      }),
    );
    for (const [key, control] of this.fields) {
      const about = errors.filter((line) => line.split(' ').some((word) => word.replace(/:$/, '').endsWith(key)));
      control.setAttribute('aria-invalid', about.length > 0);
      control.title = about.join('\n');
    }
    const bad = new Set(places.filter(Boolean).map(([, line]) => +line));
    this.lines.replaceChildren(...this.value.split('\n').flatMap((_, i) => [made(bad.has(i + 1) ? 'b' : 'span', String(i + 1)), '\n']));
  }

  goTo(line, column) {
    for (let around = this.text.parentElement; around; around = around.parentElement) if (around.tagName === 'DETAILS') around.open = true;
    const at = offsetOf(this.value, { line, column });
    this.text.focus();
    this.text.setSelectionRange(at, at + 1);
    this.scrollTo(line);
  }

  scrollTo(line) {
    this.text.scrollTop = Math.max(0, (line - 5) * 18);
  }
}
