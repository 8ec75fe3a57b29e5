// The water as a grid of triangles. Under the plate it follows the plate, elsewhere the incident
// wave, and beside the plate it passes from one to the other: each vertex under the plate knows its
// triangle of the plate and its place in it, each one beside it the nearest place on the outline.

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

// For each vertex within `band` of the outline and not under the plate: two nodes of the outline, the
// place between them, and how much of the plate's motion is left there (0: none)
function placeBeside(vertices, under, surface, band) {
  const count = vertices.length / 2;
  const nodes = new Uint32Array(2 * count);
  const between = new Float32Array(count);
  const left = new Float32Array(count);
  const nearest = new Float32Array(count).fill(band);
  const { x, y, edges } = surface;
  for (let i = 0; i < count; ++i) {
    if (under[3 * i] + under[3 * i + 1] + under[3 * i + 2] > 0) continue;
    const [px, py] = [vertices[2 * i], vertices[2 * i + 1]];
    for (let e = 0; e < edges.length; e += 2) {
      const [a, b] = [edges[e], edges[e + 1]];
      if (Math.abs(x[a] - px) > 3 * band || Math.abs(y[a] - py) > 3 * band) continue;
      const [dx, dy] = [x[b] - x[a], y[b] - y[a]];
      const t = Math.min(1, Math.max(0, ((px - x[a]) * dx + (py - y[a]) * dy) / (dx * dx + dy * dy || 1)));
      const distance = Math.hypot(px - x[a] - t * dx, py - y[a] - t * dy);
      if (distance >= nearest[i]) continue;
      nearest[i] = distance;
      nodes.set([a, b], 2 * i);
      between[i] = t;
      left[i] = (1 - distance / band) ** 2;
    }
  }
  return { nodes, between, left };
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
  const beside = placeBeside(vertices, place.weights, surface, 0.1 * size);
  return { vertices, triangles: new Uint32Array(triangles), place, beside, surface, size };
}

// Elevation {re, im} of every vertex; vertices are relative to the centre (cx, cy)
export function seaElevation(sea, deflection, [kx, ky], [cx, cy]) {
  const { vertices, place, beside, surface } = sea;
  const { re, im } = deflection;
  const elevation = new Float32Array(vertices.length);
  const wave = (x, y) => {
    const phase = kx * (x + cx) + ky * (y + cy);
    return [Math.cos(phase), Math.sin(phase)];
  };
  for (let i = 0; i < vertices.length / 2; ++i) {
    const [u, v, w] = place.weights.subarray(3 * i, 3 * i + 3);
    if (u + v + w > 0) {
      const [a, b, c] = place.nodes.subarray(3 * i, 3 * i + 3);
      elevation.set([u * re[a] + v * re[b] + w * re[c], u * im[a] + v * im[b] + w * im[c]], 2 * i);
      continue;
    }
    const here = wave(vertices[2 * i], vertices[2 * i + 1]);
    if (beside.left[i] > 0) {
      const [a, b] = beside.nodes.subarray(2 * i, 2 * i + 2);
      const t = beside.between[i];
      const at = (values) => values[a] + t * (values[b] - values[a]);
      const edge = wave(at(surface.x), at(surface.y));
      here[0] += beside.left[i] * (at(re) - edge[0]);
      here[1] += beside.left[i] * (at(im) - edge[1]);
    }
    elevation.set(here, 2 * i);
  }
  return elevation;
}
