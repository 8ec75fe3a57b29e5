// Small helpers to build the page; text never goes in as HTML.

export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value === true) node.setAttribute(name, '');
    else if (value !== false && value !== undefined) node.setAttribute(name, value);
  }
  node.append(...children.flat().filter((child) => child !== undefined && child !== null));
  return node;
}

let labels = 0;

// A select with its label; `choose` gets the index
export function chooser(label, options, choose, selected = 0) {
  const id = `choice-${++labels}`;
  const select = element(
    'select',
    { id, onchange: () => choose(select.selectedIndex) },
    options.map((text, i) => element('option', { selected: i === selected }, text)),
  );
  return element('span', { class: 'choice' }, element('label', { for: id }, label), select);
}

// A table with a caption; rows are arrays of text or nodes; `numeric` columns align right
// `kind` is a class of the table: "words" for long text
export function table(caption, head, rows, numeric = [], kind = undefined) {
  const align = (i) => (numeric.includes(i) ? 'number' : undefined);
  return element(
    'div',
    { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': caption },
    element(
      'table',
      { class: kind },
      element('caption', {}, caption),
      element(
        'thead',
        {},
        element('tr', {}, head.map((text, i) => element('th', { scope: 'col', class: align(i) }, text))),
      ),
      element(
        'tbody',
        {},
        rows.map((row) =>
          element('tr', {}, row.map((cell, i) => element('td', { class: align(i) }, cell))),
        ),
      ),
    ),
  );
}

export function section(id, title, ...children) {
  return element(
    'section',
    { id, 'aria-labelledby': `${id}-title` },
    element('h2', { id: `${id}-title` }, title),
    ...children,
  );
}
