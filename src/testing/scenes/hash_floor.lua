function floor_color(x, y)
  return math.floor(4 * x + 3 * y) % 2 == 0 and "gray30" or "orange"
end
