// The plate in three dimensions: turns, zooms, moves over the wave period, tells the value under
// the pointer.
import { maps } from './colours.js';
import { multiply, orbit, perspective, project } from './matrices.js';
import { seaElevation, seaGrid } from './sea_grid.js';
import * as shaders from './shaders.js';

function compile(gl, vertex, fragment) {
  const program = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}

// A program with vertex arrays and an index buffer, ready to draw
class Layer {
  constructor(gl, program, mode, indices) {
    this.gl = gl;
    this.program = program;
    this.mode = mode;
    this.count = indices.length;
    this.array = gl.createVertexArray();
    this.buffers = {};
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  }

  set(name, values, size) {
    const { gl } = this;
    const at = gl.getAttribLocation(this.program, name);
    if (at < 0) return;
    gl.bindVertexArray(this.array);
    this.buffers[name] ??= gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[name]);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.DYNAMIC_DRAW);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, gl.FLOAT, false, 0, 0);
  }

  uniform(name, values) {
    const { gl } = this;
    const at = gl.getUniformLocation(this.program, name);
    if (at === null) return;
    gl.useProgram(this.program);
    const list = Array.isArray(values) ? values : [values];
    if (values.length === 16) gl.uniformMatrix4fv(at, false, values);
    else if (typeof values === 'boolean') gl.uniform1i(at, values ? 1 : 0);
    else gl[`uniform${list.length}f`](at, ...list);
  }

  draw() {
    const { gl } = this;
    gl.useProgram(this.program);
    gl.bindVertexArray(this.array);
    gl.drawElements(this.mode, this.count, gl.UNSIGNED_INT, 0);
  }
}

const interleave = (a, b) => {
  const both = new Float32Array(2 * a.length);
  a.forEach((value, i) => {
    both[2 * i] = value;
    both[2 * i + 1] = b[i];
  });
  return both;
};

export class PlateView {
  // `surface`: x, y, triangles, edges of the plate
  constructor(canvas, surface) {
    const gl = canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error('this browser draws no WebGL 2');
    Object.assign(this, { canvas, gl, surface });
    this.centre = [0, 1].map((axis) => {
      const values = axis === 0 ? surface.x : surface.y;
      return (Math.min(...values) + Math.max(...values)) / 2;
    });
    const centred = {
      ...surface,
      x: surface.x.map((value) => value - this.centre[0]),
      y: surface.y.map((value) => value - this.centre[1]),
    };
    this.grid = seaGrid(centred);
    this.size = this.grid.size;
    this.x = centred.x;
    this.y = centred.y;
    const positions = interleave(this.x, this.y);
    this.plate = new Layer(gl, compile(gl, shaders.plateVertex, shaders.plateFragment), gl.TRIANGLES, surface.triangles);
    this.sea = new Layer(gl, compile(gl, shaders.seaVertex, shaders.seaFragment), gl.TRIANGLES, this.grid.triangles);
    this.outline = new Layer(gl, compile(gl, shaders.lineVertex, shaders.lineFragment), gl.LINES, surface.edges);
    this.plate.set('position', positions, 2);
    this.outline.set('position', positions, 2);
    this.sea.set('position', this.grid.vertices, 2);
    this.texture = gl.createTexture();
    this.camera = this.#home();
    this.phase = 0;
    this.#listen();
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  // Deflection {re, im} of all nodes, the wave number vector, and the height drawn for one metre
  setMotion(deflection, waveVector, lift) {
    const both = interleave(deflection.re, deflection.im);
    this.plate.set('deflection', both, 2);
    this.outline.set('deflection', both, 2);
    this.sea.set('elevation', seaElevation(this.grid, deflection, waveVector, this.centre), 2);
    Object.assign(this, { deflection, lift });
  }

  // What the colours mean: `values` of the nodes, or null for the moving deflection itself
  setColours(values, map, range) {
    const { gl } = this;
    this.plate.set('colour', values ?? new Float32Array(this.x.length), 1);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, maps[map]);
    for (const name of ['MIN_FILTER', 'MAG_FILTER'])
      gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    Object.assign(this, { values, range });
  }

