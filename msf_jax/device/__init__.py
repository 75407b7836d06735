"""The device wing: jitted, differentiable steps on padded buffers, in JAX only."""
