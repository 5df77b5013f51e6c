/** Arrays of microphones: their gain against noise, and how accurately they find the direction of a sound. */
package org.dronewatch.sensor.acoustic.array;
