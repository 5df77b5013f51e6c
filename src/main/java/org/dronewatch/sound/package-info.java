/** Acoustic quantities: levels, octave bands, tones; the air; the sound of drones. */
package org.dronewatch.sound;
