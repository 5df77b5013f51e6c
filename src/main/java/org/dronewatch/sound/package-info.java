/** Acoustic quantities: octave bands, atmosphere, surfaces. */
package org.dronewatch.sound;
