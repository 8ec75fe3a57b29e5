// Column-major 4 × 4 matrices for the view.

export function multiply(a, b) {
  const product = new Float32Array(16);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row) {
      let sum = 0;
      for (let k = 0; k < 4; ++k) sum += a[4 * k + row] * b[4 * column + k];
      product[4 * column + row] = sum;
    }
  return product;
}

export function perspective(angle, aspect, near, far) {
  const f = 1 / Math.tan(angle / 2);
  return new Float32Array([
    f / aspect, 0, 0, 0,
    0, f, 0, 0,
    0, 0, (far + near) / (near - far), -1,
    0, 0, (2 * far * near) / (near - far), 0,
  ]);
}

// The eye goes round the origin at `distance`, `azimuth` about z, `elevation` above the water
export function orbit(azimuth, elevation, distance) {
  const [ca, sa] = [Math.cos(azimuth), Math.sin(azimuth)];
  const [ce, se] = [Math.cos(elevation), Math.sin(elevation)];
  return new Float32Array([
    -sa, -ca * se, ca * ce, 0,
    ca, -sa * se, sa * ce, 0,
    0, ce, se, 0,
    0, 0, -distance, 1,
  ]);
}

// Clip coordinates divided by w, of a point
export function project(matrix, x, y, z) {
  const at = (row) => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row];
  const w = at(3);
  return [at(0) / w, at(1) / w, w];
}
