// Whether two FOLD files hold the same model: vertices may be numbered in another way.

const close = 1e-9;

const gap = (a, b) => Math.hypot(...a.map((x, k) => x - (b[k] ?? 0)));

/** @returns {string} what differs first; empty if nothing does */
export function difference(one, other) {
  const [flat, otherFlat] = [one, other].map((file) => file.file_frames[0].vertices_coords);
  if (flat.length !== otherFlat.length) return `${flat.length} and ${otherFlat.length} vertices`;
  const name = flat.map((place) => otherFlat.findIndex((there) => gap(place, there) < close));
  const lost = name.findIndex((v) => v < 0);
  if (lost >= 0) return `vertex ${lost} at ${flat[lost]} of the sheet is missing`;
  for (const [v, place] of one.vertices_coords.entries()) {
    const there = other.vertices_coords[name[v]];
    if (gap(place, there) > close) return `vertex ${v} lies at ${place}, not at ${there}`;
  }
  const key = (list) => [...list].sort((a, b) => a - b).join(' ');
  const edges = new Map(other.edges_vertices.map((edge, e) => [key(edge), other.edges_assignment[e]]));
  for (const [e, edge] of one.edges_vertices.entries()) {
    const crease = edges.get(key(edge.map((v) => name[v])));
    if (crease !== one.edges_assignment[e]) return `edge ${e} is ${one.edges_assignment[e]}, not ${crease}`;
  }
  const faces = new Map(other.faces_vertices.map((face, f) => [key(face), f]));
  const faceName = one.faces_vertices.map((face) => faces.get(key(face.map((v) => name[v]))));
  if (faceName.includes(undefined) || faces.size !== faceName.length) return 'the faces differ';
  const orders = new Map((other.faceOrders ?? []).map(([a, b, order]) => [`${a} ${b}`, order]));
  for (const [a, b, order] of one.faceOrders ?? []) {
    const there = orders.get(`${faceName[a]} ${faceName[b]}`);
    const back = orders.get(`${faceName[b]} ${faceName[a]}`);
    if (there === undefined && back === undefined) return `the order of faces ${a} and ${b} is not told`;
    if (there !== undefined && there !== order) return `face ${a} lies on the other side of ${b}`;
  }
  return '';
}
