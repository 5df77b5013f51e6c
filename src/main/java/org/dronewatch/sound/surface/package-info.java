/** What surfaces do to sound: absorption, reflection and transmission by walls, and the impedance of the ground. */
package org.dronewatch.sound.surface;
