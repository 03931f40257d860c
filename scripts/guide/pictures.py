"""Pictures and films of the guide's pages: made from what a page's commands have written, and compared with it.

Both pictures are reduced to 40 x 30 cells, and their colours are compared, 0 to 255 for red, green and blue:

- the mean difference of all cells must be at most MEAN: the picture as a whole;
- the difference of each cell must be at most CELL: a robot, a wall or a line that is elsewhere.

Renderers and fonts that differ between systems change a cell by less. Of a film, the pictures at five times are compared.
"""
import pathlib
import subprocess

MEAN, CELL = 3.0, 48
CELLS = (40, 30)
TIMES = (0.0, 0.25, 0.5, 0.75, 0.95)  # parts of a film's duration
MAX_PICTURE, MAX_FILM = 150_000, 1_000_000  # bytes
FILMS = (".gif", ".mp4", ".webm")
# one palette for all pictures: a third of the size of a GIF with a palette for each picture
RATE = 5  # pictures a second of the pages' films
GIF = (f"fps={RATE},scale=320:-2:flags=area,split[a][b];[a]palettegen=max_colors=64[p];"
       "[b][p]paletteuse=dither=none:diff_mode=rectangle")
PNG = "scale='min(960,iw)':-2:flags=area,split[a][b];[a]palettegen=max_colors=200[p];[b][p]paletteuse=dither=none"


class PictureError(Exception):
    pass


def run(*command):
    result = subprocess.run(command, capture_output=True, timeout=120, check=False)
    if result.returncode != 0:
        raise PictureError(f"{' '.join(map(str, command))}: {result.stderr.decode(errors='replace')}")
    return result.stdout


def duration(film):
    """s; 0 of a picture."""
    if film.suffix not in FILMS:
        return 0.0
    return float(run("ffprobe", "-v", "error", "-show_entries", "format=duration", "-of", "csv=p=0", film))


def cells(picture, number):
    """Bytes of red, green and blue of each cell, by rows; of a film, of the picture with this number, RATE a second."""
    chosen = f"fps={RATE},select=eq(n\\,{number})," if picture.suffix in FILMS else ""
    return run("ffmpeg", "-v", "error", "-i", picture, "-vf",
               f"{chosen}scale={CELLS[0]}:{CELLS[1]}:flags=area,format=rgb24", "-frames:v", "1", "-f", "rawvideo", "-")


def compare(first, second):
    """@return the mean and the largest difference of the cells."""
    if len(first) != len(second) or len(first) != 3 * CELLS[0] * CELLS[1]:
        raise PictureError("a picture cannot be read")
    differences = [abs(a - b) for a, b in zip(first, second)]
    return sum(differences) / len(differences), max(differences)


def check(made, shown):
    """Throws if the pictures differ, or if the page's is too large."""
    for picture in (made, shown):
        if not picture.is_file():
            raise PictureError(f"there is no picture {picture}")
    most = MAX_FILM if shown.suffix in FILMS else MAX_PICTURE
    if shown.stat().st_size > most:
        raise PictureError(f"{shown.name} has more than {most} bytes")
    lengths = duration(made), duration(shown)
    if abs(lengths[0] - lengths[1]) > 0.3:
        raise PictureError(f"{shown.name} takes {lengths[1]} s, what the commands have made {lengths[0]} s")
    for part in TIMES if lengths[0] > 0.0 else (0.0,):
        number = int(part * lengths[0] * RATE)
        mean, largest = compare(cells(made, number), cells(shown, number))
        if mean > MEAN or largest > CELL:
            raise PictureError(f"{shown.name} is not what the commands have made: differences of {mean:.1f} in the mean and "
                               f"{largest} in a cell, more than {MEAN} or {CELL}; scripts/check_guide.sh --pictures makes it again")


def make(made, shown):
    """Makes the page's picture."""
    shown.parent.mkdir(parents=True, exist_ok=True)
    run("ffmpeg", "-y", "-v", "error", "-i", made, "-vf", GIF if made.suffix in FILMS else PNG, shown)
