function floor_color() return "white" end
