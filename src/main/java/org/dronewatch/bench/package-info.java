/**
 * Benchmarks of the library's ray tracing in a model, with rays and hits in files, for comparison with other ray
 * tracers.
 */
package org.dronewatch.bench;
