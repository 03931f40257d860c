// Numbers as texts.

/** 75.25 s as "1:15.2"; below a minute "15.2 s". */
export function formatTime(seconds: number, digits = 1): string {
  if (!Number.isFinite(seconds)) {
    return "–";
  }
  if (seconds < 60) {
    return `${seconds.toFixed(digits)} s`;
  }
  const minutes = Math.floor(seconds / 60);
  const rest = (seconds - 60 * minutes).toFixed(digits).padStart(digits > 0 ? 3 + digits : 2, "0");
  if (minutes < 60) {
    return `${minutes}:${rest}`;
  }
  const hours = Math.floor(minutes / 60);
  return `${hours}:${String(minutes % 60).padStart(2, "0")}:${rest}`;
}

/** A number of at most so many significant digits. */
export function formatNumber(value: number, digits = 5): string {
  if (Number.isNaN(value)) {
    return "–";
  }
  if (!Number.isFinite(value)) {
    return value > 0 ? "∞" : "−∞";
  }
  if (Number.isInteger(value) && Math.abs(value) < 1e15) {
    return String(value);
  }
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4) {
    return value.toExponential(digits - 2);
  }
  return String(+value.toPrecision(digits));
}

export function formatSpeed(speed: number): string {
  return speed === 0 ? "Max" : `${+speed.toPrecision(3)}×`;
}

export function formatBytes(bytes: number): string {
  return bytes < 1e6 ? `${(bytes / 1e3).toFixed(0)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

export function plural(count: number, word: string): string {
  return `${count.toLocaleString("en")} ${word}${count === 1 ? "" : "s"}`;
}
