// Chapter 08: what acts on the leaf of a quadtree that the reader picks, and how many operations a sum takes.
{
  const plane = new figures.Panel({left: 60, top: 70, width: 400, height: 400}, [-1.1, 1.1], [-1.1, 1.1]);

  // Ellipses of 16 nodes, placed like the seeds of a sunflower; they are smaller and closer in the middle.
  const nodesOf = bodies => Array.from({length: 16 * bodies}, (_, i) => {
    const k = Math.floor(i / 16), radius = Math.pow((k + 0.5) / bodies, 0.8), angle = 2.4 * k;
    const t = Math.PI * (i % 16) / 8, size = 0.7 * radius / Math.sqrt(k + 1);
    const x = size * Math.cos(t), y = 0.5 * size * Math.sin(t), c = Math.cos(3 * angle), s = Math.sin(3 * angle);
    return [radius * Math.cos(angle) + c * x - s * y, radius * Math.sin(angle) + s * x + c * y];
  });

  function enclose(nodes, parent) {
    const xs = nodes.map(([x]) => x), ys = nodes.map(([, y]) => y);
    const lower = [Math.min(...xs), Math.min(...ys)], upper = [Math.max(...xs), Math.max(...ys)];
    const x = 0.5 * (lower[0] + upper[0]), y = 0.5 * (lower[1] + upper[1]);
    const radius = Math.max(1e-100, ...nodes.map(node => Math.hypot(node[0] - x, node[1] - y)));
    return {nodes, parent, lower, upper, x, y, radius, level: parent ? parent.level + 1 : 0, children: [],
            far: [], near: []};
  }

  // Divides boxes with more nodes than a leaf may have. Returns all boxes, level by level.
  function tree(nodes, leafSize) {
    const boxes = [enclose(nodes, null)];
    for (const box of boxes) {  // the list grows while the loop runs
      if (box.nodes.length <= leafSize) continue;
      for (const [below, left] of [[true, true], [true, false], [false, true], [false, false]]) {
        const part = box.nodes.filter(([x, y]) => (x <= box.x) === left && (y <= box.y) === below);
        if (part.length > 0) box.children.push(enclose(part, box));
      }
      boxes.push(...box.children);
    }
    return boxes;
  }

  // The dual-tree traversal of the chapter.
  function visit(target, source, cheapPairs) {
    const reach = target.radius + source.radius + Math.max(target.radius, source.radius);
    const separated = reach ** 2 < (target.x - source.x) ** 2 + (target.y - source.y) ** 2;
    const leaves = [target, source].map(box => box.children.length === 0);
    const cheap = leaves[0] && target.nodes.length * source.nodes.length <= cheapPairs;
    if (separated && !cheap) target.far.push(source);
    else if (separated || (leaves[0] && leaves[1])) target.near.push(source);
    else if (leaves[1] || (!leaves[0] && target.radius >= source.radius)) {
      for (const child of target.children) visit(child, source, cheapPairs);
    } else for (const child of source.children) visit(target, child, cheapPairs);
  }

  let last = {};  // the plan does not depend on the leaf that is picked
  function planOf({bodies, leafSize, p}) {
    const key = [bodies, leafSize, p].join();
    if (last.key !== key) {
      const nodes = nodesOf(bodies), boxes = tree(nodes, leafSize), cheapPairs = Math.floor(p * p / 2);
      visit(boxes[0], boxes[0], cheapPairs);
      last = {key, nodes, boxes, leaves: boxes.filter(box => box.children.length === 0)};
    }
    return last;
  }

  const sum = (list, value) => list.reduce((total, item) => total + value(item), 0);

  // The leaf of the node that is nearest to a point.
  function pick(leaves, [x, y]) {
    const distance = leaf => Math.min(...leaf.nodes.map(([a, b]) => (a - x) ** 2 + (b - y) ** 2));
    return leaves.reduce((best, leaf) => distance(leaf) < distance(best) ? leaf : best);
  }

  // A box and all boxes that contain it.
  const lineage = box => box ? [...lineage(box.parent), box] : [];

  figures.add("fmm", {
    settings: {x: 0.36, y: 0.3, bodies: 100, leafSize: 48, p: 8},
    sliders: {bodies: ["ellipses of 16 nodes", 20, 200, 10], leafSize: ["nodes of a leaf, at most", 8, 128, 8],
              p: ["order <i>p</i>", 2, 30, 1]},
    handles: [{panel: plane, label: "target", step: 0.08, anywhere: true, at: ({x, y}) => [x, y],
               to: (_, point) => {
                 const [x, y] = point.map(value => Math.min(1.05, Math.max(-1.05, value)));
                 return {x, y};
               }}],
    shown: {n: "nodes <i>n</i>", own: "nodes of the leaf", near: "nodes that act directly",
            far: "expansions that act for the others", operations: "operations of the whole sum",
            share: "over <i>n</i><sup>2</sup>"},

    numbers(settings) {
      const {nodes, boxes, leaves} = planOf(settings), leaf = pick(leaves, [settings.x, settings.y]);
      const n = nodes.length, operations = sum(boxes, box => settings.p ** 2 / 2 * box.far.length +
        box.nodes.length * sum(box.near, source => source.nodes.length));
      return {n, own: leaf.nodes.length, near: sum(leaf.near, box => box.nodes.length),
              far: sum(lineage(leaf), box => box.far.length), operations, share: operations / n ** 2};
    },

    draw(settings, {near}) {
      const {nodes, boxes, leaves} = planOf(settings), leaf = pick(leaves, [settings.x, settings.y]);
      const rectangle = ({lower: [a, b], upper: [c, d]}) => plane.path([[a, b], [c, b], [c, d], [a, d]], true);
      const draw = (list, colour, more) => list.length === 0 ? "" :
        `<g class="${colour}"><path d="${list.map(rectangle).join("")}" ${more}/></g>`;
      const filled = 'fill="currentColor" fill-opacity="0.22" stroke="currentColor" stroke-width="1.2"';
      const far = lineage(leaf).filter(box => box.far.length > 0);
      const colours = ["line-1", "line-2", "line-3", "line-4", "line-5"];
      const labels = [["line-0", `direct: ${near} nodes`],
                      ...far.map((box, k) => [colours[k % 5], `level ${box.level}: ${box.far.length}`])];
      const dots = nodes.map(point => "M" + plane.toPixel(point).map(v => v.toFixed(1)).join(" ") + "h0").join("");
      return [
        draw(leaves, "", 'fill="none" stroke="currentColor" stroke-opacity="0.25" stroke-width="0.8"'),
        ...far.map((box, k) => draw(box.far, colours[k % 5], filled)),
        draw(leaf.near, "line-0", filled),
        draw(far, "", 'fill="none" stroke="currentColor" stroke-opacity="0.7" stroke-dasharray="3 3"'),
        `<path d="${dots}" stroke="currentColor" stroke-width="1.7" stroke-linecap="round"/>`,
        plane.dots([[settings.x, settings.y]], "line-1", 3),
        draw([leaf], "", 'fill="none" stroke="currentColor" stroke-width="2.4"'),
        plane.label([-1.1, 1.1], "Boxes that act on the framed leaf, or on a dashed box that contains it:", "",
                    {dx: -44, dy: -42}),
        ...labels.map(([colour, words], k) => plane.label([-1.1, 1.1], words, colour,
                                                          {dx: -44 + (k === 0 ? 0 : 50 + 80 * k), dy: -22})),
      ];
    },
  });
}
