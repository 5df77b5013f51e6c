/** Propagation of sound: settings of the two models, and the ray types that both use. */
package org.dronewatch.sensor.acoustic.propagation;
