"""Agglomerates of a wet bed: grains that hold together, from the pairs that a run has written.

A pair is listed while a force acts between its grains: they touch, or a liquid bridge joins them. In a
dense bed all grains touch some others at any moment; an agglomerate is what stays together. Its pairs
are listed in every file of a while (HELD, 50 ms: some times what a bubble needs to pass a grain).
"""

from pathlib import Path

import numpy as np

from report_read import ReportError, numbered_files

HELD = 0.05  # s


def pair_files(folder):
    return numbered_files(folder, "pairs/pairs_*.txt", "in.liggghts must have a 'compute pair/gran/local id history' and a 'dump local' of it")


def read_pairs(file):
    """(pairs of shape (n, 2), volume of the bridge [m3]; 0: they only touch), each pair once.

    The columns of the dump are the numbers of both grains and the bridge's volume."""
    lines = Path(file).read_text().splitlines()
    head = next((n for n, line in enumerate(lines) if line.startswith("ITEM: ENTRIES")), None)
    if head is None:
        raise ReportError(f"{file} is no dump of style 'local'")
    values = np.array([line.split()[:3] for line in lines[head + 1:]], dtype=float).reshape(-1, 3)
    pairs, first = np.unique(np.sort(values[:, :2].astype(int), axis=1), axis=0, return_index=True)
    return pairs, np.maximum(values[first, 2], 0.0)  # below 0: asked for, not there yet


def common(pair_lists):
    """Pairs that are in all of the lists, which are sorted."""
    keys = [pairs[:, 0].astype(np.int64) << 32 | pairs[:, 1] for pairs in pair_lists]
    kept = keys[0]
    for other in keys[1:]:
        kept = np.intersect1d(kept, other, assume_unique=True)
    return np.column_stack([kept >> 32, kept & 0xFFFFFFFF])


def clusters(count, pairs):
    """The number of its cluster for each of `count` grains (counted from 0), joined by the pairs."""
    label = np.arange(count)
    while len(pairs):
        least = np.minimum(label[pairs[:, 0]], label[pairs[:, 1]])
        before = label.copy()
        for side in (0, 1):
            np.minimum.at(label, label[pairs[:, side]], least)
            np.minimum.at(label, pairs[:, side], least)
        label = label[label]
        if np.array_equal(label, before):
            break
    return label


def sizes_of_grains(count, pairs):
    """For each grain how many grains its cluster has."""
    label = clusters(count, pairs)
    return np.bincount(label, minlength=count)[label]


class Holding:
    """What holds together at each time of a run. Grains are numbered from 1 to `count`."""

    def __init__(self, folder, count):
        files = pair_files(folder)
        every = files[1][0] - files[0][0] if len(files) > 1 else HELD
        while_ = max(1, round(HELD / every))
        read = [read_pairs(file) for _, file in files]
        lists = [pairs for pairs, _ in read]
        self.times = np.array([time for time, _ in files])
        self.bridges = np.array([np.count_nonzero(volume) for _, volume in read])
        self.volumes = [volume[volume > 0.0] for _, volume in read]
        self.sizes = []  # of each grain's cluster
        self.parted = []  # share of the pairs at the beginning of the while
        for n in range(len(files)):
            if n < while_:
                self.sizes.append(None)
                self.parted.append(np.nan)
                continue
            held = common(lists[n - while_:n + 1])
            self.sizes.append(sizes_of_grains(count, held - 1))
            self.parted.append(1.0 - len(held) / max(1, len(lists[n - while_])))
        self.parted = np.array(self.parted)

    def at(self, time):
        """Sizes at the time nearest to this one."""
        return self.sizes[int(np.argmin(np.abs(self.times - time)))]

    def of_each(self, measure):
        """A measure of the sizes at each time."""
        return np.array([np.nan if sizes is None else measure(sizes) for sizes in self.sizes])


def mean_size(sizes):
    """Mean over grains of the size of their cluster."""
    return float(np.mean(sizes))


def share_in_clusters(sizes, least=10):
    """Share of the grains in clusters of `least` or more."""
    return float(np.mean(sizes >= least))
