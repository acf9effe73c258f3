tumble_kernels(sim2d)
