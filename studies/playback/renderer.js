// WebGL2: meshes on the graphics card, the shadow of the items, one view.

const kIdentity = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

class Renderer {
  /// @throws Error without WebGL2
  constructor(canvas) {
    this.canvas = canvas;
    const gl = canvas.getContext('webgl2', { alpha: false, antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('WebGL2 is not available');
    this.gl = gl;
    this.solid = this.program(kSolidVertex, kSolidFragment);
    this.depth = this.program(kDepthVertex, kDepthFragment);
    this.line = this.program(kLineVertex, kLineFragment);
    this.makeShadowMap(2048);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  }

  program(vertex, fragment) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    const places = {};
    for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
      const { name } = gl.getActiveUniform(program, i);
      places[name] = gl.getUniformLocation(program, name);
    }
    return { program, places };
  }

  makeShadowMap(size) {
    const gl = this.gl;
    this.shadowSize = size;
    this.shadowMap = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.shadowMap);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT24, size, size, 0, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT, null);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL);
    this.shadowTarget = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadowTarget);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.shadowMap, 0);
    gl.drawBuffers([gl.NONE]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /// Numbers of several attributes, vertex after vertex.
  buffer(numbers, sizes) {
    const gl = this.gl;
    const stride = sizes.reduce((a, b) => a + b);
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(numbers), gl.STATIC_DRAW);
    let offset = 0;
    sizes.forEach((size, i) => {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, size, gl.FLOAT, false, 4 * stride, 4 * offset);
      offset += size;
    });
    gl.bindVertexArray(null);
    return { array, count: numbers.length / stride };
  }

  mesh(builder) {
    const lines = [];
    for (let i = 0; i < builder.edges.length; i += 3) lines.push(...builder.edges.slice(i, i + 3), 1, 1, 1, -1);
    return { faces: this.buffer(builder.vertices, [3, 3, 3]), lines: this.buffer(lines, [3, 3, 1]) };
  }

  /// Vertices of a ribbon: position, colour, time.
  ribbon(numbers) {
    return this.buffer(numbers, [3, 3, 1]);
  }

  resize() {
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map((v) => Math.max(1, Math.round(v * scale)));
    if (this.canvas.width === width && this.canvas.height === height) return;
    this.canvas.width = width;
    this.canvas.height = height;
  }

  draw(buffer, mode) {
    if (!buffer.count) return;
    this.gl.bindVertexArray(buffer.array);
    this.gl.drawArrays(mode, 0, buffer.count);
  }

  drawShadows(parts, light) {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.shadowTarget);
    gl.disable(gl.SCISSOR_TEST);
    gl.viewport(0, 0, this.shadowSize, this.shadowSize);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    gl.useProgram(this.depth.program);
    gl.uniformMatrix4fv(this.depth.places.light, false, light);
    for (const part of parts) {
      if (!part.casts) continue;
      gl.uniformMatrix4fv(this.depth.places.model, false, part.model);
      this.draw(part.mesh.faces, gl.TRIANGLES);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  /// view: { x, y, width, height } in pixels of the canvas, camera, eye, light, sun, theme, now
  drawView(view, parts, ribbons) {
    const gl = this.gl;
    this.drawShadows(parts, view.light);
    gl.enable(gl.SCISSOR_TEST);
    gl.viewport(view.x, view.y, view.width, view.height);
    gl.scissor(view.x, view.y, view.width, view.height);
    gl.clearColor(...view.theme.background, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawFaces(view, parts.filter((part) => part.alpha >= 1));
    this.drawRibbons(view, ribbons);
    this.drawEdges(view, parts);
    gl.enable(gl.BLEND);
    gl.depthMask(false);
    this.drawFaces(view, parts.filter((part) => part.alpha < 1));
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  drawFaces(view, parts) {
    const gl = this.gl;
    const u = this.solid.places;
    gl.useProgram(this.solid.program);
    gl.bindTexture(gl.TEXTURE_2D, this.shadowMap);
    gl.uniformMatrix4fv(u.camera, false, view.camera);
    gl.uniformMatrix4fv(u.light, false, view.light);
    gl.uniform3fv(u.eye, view.eye);
    gl.uniform3fv(u.sun, view.sun);
    gl.uniform1f(u.ambient, view.theme.ambient);
    gl.uniform3fv(u.gridColor, view.theme.grid);
    for (const part of parts) {
      gl.uniformMatrix4fv(u.model, false, part.model);
      gl.uniform4f(u.tint, ...part.tint, part.alpha);
      gl.uniform1i(u.kind, part.kind);
      gl.uniform1f(u.radius, part.radius || 1);
      gl.uniform1f(u.width, part.width || 1);
      this.draw(part.mesh.faces, gl.TRIANGLES);
    }
  }

  drawEdges(view, parts) {
    const gl = this.gl;
    const u = this.startLines(view, 0.0004);
    gl.enable(gl.BLEND);
    for (const part of parts) {
      if (!part.edge) continue;
      gl.uniformMatrix4fv(u.model, false, part.model);
      gl.uniform4f(u.tint, ...part.edge);
      this.draw(part.mesh.lines, gl.LINES);
    }
    gl.disable(gl.BLEND);
  }

  drawRibbons(view, ribbons) {
    const gl = this.gl;
    const u = this.startLines(view, 0.00005);
    gl.enable(gl.BLEND);
    gl.depthMask(false);
    for (const ribbon of ribbons) {
      gl.uniformMatrix4fv(u.model, false, ribbon.model);
      gl.uniform4f(u.tint, 1, 1, 1, ribbon.alpha);
      this.draw(ribbon.buffer, gl.TRIANGLES);
    }
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  startLines(view, nearer) {
    const u = this.line.places;
    this.gl.useProgram(this.line.program);
    this.gl.uniformMatrix4fv(u.camera, false, view.camera);
    this.gl.uniform1f(u.now, view.now);
    this.gl.uniform1f(u.nearer, nearer);
    return u;
  }
}
