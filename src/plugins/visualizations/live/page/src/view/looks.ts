// The colours and lights of the pictures: the same as those of the off-screen view.

export interface Look {
  background: string;
  ground: string;
  groundOutside: string;
  gridLine: string;
  boundary: string;
  marker: string;
  sun: number;
  sky: string;
  bounce: string;
  ambient: number;
  specular: number;
  edges: number;
  contact: number;
  haloStrength: number;
  haloOpacity: number;
  text: string;
  textContour: string;
  accent: string;
}

export const kLightLook: Look = {
  background: "#fcfcfc",
  ground: "#e8eaec",
  groundOutside: "#f7f7f8",
  gridLine: "#969ca4",
  boundary: "#484e58",
  marker: "#1c5496",
  sun: 0.78,
  sky: "#ecf2ff",
  bounce: "#bebab4",
  ambient: 0.46,
  specular: 0.2,
  edges: 0.35,
  contact: 0.42,
  haloStrength: 0.55,
  haloOpacity: 1,
  text: "#1d2733",
  textContour: "rgba(255,255,255,0.85)",
  accent: "#1769d2",
};

export const kDarkLook: Look = {
  background: "#121418",
  ground: "#34383f",
  groundOutside: "#1a1c21",
  gridLine: "#68707c",
  boundary: "#b0b8c4",
  marker: "#7abeff",
  sun: 0.72,
  sky: "#d6e2ff",
  bounce: "#787c88",
  ambient: 0.36,
  specular: 0.28,
  edges: 0.3,
  contact: 0.5,
  haloStrength: 0.75,
  haloOpacity: 0.15,
  text: "#eef2f7",
  textContour: "rgba(12,14,18,0.85)",
  accent: "#6db3ff",
};
