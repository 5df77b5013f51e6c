/** The level model: undivided levels along branching rays. */
package org.dronewatch.sensor.acoustic.level;
