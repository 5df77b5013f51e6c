/** The energy model: deterministic paths, and energy carried by random rays, in octave bands. */
package org.dronewatch.sensor.acoustic.energy;
