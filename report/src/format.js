// Numbers as people read them.

const prefixes = [
  [1e9, 'G'],
  [1e6, 'M'],
  [1e3, 'k'],
];

export function number(value, digits = 3) {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return '∞';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
    return `${mantissa} × 10${superscript(Number(exponent))}`;
  }
  return Number(value.toPrecision(digits)).toLocaleString('en', { maximumSignificantDigits: digits });
}

function superscript(integer) {
  return String(integer).replace(/[-0-9]/g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c]));
}

// With its unit; forces, moments and stresses get a prefix: 1.23 MN/m
export function withUnit(value, unit, digits = 3) {
  if (!/^(N|Pa)/.test(unit)) return `${number(value, digits)}${unit ? ` ${unit}` : ''}`;
  const [factor, prefix] = prefixes.find(([f]) => Math.abs(value) >= f) ?? [1, ''];
  return `${number(value / factor, digits)} ${prefix}${unit}`;
}

export function duration(seconds) {
  if (seconds < 60) return `${number(seconds, 2)} s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return `${minutes} min ${Math.round(seconds % 60)} s`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

export function bytes(count) {
  const units = ['B', 'kB', 'MB', 'GB', 'TB'];
  let i = 0;
  while (count >= 1000 && i + 1 < units.length) {
    count /= 1000;
    ++i;
  }
  return `${number(count, 3)} ${units[i]}`;
}

export const counted = (count, what) => `${count.toLocaleString('en')} ${what}${count === 1 ? '' : 's'}`;

// "significant_height = 2" reads "significant height 2"
export const inWords = (text) => text.replaceAll('_', ' ').replaceAll(' = ', ' ');