  setTheme({ water, ink }) {
    Object.assign(this, { water, ink });
  }

  draw() {
    const { gl, canvas } = this;
    if (!this.deflection || !this.water) return;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio].map(Math.round);
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);

    // The whole width stays in sight on narrow screens
    const aspect = width / Math.max(1, height);
    const { azimuth, elevation, distance } = this.camera;
    const far = distance * Math.max(1, 1.35 / aspect);
    this.view = multiply(perspective(0.7, aspect, far / 50, 12 * far), orbit(azimuth, elevation, far));
    for (const layer of [this.plate, this.sea, this.outline]) {
      layer.uniform('view', this.view);
      layer.uniform('phase', this.phase);
      layer.uniform('lift', this.lift);
    }
    this.plate.uniform('range', this.range);
    this.plate.uniform('moving', this.values === null);
    this.sea.uniform('water', this.water);
    this.outline.uniform('ink', this.ink);
    for (const layer of [this.sea, this.plate, this.outline]) layer.draw();
    this.onframe?.();
  }

  // Pixel of a place in the coordinates of the case, z metres of drawn height; null behind the eye
  pixel(x, y, z) {
    if (!this.view || !this.canvas.clientWidth) return null;
    const [px, py, depth] = project(this.view, x - this.centre[0], y - this.centre[1], z);
    if (depth <= 0) return null;
    return [(px + 1) * 0.5 * this.canvas.clientWidth, (1 - py) * 0.5 * this.canvas.clientHeight];
  }

  // Height at which a node is drawn now
  height(node) {
    return this.lift * this.#elevation(node);
  }

  // Node nearest to a pixel of the canvas, or -1
  nodeAt(px, py) {
    if (!this.view) return -1;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    let best = -1;
    let least = 20 * 20;
    for (let i = 0; i < this.x.length; ++i) {
      const z = this.lift * this.#elevation(i);
      const [x, y] = project(this.view, this.x[i], this.y[i], z);
      const distance = ((x + 1) * 0.5 * width - px) ** 2 + ((1 - y) * 0.5 * height - py) ** 2;
      if (distance < least) [best, least] = [i, distance];
    }
    return best;
  }

  #elevation(i) {
    return this.deflection.re[i] * Math.cos(this.phase) + this.deflection.im[i] * Math.sin(this.phase);
  }

  turn(azimuth, elevation) {
    this.camera.azimuth += azimuth;
    this.camera.elevation = Math.min(1.5, Math.max(0.06, this.camera.elevation + elevation));
    this.draw();
  }

  #home() {
    return { azimuth: -1.05, elevation: 0.6, distance: 1.42 * this.size };
  }

  reset() {
    this.camera = this.#home();
    this.draw();
  }

  zoom(factor) {
    this.camera.distance = Math.min(4 * this.size, Math.max(0.25 * this.size, this.camera.distance * factor));
    this.draw();
  }

  #listen() {
    const { canvas } = this;
    canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (event.buttons === 1) this.turn(-event.movementX * 0.008, event.movementY * 0.008);
      else this.onpoint?.(this.nodeAt(event.offsetX, event.offsetY));
    });
    canvas.addEventListener('pointerleave', () => this.onpoint?.(-1));
    canvas.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && !canvas.matches(':focus')) return;  // scrolling the page stays scrolling
      event.preventDefault();
      this.zoom(Math.exp(event.deltaY * 0.001));
    }, { passive: false });
    const keys = {
      ArrowLeft: () => this.turn(-0.1, 0),
      ArrowRight: () => this.turn(0.1, 0),
      ArrowUp: () => this.turn(0, 0.08),
      ArrowDown: () => this.turn(0, -0.08),
      '+': () => this.zoom(0.9),
      '=': () => this.zoom(0.9),
      '-': () => this.zoom(1.1),
      Home: () => this.reset(),
    };
    canvas.addEventListener('keydown', (event) => {
      if (!keys[event.key]) return;
      event.preventDefault();
      keys[event.key]();
    });
  }
}
