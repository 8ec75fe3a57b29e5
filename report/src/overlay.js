// What is written over the 3-D view: the points of the case, and where the wave comes from.

const svg = (tag, attributes, ...children) => {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
};

// The drawn node nearest to a point of the case
function nearestNode({ x, y }, point) {
  let best = 0;
  let least = Infinity;
  for (let i = 0; i < x.length; ++i) {
    const distance = (x[i] - point.x) ** 2 + (y[i] - point.y) ** 2;
    if (distance < least) [best, least] = [i, distance];
  }
  return best;
}

export class Overlay {
  constructor(view, surface, points) {
    this.view = view;
    this.reach = (direction) => {
      let most = -Infinity;
      for (let i = 0; i < surface.x.length; ++i)
        most = Math.max(most, (surface.x[i] - view.centre[0]) * direction[0] + (surface.y[i] - view.centre[1]) * direction[1]);
      return most;
    };
    this.marks = points.slice(0, 12).map((point) => ({
      point,
      node: nearestNode(surface, point),
      dot: svg('circle', { r: 3.5 }),
      text: svg('text', {}, point.name),
    }));
    this.arrow = svg('line', { class: 'arrow', 'marker-end': 'url(#arrow-head)' });
    this.word = svg('text', { class: 'arrow-word' }, 'wave');
    const head = svg('marker', { id: 'arrow-head', viewBox: '0 0 8 8', refX: 6, refY: 4, markerWidth: 5, markerHeight: 5, orient: 'auto' },
      svg('path', { d: 'M0 0 L8 4 L0 8 z' }));
    this.box = svg('svg', { class: 'overlay', 'aria-hidden': 'true' }, svg('defs', {}, head), this.arrow, this.word,
      ...this.marks.flatMap(({ dot, text }) => [dot, text]));
  }

  setHeading(radians) {
    this.direction = [Math.cos(radians), Math.sin(radians)];
    const [dx, dy] = this.direction;
    const [cx, cy] = this.view.centre;
    const near = this.reach([-dx, -dy]) + 0.07 * this.view.size;
    const far = near + 0.22 * this.view.size;
    this.ends = [[cx - far * dx, cy - far * dy], [cx - near * dx, cy - near * dy]];
  }

  update() {
    const { view } = this;
    for (const { point, node, dot, text } of this.marks) {
      const at = view.pixel(point.x, point.y, view.height(node));
      for (const item of [dot, text]) item.setAttribute('visibility', at ? 'visible' : 'hidden');
      if (!at) continue;
      dot.setAttribute('cx', at[0]);
      dot.setAttribute('cy', at[1]);
      text.setAttribute('x', at[0] + 6);
      text.setAttribute('y', at[1] - 5);
    }
    const [from, to] = this.ends.map(([x, y]) => view.pixel(x, y, 1.4 * view.lift));
    for (const item of [this.arrow, this.word]) item.setAttribute('visibility', from && to ? 'visible' : 'hidden');
    if (!from || !to) return;
    Object.entries({ x1: from[0], y1: from[1], x2: to[0], y2: to[1] }).forEach(([name, value]) => this.arrow.setAttribute(name, value));
    this.word.setAttribute('x', Math.max(4, 0.5 * (from[0] + to[0]) - 18));
    this.word.setAttribute('y', 0.5 * (from[1] + to[1]) - 9);
  }
}
