// What the server says; docs/studio.md describes it.

type Place = [number, number, number];
type FlatPlace = [number, number];

interface Piles {
  level: number[];
  up: number[];
}

interface OfFaces {
  most: number;
  faces: number[];
}

interface Shape {
  vertices: number[];
  faces: number[][];
  piles: Piles;
  strain: OfFaces;
  planarity: OfFaces;
}

interface FoldStep {
  do: string;
  note?: string;
  degrees?: number;
  layers?: string;
  faces?: FlatPlace[];
}

interface FoldState extends Shape {
  title: string;
  side: number;
  at: number;
  log: FoldStep[];
  flat: boolean;
  open: boolean;
  crossing_pairs: number;
  edges: { from: number; to: number; crease: string; degrees: number }[];
  waiting: { from: FlatPlace; to: FlatPlace; crease: string }[];
  pins: Place[];
  chosen: number[];
  chosen_places: FlatPlace[];
  flat_vertices: FlatPlace[];
}

interface Aim {
  place: Place;
  by: 'vertex' | 'crossing' | 'division' | 'direction' | 'paper' | 'ground';
  face: number;
  guides: [Place, Place][];
  points: Place[];
}

interface Grip {
  face: number;
  axis: [Place, Place];
  click: Place;
  centre: Place;
  turn_view: boolean;
}

interface Drag extends Shape {
  degrees: number;
  met: boolean;
}

interface Ray {
  eye: Place;
  way: Place;
}
