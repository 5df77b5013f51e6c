/**
 * The level model: undivided levels along branching rays. It is the model of the master's thesis <cite>Critical
 * Infrastructure Protection Against Attacks Using Drones</cite>, Czech Technical University in Prague, 2018, on which
 * this project is based.
 */
package org.dronewatch.sensor.acoustic.level;
