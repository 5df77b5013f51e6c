/** When a sensor looks next, when a signal was emitted, and the pace of a run. */
package org.dronewatch.run.time;
