/** False alarms of sensors: their rates, their cells, and their random draws in a run. */
package org.dronewatch.sensor.alarm;
