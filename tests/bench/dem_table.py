"""The tables that dem.py writes."""

import csv

from dem_run import TASKS


def write_csv(path, rows):
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys())
        writer.writeheader()
        writer.writerows(rows)


def machine():
    """The name of the processor and the number of cores."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return f"{names[0]}, {len(names)} cores"


def millions(row, name):
    return f"{float(row[name]) / 1e6:.2f}"


def columns_of(rows):
    return list(dict.fromkeys((row["grains"], row["ranks"]) for row in rows))


def line(*cells):
    return "| " + " | ".join(map(str, cells)) + " |\n"


def grid(rows, cell):
    """A line a bed and program, a column a number of grains and of ranks."""
    columns = columns_of(rows)
    text = line("bed", "", *(f"{grains:,}, {ranks} rank{'s' * (ranks > 1)}" for grains, ranks in columns))
    text += "|---" * (2 + len(columns)) + "|\n"
    for bed, liquid, program in dict.fromkeys((row["bed"], row["liquid"], row["program"]) for row in rows):
        found = {(row["grains"], row["ranks"]): cell(row) for row in rows
                 if (row["bed"], row["liquid"], row["program"]) == (bed, liquid, program)}
        if any(found.values()):
            text += line(f"{bed}, {liquid}", program, *(found.get(column, "") for column in columns))
    return text


def middle(rows):
    """The rows of the middle number of grains on the least number of ranks."""
    numbers = sorted({row["grains"] for row in rows})
    grains, ranks = numbers[len(numbers) // 2], min(row["ranks"] for row in rows)
    return [row for row in rows if (row["grains"], row["ranks"]) == (grains, ranks)]


def speeds(row):
    return f"{millions(row, 'median')} ({millions(row, 'least')} to {millions(row, 'greatest')})"


def ratios(row):
    return ", ".join(row[name] or "-" for name in ("of_replaced", "of_stock_liggghts", "of_faster_stock_lammps")
                     ) if row["ours"] else ""


def tasks(rows):
    first = rows[0]
    text = line("bed", "", "10^6 contacts/s", *TASKS) + "|---" * (3 + len(TASKS)) + "|\n"
    for row in rows:
        text += line(f"{row['bed']}, {row['liquid']}", row["program"], millions(row, "contacts_per_s"),
                     *(f"{100 * float(row[name]):.1f} %" for name in TASKS))
    return f"{first['grains']:,} grains, {first['ranks']} rank(s): contacts and tasks\n\n" + text


def beds(rows):
    text = line("bed", "grains", "steps", "contacts a grain", "pairs in the list a grain", "lists made",
                "kinetic energy, begin", "end") + "|---" * 8 + "|\n"
    done = set()
    for row in rows:
        case = (row["bed"], row["grains"])
        if case in done:
            continue
        done.add(case)
        text += line(row["bed"], f"{row['grains']:,}", row["steps"], f"{int(row['contacts']) / row['grains']:.2f}",
                     row["neighbours_per_grain"], row["rebuilds"], f"{float(row['kinetic_energy_begin']):.3g} J",
                     f"{float(row['kinetic_energy_end']):.3g} J")
    return f"The beds, as {rows[0]['program']} ran them\n\n" + text


def markdown(rows):
    return (f"{machine()}; {rows[0]['repeats']} rounds, all programs in turn in one run.\n\n"
            "10^6 particle-steps/s, median (least to greatest)\n\n" + grid(rows, speeds) +
            "\nRatio to the style that is replaced, to stock LIGGGHTS, to the faster of stock LAMMPS's two\n\n" +
            grid(rows, ratios) + "\n" + tasks(middle(rows)) + "\n" + beds(rows))
