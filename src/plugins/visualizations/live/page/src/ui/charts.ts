// The library of plots.

import uPlot from "uplot";

export { uPlot };
