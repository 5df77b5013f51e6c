/** Propagation of sound: the interface of propagation models, and their common parts. */
package org.dronewatch.sensor.acoustic.propagation;
