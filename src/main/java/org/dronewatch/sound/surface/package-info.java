/**
 * Acoustic properties of surfaces: absorption, reflection and transmission by walls, and the impedance of the ground.
 */
package org.dronewatch.sound.surface;
