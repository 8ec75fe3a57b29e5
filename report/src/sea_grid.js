// The water as a grid of triangles. Under the plate it follows the plate, elsewhere the wave: each
// vertex under the plate knows its triangle of the plate and its place in it.

// For each vertex of the grid: three nodes and their weights, or nothing (weights 0)
function placeOnPlate(grid, surface) {
  const { nx, ny, x0, y0, step } = grid;
  const nodes = new Uint32Array(3 * (nx + 1) * (ny + 1));
  const weights = new Float32Array(nodes.length);
  const { x, y, triangles } = surface;
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [triangles[t], triangles[t + 1], triangles[t + 2]];
    const [a, b, c] = corners;
    const area = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
    if (area === 0) continue;
    const first = (values, from) => Math.max(0, Math.ceil((Math.min(...values) - from) / step - 1e-6));
    const last = (values, from, most) => Math.min(most, Math.floor((Math.max(...values) - from) / step + 1e-6));
    const columns = [first([x[a], x[b], x[c]], x0), last([x[a], x[b], x[c]], x0, nx)];
    const rows = [first([y[a], y[b], y[c]], y0), last([y[a], y[b], y[c]], y0, ny)];
    for (let j = rows[0]; j <= rows[1]; ++j)
      for (let i = columns[0]; i <= columns[1]; ++i) {
        const [px, py] = [x0 + i * step, y0 + j * step];
        const u = ((x[b] - px) * (y[c] - py) - (x[c] - px) * (y[b] - py)) / area;
        const v = ((x[c] - px) * (y[a] - py) - (x[a] - px) * (y[c] - py)) / area;
        if (u < -1e-6 || v < -1e-6 || u + v > 1 + 1e-6) continue;
        const at = 3 * (j * (nx + 1) + i);
        nodes.set(corners, at);
        weights.set([u, v, 1 - u - v], at);
      }
  }
  return { nodes, weights };
}

// Vertices, triangles and places of the water, `margin` plate sizes around the plate
export function seaGrid(surface, margin = 0.6, cells = 180) {
  const low = [Math.min(...surface.x), Math.min(...surface.y)];
  const high = [Math.max(...surface.x), Math.max(...surface.y)];
  const size = Math.max(high[0] - low[0], high[1] - low[1]);
  const extent = [high[0] - low[0] + 2 * margin * size, high[1] - low[1] + 2 * margin * size];
  const step = Math.max(extent[0], extent[1]) / cells;
  const grid = {
    nx: Math.ceil(extent[0] / step),
    ny: Math.ceil(extent[1] / step),
    x0: low[0] - margin * size,
    y0: low[1] - margin * size,
    step,
  };
  const place = placeOnPlate(grid, surface);
  const { nx, ny } = grid;
  const vertices = new Float32Array(2 * (nx + 1) * (ny + 1));
  for (let j = 0; j <= ny; ++j)
    for (let i = 0; i <= nx; ++i) {
      vertices[2 * (j * (nx + 1) + i)] = grid.x0 + i * step;
      vertices[2 * (j * (nx + 1) + i) + 1] = grid.y0 + j * step;
    }
  const triangles = [];
  for (let j = 0; j < ny; ++j)
    for (let i = 0; i < nx; ++i) {
      const a = j * (nx + 1) + i;
      triangles.push(a, a + 1, a + nx + 2, a, a + nx + 2, a + nx + 1);
    }
  return { vertices, triangles: new Uint32Array(triangles), place, size };
}

// Elevation {re, im} of every vertex: the plate's deflection under it, the incident wave elsewhere;
// vertices are relative to the centre (cx, cy)
export function seaElevation(sea, deflection, [kx, ky], [cx, cy]) {
  const { vertices, place } = sea;
  const elevation = new Float32Array(vertices.length);
  for (let i = 0; i < vertices.length; i += 2) {
    const at = (3 * i) / 2;
    const [u, v, w] = place.weights.subarray(at, at + 3);
    if (u + v + w === 0) {
      const phase = kx * (vertices[i] + cx) + ky * (vertices[i + 1] + cy);
      elevation[i] = Math.cos(phase);
      elevation[i + 1] = Math.sin(phase);
      continue;
    }
    const [a, b, c] = place.nodes.subarray(at, at + 3);
    const { re, im } = deflection;
    elevation[i] = u * re[a] + v * re[b] + w * re[c];
    elevation[i + 1] = u * im[a] + v * im[b] + w * im[c];
  }
  return elevation;
}
