/**
 * The level model: rays branch at surfaces, and each branch keeps the level of the arriving ray, less the loss at the
 * surface. It is the model of the master's thesis <cite>Critical Infrastructure Protection Against Attacks Using
 * Drones</cite>, Czech Technical University in Prague, 2018, on which this project is based.
 */
package org.dronewatch.sensor.acoustic.level;
