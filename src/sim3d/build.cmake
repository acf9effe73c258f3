tumble_kernels(sim3d)
