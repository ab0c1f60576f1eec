import numpy
from scipy.stats import qmc

sets = [qmc.Halton(4, seed=seed).random(256) for seed in range(30_000)]
numpy.save("halton.npy", numpy.stack(sets))
