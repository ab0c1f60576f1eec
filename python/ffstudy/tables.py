"""Tables as structured arrays, and as notebooks show them."""

import csv
import html
import io

import numpy

_TEXTS = {"study", "scene", "method", "sampler", "estimator", "completion", "nodes", "allocation", "from_face", "to_face",
          "pair_class", "interval_method", "std_interval_method", "gate", "quantity", "verdict"}
MOST_ROWS = 50
_MOST_COLUMNS = 20


def _is_number(field):
    try:
        float(field or "nan")
    except ValueError:
        return False
    return True


def from_csv(text):
    """A CSV text as a structured array: columns of numbers are floats (an empty field is NaN), others are texts."""
    rows = list(csv.reader(io.StringIO(text)))
    columns = []
    for name, *fields in zip(*rows) if len(rows) > 1 else [(name,) for name in rows[0]]:
        columns.append((name, numpy.array(fields, dtype=str) if name in _TEXTS or not all(map(_is_number, fields))
                        else numpy.array([float(field or "nan") for field in fields])))
    table = numpy.empty(len(rows) - 1, dtype=[(name, values.dtype) for name, values in columns])
    for name, values in columns:
        table[name] = values
    return table


def to_html(head, shown_rows, rows=None):
    """A table for notebooks; of a large one its beginning, and how large it is. `rows`: how many there are in all."""
    def line(cells, tag):
        more = [] if len(cells) <= _MOST_COLUMNS else ["…"]
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(cell))}</{tag}>" for cell in [*cells[:_MOST_COLUMNS], *more]) + "</tr>"

    shown = "".join(line(row, "td") for row in shown_rows[:MOST_ROWS])
    rows = len(shown_rows) if rows is None else rows
    size = "" if rows <= MOST_ROWS and len(head) <= _MOST_COLUMNS else f"<p>{rows} × {len(head)}</p>"
    return f"<table>{line(head, 'th')}{shown}</table>{size}"
