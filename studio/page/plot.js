// What all plots have in common.

/** Measured values, what a material says, words. */
export const colours = { measured: '#b4472e', spread: 'rgba(180, 71, 46, 0.16)', model: '#174ea6', ink: '#6a675f' };

const font = '12px system-ui, sans-serif';

export const axis = {
  stroke: colours.ink, font, labelFont: font, labelSize: 18,
  grid: { stroke: '#e7e3d9', width: 1 }, ticks: { stroke: '#d9d5ca', width: 1 },
};

/** Series in the order: measured, its lower and upper end, the model. */
export const series = [
  {}, { stroke: colours.measured, width: 1.5, points: { show: false } }, { stroke: 'transparent', points: { show: false } },
  { stroke: 'transparent', points: { show: false } }, { stroke: colours.model, width: 1.5, points: { show: false } },
];

export const bands = [{ series: /** @type {[number, number]} */ ([3, 2]), fill: colours.spread }];
