/** Measures how fast the kernel traces rays through a model, on rays that other tracers can trace too. */
package org.dronewatch.bench;
