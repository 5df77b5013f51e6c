/** What sound is measured in and what it meets: octave bands, air, surfaces. */
package org.dronewatch.sound;
