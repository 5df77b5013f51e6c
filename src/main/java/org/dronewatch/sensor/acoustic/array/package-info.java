/** Arrays of microphones: their gain against noise, and the accuracy of the directions that they find. */
package org.dronewatch.sensor.acoustic.array;
