// Pictures and films of the view, with its names and the time.

class Saving {
  constructor(player) {
    this.player = player;
    this.canvas = document.createElement('canvas');
    element('picture').hidden = !player.renderer;
    element('picture').addEventListener('click', () => this.picture());
    element('film').hidden = !player.renderer || !window.MediaRecorder || !this.canvas.captureStream;
    element('film').addEventListener('click', () => (this.recorder ? this.stop() : this.film()));
  }

  /// What is seen now, on a canvas of its own.
  compose() {
    const view = element('view');
    const scale = view.width / view.clientWidth;
    if (this.canvas.width !== view.width || this.canvas.height !== view.height) {
      this.canvas.width = view.width;
      this.canvas.height = view.height;
    }
    const pen = this.canvas.getContext('2d');
    pen.drawImage(view, 0, 0);
    pen.font = `${12 * scale}px system-ui, sans-serif`;
    pen.textBaseline = 'middle';
    const plate = (text, left, top, color) => {
      const width = pen.measureText(text).width + 12 * scale;
      pen.globalAlpha = 0.82;
      pen.fillStyle = this.player.dark ? '#1c2027' : '#ffffff';
      pen.fillRect(left * scale - width / 2, (top - 10) * scale, width, 20 * scale);
      pen.globalAlpha = 1;
      pen.fillStyle = color ? cssColor(color) : this.player.dark ? '#e4e8ee' : '#1d2530';
      pen.textAlign = 'center';
      pen.fillText(text, left * scale, top * scale);
    };
    for (const { text, left, top, color } of this.player.placedLabels || []) plate(text, left, top, color);
    plate(`${this.player.time.toFixed(2)} s`, view.clientWidth / 2, view.clientHeight - 16);
    return this.canvas;
  }

  download(blob, ending) {
    const name = document.title.replace(/ – Gurney$/, '').replace(/[^\p{L}\p{N}]+/gu, '_').slice(0, 60);
    const link = made('a', undefined, { href: URL.createObjectURL(blob), download: `${name}.${ending}` });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    this.last = blob;
  }

  picture() {
    this.player.draw();
    this.compose().toBlob((blob) => this.download(blob, `${this.player.time.toFixed(2)}s.png`), 'image/png');
  }

  /// Records the view from now on, until it ends or is stopped.
  film() {
    const types = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];
    const chunks = [];
    this.compose();
    this.recorder = new MediaRecorder(this.canvas.captureStream(30), {
      mimeType: types.find((type) => MediaRecorder.isTypeSupported(type)), videoBitsPerSecond: 8e6 });
    this.recorder.addEventListener('dataavailable', (event) => chunks.push(event.data));
    this.recorder.addEventListener('stop', () => this.download(new Blob(chunks, { type: 'video/webm' }), 'webm'));
    this.recorder.start();
    element('film').setAttribute('aria-pressed', 'true');
    if (!this.player.playing) this.player.toggle(true);
  }

  stop() {
    this.recorder.stop();
    this.recorder = null;
    element('film').setAttribute('aria-pressed', 'false');
    this.player.toggle(false);
  }

  /// To be called once the view is drawn.
  drawn() {
    if (!this.recorder) return;
    this.compose();
    if (!this.player.playing) this.stop();
  }
}
