/** When a sensor looks next, when a signal was emitted, and how fast a run is shown. */
package org.dronewatch.run.time;
