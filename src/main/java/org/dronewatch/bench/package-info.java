/** Benchmarks of the kernel's ray tracing in a model, with rays that other tracers can trace, too. */
package org.dronewatch.bench;
