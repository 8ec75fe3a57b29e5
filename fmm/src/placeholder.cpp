// The first engine (direct sum) arrives with the kernel sums.
